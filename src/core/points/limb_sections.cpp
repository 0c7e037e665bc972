// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/points/limb_sections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace pcl_msf {

namespace {

constexpr int kSectors = 24;

/** A cross-section in polar coordinates. */
struct Section {
  std::array<double, kSectors> radius{}; ///< mean
  std::array<int, kSectors> points{};

  void
  add (double u, double v)
  {
    const double turn = 0.5 + std::atan2 (v, u) / (2.0 * M_PI);
    const int sector = std::min (kSectors - 1, static_cast<int> (turn * kSectors));
    radius[sector] += std::hypot (u, v);
    ++points[sector];
  }
  /** Of its area. \return is it a tube's? \param least share of the sectors with
   * points */
  bool
  center (double least, Eigen::Vector2d& center) const
  {
    int filled = 0;
    double area = 0.0;
    center.setZero();
    for (int k = 0; k < kSectors; ++k) {
      if (points[k] == 0)
        continue;
      ++filled;
      const double r = radius[k] / points[k];
      const double a = (k + 0.5) * 2.0 * M_PI / kSectors - M_PI;
      area += 0.5 * r * r;
      center += r * r * r / 3.0 * Eigen::Vector2d (std::cos (a), std::sin (a));
    }
    center /= std::max (area, 1e-300);
    return filled >= least * kSectors;
  }
};

/** A limb's points across and along it, from a place. */
struct LimbPoints {
  std::vector<Eigen::Vector2d> across;
  std::vector<double> along; ///< positive on the side of its centroid

  double
  meanRadius () const
  {
    double sum = 0.0;
    for (const auto& p : across)
      sum += p.norm();
    return sum / static_cast<double> (std::max<std::size_t> (1, across.size()));
  }
};

LimbPoints
pointsOf (const Surface& surface,
          const std::vector<int>& whole,
          int limb,
          const Eigen::Vector3d& from,
          const Eigen::Matrix3d& frame)
{
  LimbPoints points;
  double sum = 0.0;
  for (int i = 0; i < surface.size(); ++i) {
    if (whole[i] != limb)
      continue;
    const Eigen::Vector3d d =
        frame.transpose() * (surface.points[i].cast<double>() - from);
    points.across.emplace_back (d.x(), d.y());
    points.along.push_back (d.z());
    sum += d.z();
  }
  for (double& z : points.along)
    z = sum < 0.0 ? -z : z;
  return points;
}

} // namespace

std::vector<SurfaceSeam>
bodySeams (const Surface& surface,
           const std::vector<int>& part,
           const std::vector<char>& body,
           std::vector<int>& whole)
{
  whole.assign (part.size(), -1);
  std::vector<int> front;
  for (int i = 0; i < surface.size(); ++i)
    if (body[part[i]]) {
      whole[i] = part[i];
      front.push_back (i);
    }
  while (!front.empty()) { // a step along the surface after the other
    std::vector<int> next;
    for (const int i : front)
      for (const SurfaceEdge* e = surface.graph.begin (i); e != surface.graph.end (i);
           ++e)
        if (whole[e->to] < 0) {
          whole[e->to] = whole[i];
          next.push_back (e->to);
        }
    front = std::move (next);
  }
  std::set<std::pair<int, int>> touching;
  for (const SurfaceSeam& seam : seamsBetween (surface, part))
    touching.emplace (seam.first, seam.second);
  std::vector<SurfaceSeam> seams;
  for (const SurfaceSeam& seam : seamsBetween (surface, whole))
    if (touching.count ({seam.first, seam.second}) > 0)
      seams.push_back (seam);
  return seams;
}

Eigen::Vector3d
sectionCenter (const Surface& surface,
               const std::vector<int>& whole,
               int limb,
               const SurfaceSeam& seam,
               const Eigen::Vector3d& along,
               const LimbSectionTuning& tuning)
{
  Eigen::Matrix3d frame;
  frame.col (2) = along;
  frame.col (0) = along.unitOrthogonal();
  frame.col (1) = along.cross (frame.col (0));
  const LimbPoints points = pointsOf (surface, whole, limb, seam.center, frame);
  const double radius = points.meanRadius();
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (int round = 0; round < tuning.rounds; ++round) {
    Section section;
    for (std::size_t i = 0; i < points.across.size(); ++i)
      if (points.along[i] > tuning.from * radius &&
          points.along[i] < tuning.to * radius)
        section.add (points.across[i].x() - center.x(),
                     points.across[i].y() - center.y());
    Eigen::Vector2d shift;
    if (!section.center (tuning.filled, shift))
      return seam.center;
    center += shift;
  }
  return seam.center + frame.leftCols<2>() * center;
}

} // namespace pcl_msf
