// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include "core/points/limb_sections.h"
#include "core/surface/surface.h"
#include <pcl_msf/cloud_flow_estimator.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace pcl_msf;

/** A tube along x from 0 to 2, with an oval section about y = 0.3, z = -0.1; points lie
 * more densely on one side. */
std::vector<Eigen::Vector3f>
tube ()
{
  std::mt19937 random (7);
  const auto uniform = [&random] { return random() / 4294967296.0; };
  std::vector<Eigen::Vector3f> points;
  while (points.size() < 6000) {
    const double a = 2.0 * M_PI * uniform();
    if (std::cos (a) > 0.0 || uniform() < 0.5)
      points.push_back (Eigen::Vector3d (2.0 * uniform(),
                                         0.3 + 0.2 * std::cos (a),
                                         -0.1 + 0.12 * std::sin (a))
                            .cast<float>());
  }
  return points;
}

/** Parts of a tube: 0 and 1 meet at x = 1 on one side, at x = 1.1 on the other; there a
 * scrap, 2, fills what is between. */
std::vector<int>
parts (const Surface& surface)
{
  std::vector<int> part;
  for (const auto& p : surface.points)
    part.push_back (p.x() < 0.95F                   ? 0
                    : p.y() < 0.3F && p.x() < 1.05F ? 2
                    : p.x() < 1.0F                  ? 0
                                                    : 1);
  return part;
}

TEST (LimbSections, ScrapsGoWithTheBodiesBesideThem)
{
  const Surface surface = makeSurface (tube(), {}, 1);
  std::vector<int> whole;
  const std::vector<SurfaceSeam> seams =
      bodySeams (surface, parts (surface), {1, 1, 0}, whole);
  ASSERT_EQ (seams.size(), 1u);
  EXPECT_EQ (seams[0].first, 0);
  EXPECT_EQ (seams[0].second, 1);
  EXPECT_EQ (std::count (whole.begin(), whole.end(), 2), 0);
  EXPECT_NEAR (seams[0].center.x(), 1.0, 0.03);
  const auto raw = seamsBetween (surface, parts (surface));
  EXPECT_GT (std::abs (raw[0].center.y() - 0.3), 0.05) << "of one side alone";
}

TEST (LimbSections, TheMiddleDoesNotDependOnDensity)
{
  const Surface surface = makeSurface (tube(), {}, 1);
  std::vector<int> whole;
  const SurfaceSeam seam =
      bodySeams (surface, parts (surface), {1, 1, 0}, whole).front();
  for (const int limb : {0, 1}) {
    const Eigen::Vector3d center =
        sectionCenter (surface, whole, limb, seam, Eigen::Vector3d::UnitX(), {});
    EXPECT_NEAR (center.x(), seam.center.x(), 1e-9);
    EXPECT_NEAR (center.y(), 0.3, 2e-3);
    EXPECT_NEAR (center.z(), -0.1, 2e-3);
  }
}

TEST (LimbSections, ASheetHasNone)
{
  std::vector<Eigen::Vector3f> points;
  for (float x = 0.0F; x < 2.0F; x += 0.03F)
    for (float y = 0.0F; y < 1.0F; y += 0.03F)
      points.emplace_back (x, y, 0.0F);
  const Surface surface = makeSurface (points, {}, 1);
  std::vector<int> part;
  for (const auto& p : surface.points)
    part.push_back (p.x() < 1.0F ? 0 : 1);
  std::vector<int> whole;
  const SurfaceSeam seam = bodySeams (surface, part, {1, 1}, whole).front();
  EXPECT_EQ (sectionCenter (surface, whole, 0, seam, Eigen::Vector3d::UnitX(), {}),
             seam.center);
}

} // namespace
