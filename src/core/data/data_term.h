// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/data_tuning.h"
#include "core/data/data_kernel.h"
#include "core/motion/flow_evidence.h"
#include "core/motion/motion_state.h"
#include "core/segments/segment_pixels.h"
#include <pcl_msf/parameters.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl_msf {

/** \brief What a segment's points say about its pose at the point of linearization. */
struct SegmentQuadratic {
  Matrix6 information{Matrix6::Zero()}; ///< A = sum w J' J, pose parameters
  Vector6 gradient{Vector6::Zero()};    ///< b = sum w J' r
  double brightness_cost{0.0};
  double icp_cost{0.0};
  double flow_cost{0.0}; ///< of optical flow, at coarse levels
  double
  cost () const
  {
    return brightness_cost + icp_cost + flow_cost;
  }
};

/** \brief Loss and weights of the data terms, normalized by their residual counts. */
kernel::Rules
makeRules (const EnergyParameters& energy,
           const SegmentPixels& pixels,
           const MissingTuning& tuning);

/** \brief Energy times this = sum of half squared deviations over independent
 * residuals. */
double
residualScale (const EnergyParameters& energy, const SegmentPixels& pixels);

/** \brief The frame's level as the kernels read it: intensity and inverse depth. */
class Texture {
public:
  explicit Texture (const FrameLevel& level);
  kernel::Image
  image () const;

  /** \brief Takes some share of an image's off its intensities. */
  void
  subtract (const cv::Mat& image, float share, int threads);

private:
  cv::Mat texels_; ///< CV_32FC2
  PinholeCamera camera_;
};

/** \brief Brightness and projective ICP terms (Eq. 6 to 9) of one pair of frames on one
 * level: one sweep over all points, parallel over segments.
 *
 * Deterministic: each segment is summed by one thread, in raster order.
 */
class DataTerm {
public:
  /** Both linearize. The first finds correspondences; the second, for checking it,
   * keeps those of the last time and works in double precision. */
  enum class Pass { Linearize, LinearizeKeptInDouble };

  DataTerm (const SegmentPixels& pixels,
            const Texture& texture,
            const kernel::Rules& rules,
            int threads);

  /** \brief Weighs optical flow, too. \param flow must outlive the term
   * \param residual a mean residual's share of the energy
   * \param solving residuals that a segment's flow is worth in sweeps */
  void
  setFlow (const FlowEvidence& flow, double residual, double solving)
  {
    flow_ = &flow;
    residual_ = residual;
    solving_ = solving;
  }

  void
  dropFlow ()
  {
    flow_ = nullptr;
    solving_ = 0.0;
  }

  /** \brief Evaluates all segments at a state's poses. A segment is not linearized
   * again at the pose where it was last, as long as its points weigh the same. */
  void
  sweep (const MotionState& state, Pass pass);

  /** \brief The points have got other scales: the last sums no longer hold. */
  void
  forget ()
  {
    std::fill (holds_.begin(), holds_.end(), Holds::Nothing);
  }

  /** \brief Keeps all segments' sums ... */
  void
  rememberSums ()
  {
    remembered_ = quadratics_;
    remembered_at_ = frozen_;
  }
  /** \brief ... and takes a segment back to them: its pose and sums, not its points'
   * correspondences. */
  void
  recallSums (int segment)
  {
    quadratics_[segment] = remembered_[segment];
    frozen_[segment] = remembered_at_[segment];
    holds_[segment] = Holds::Sums;
  }
  /** \brief Lets the next sweep renew the segments that were taken back. */
  void
  completeSums ()
  {
    std::replace (holds_.begin(), holds_.end(), Holds::Sums, Holds::Nothing);
  }

  const SegmentQuadratic&
  of (int segment) const
  {
    return quadratics_[segment];
  }

  const SegmentPixels&
  pixels () const
  {
    return pixels_;
  }

  /** \brief Pose at which a segment's correspondences were found: its rotation carries
   * the reference's normals. */
  const RigidPose&
  frozenPose (int segment) const
  {
    return frozen_[segment];
  }

  /** \brief Sums of kernel's bits (kBrightness, ...) per point. */
  const std::vector<std::uint8_t>&
  active () const
  {
    return active_;
  }
  const std::vector<float>&
  planeOffsets () const
  {
    return plane_offset_;
  }
  const kernel::Rules&
  rules () const
  {
    return rules_;
  }
  /** \brief Weighs by other rules from the next sweep on. */
  void
  setRules (const kernel::Rules& rules)
  {
    rules_ = rules;
    forget();
  }
  kernel::Image
  image () const
  {
    return image_;
  }

  int
  threads () const
  {
    return threads_;
  }

  /** \brief What a pose would cost. */
  struct Probe {
    double cost{0.0};   ///< truncated; share of the energy
    double flow{0.0};   ///< likewise, of optical flow worth one residual; not in cost
    double hidden{0.0}; ///< share of the residuals that are hidden, [0, 1]
    double weight{0.0}; ///< of all residuals; cost / weight is the mean per residual
  };

  /** \brief Truncated cost of a segment at a pose, with fresh visibility.
   * Thread-safe. */
  Probe
  probe (int segment, const UnpackedPose& pose) const;

  /** \brief Weight of all residuals of a segment. */
  double
  totalWeight (int segment) const
  {
    return pixels_.pixels (segment) *
           ((pixels_.brightness_count > 0 ? rules_.brightness_weight : 0.0) +
            (pixels_.icp_count > 0 ? rules_.icp_weight : 0.0));
  }

  /** \brief What a hidden residual costs more when no visible neighbour shares the
   * pose.
   */
  double
  isolatedHiddenCost () const
  {
    return rules_.conflict_cost - rules_.occluded_cost;
  }

private:
  enum class Holds : char { Nothing, Sums, All };

  kernel::Points
  points (int segment) const;
  void
  evaluate (int segment, const RigidPose& pose, Pass pass);

  const SegmentPixels& pixels_;
  const FlowEvidence* flow_{nullptr};
  double residual_{0.0};
  double solving_{0.0};
  kernel::Image image_;
  kernel::Rules rules_;
  int threads_;
  std::vector<float> plane_offset_;
  std::vector<std::uint8_t> active_;
  std::vector<RigidPose> frozen_; ///< per segment, pose of the last renewal
  std::vector<SegmentQuadratic> quadratics_;
  std::vector<SegmentQuadratic> remembered_;
  std::vector<RigidPose> remembered_at_;
  std::vector<Holds> holds_; ///< per segment: at its frozen pose
};

} // namespace pcl_msf
