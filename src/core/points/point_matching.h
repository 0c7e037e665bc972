// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/deformation.h"
#include "core/points/isometry.h"
#include "core/points/point_brightness.h"
#include "core/surface/point_tree.h"

#include <vector>

namespace pcl_msf {

/** \brief What pulls at a sample: 1/2 x' a x - b' x + c over where it is moved to. */
struct PointPull {
  Eigen::Matrix3d a{Eigen::Matrix3d::Zero()};
  Eigen::Vector3d b{Eigen::Vector3d::Zero()};
  double c{0.0};
  double weight{0.0}; ///< of all that was added

  /** \brief Adds share/2 ((n'(x-q))^2 + isotropy |x-q|^2). */
  void
  add (const Eigen::Vector3d& q,
       const Eigen::Vector3d& n,
       double share,
       double isotropy);

  /** \brief Adds share/2 (slope'(x-q) + value)^2. */
  void
  addSlope (const Eigen::Vector3d& q,
            const Eigen::Vector3d& slope,
            double value,
            double share);
};

/** \brief How points are matched. Lengths in the unit of the points. */
struct MatchRules {
  double distance{0.1};      ///< scale of the robust weight
  double plane{0.0};         ///< of another one on the distance to the plane; 0 = none
  double normal_length{0.1}; ///< what a difference of normals of 1 counts as
  double isotropy{0.0};      ///< share of point-to-point in point-to-plane
  double least{0.0};         ///< robust weight of a tight pair
  double mutual{0.0};        ///< scale of the way there and back; 0 = unused
  double backward{1.0};      ///< weight of the target's points' own matches
  bool borders{false};       ///< may a match lie on the target's border?
  double brightness{0.0};    ///< a difference of brightness that is this far along the
                             ///< texture's slope may be a distance; 0 = not compared
  double brightness_weight{1.0}; ///< of such a difference, squared, beside a distance
  double outlying{2.5};          ///< deviations: scale of its robust weight
};

/** \brief Which points of two clouds lie on the other one. */
struct Coverage {
  std::vector<char> moved;
  std::vector<char> samples;

  double
  movedShare () const
  {
    return shareOf (moved);
  }
  double
  samplesShare () const
  {
    return shareOf (samples);
  }

private:
  static double
  shareOf (const std::vector<char>& flags);
};

/** \brief Points with normals, searched by both. */
class FeatureTree {
public:
  /** \brief Takes points, or the same ones moved. \param normal_length what a
   * difference of normals of 1 counts as */
  void
  take (const std::vector<Eigen::Vector3f>& points,
        const std::vector<Eigen::Vector3f>& normals,
        double normal_length);

  /** \brief The nearest one's index. \param hint one that may be near, -1 = none */
  int
  nearest (const Eigen::Vector3f& point, const Eigen::Vector3f& normal, int hint) const;

private:
  PointTree tree_;
  std::vector<float> rows_;
  double normal_length_{0.0};
  double divided_at_{0.0}; ///< length of normals when the tree was built
};

/** \brief The target's points as seen by matching. It remembers matches: the next
 * search begins at them. For one thread at a time. */
class MatchTarget {
public:
  /** \param samples points that look for matches themselves */
  MatchTarget (const Surface& surface,
               std::vector<int> samples,
               const SurfaceTexture& texture)
  : surface_ (surface), samples_ (std::move (samples)), texture_ (texture)
  {}

  /** \brief What pulls at every sample. Each has a share of 1 of all weights at most
   * from either side. What the rules say of brightness holds from then on. */
  std::vector<PointPull>
  pulls (const MovedPoints& moved, const MatchRules& rules, int threads);

  /** \brief Correlation of brightness between the moved points and their matches in the
   * last pulls; 0 when it was not compared. */
  double
  brightnessAgreement () const
  {
    return brightness_.correlation();
  }

  /** \brief Shares of the moved points and of the target's samples that have a match.
   * \param weights of the moved points, may be empty */
  std::pair<double, double>
  explained (const MovedPoints& moved,
             const MatchRules& rules,
             const std::vector<float>& weights,
             int threads);

  /** \brief Per moved point, how far it is from the plane at its match, and from where
   * it would be as bright, if the rules say so and pulls were asked for: `most` when it
   * has no match, is farther from it than that, or does not face it. */
  std::vector<float>
  distances (const MovedPoints& moved,
             const MatchRules& rules,
             double most,
             int threads);

  /** \brief The moved points, and the target's samples, that have one of the others
   * within the distance that faces them. */
  Coverage
  covered (const MovedPoints& moved, const MatchRules& rules, double most, int threads);

  /** \brief Pairs that are each other's nearest, within the distance and facing. */
  std::vector<PointPair>
  tightPairs (const MovedPoints& moved, const MatchRules& rules, int threads);

private:
  void
  prepare (const MovedPoints& moved, double normal_length, bool both_ways);
  int
  forwardMatch (const MovedPoints& moved, int i);
  int
  backwardMatch (int sample);
  double
  weight (const MovedPoints& moved, int i, int j, const MatchRules& rules) const;
  void
  pullByBrightness (const MovedPoints& moved,
                    const std::vector<PointPair>& matches,
                    const MatchRules& rules,
                    std::vector<PointPull>& pulls);
  template <typename Value, typename Score>
  std::pair<std::vector<Value>, std::vector<Value>>
  scores (const MovedPoints& moved,
          const MatchRules& rules,
          int threads,
          const Score& score);

  const Surface& surface_;
  std::vector<int> samples_; ///< points that look for matches themselves
  const SurfaceTexture& texture_;
  BrightnessComparison brightness_; ///< by the last pulls
  FeatureTree tree_;                ///< of the surface
  double normal_length_{-1.0};      ///< in that tree
  FeatureTree moved_tree_;
  std::vector<int> forward_;  ///< last match per moved point
  std::vector<int> backward_; ///< and per sample
};

} // namespace pcl_msf
