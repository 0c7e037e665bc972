// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include <pcl_msf/io/point_files.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/synthetic/body_clouds.h>

#include <cmath>
#include <initializer_list>

namespace pcl_msf::synthetic {
namespace {

/** Numbers with a blank between them. */
std::string
lineOf (std::initializer_list<double> numbers)
{
  std::string text;
  for (const double number : numbers)
    text += (text.empty() ? "" : " ") + generalText (number, 12);
  return text;
}

std::string
posesText (const BodyClouds& clouds)
{
  std::string text;
  for (const RigidPose& pose : clouds.poses) {
    const Eigen::Matrix3d r = pose.rotation();
    const Eigen::Vector3d t = pose.translation();
    for (int i = 0; i < 3; ++i)
      text += lineOf ({r (i, 0), r (i, 1), r (i, 2), t[i]}) + ' ';
    text += "0 0 0 1\n";
  }
  return text;
}

std::string
jointsText (const BodyClouds& clouds)
{
  std::string text;
  for (const BodyJoint& j : clouds.joints)
    text += std::to_string (j.child) + ' ' + std::to_string (j.parent) + ' ' +
            lineOf ({j.axis.x(),
                     j.axis.y(),
                     j.axis.z(),
                     j.angle * 180.0 / M_PI,
                     j.point.x(),
                     j.point.y(),
                     j.point.z()}) +
            '\n';
  return text;
}

} // namespace

void
writeBody (const BodyClouds& clouds, const std::string& folder)
{
  io::writePointsPly (folder + "/source.ply", clouds.source);
  io::writePointsPly (folder + "/target.ply", clouds.target);
  io::writePointsPly (folder + "/truth.ply", clouds.truth);
  std::string labels;
  for (const int link : clouds.link)
    labels += std::to_string (link) + '\n';
  io::writeText (folder + "/labels.txt", labels);
  io::writeText (folder + "/poses.txt", posesText (clouds));
  io::writeText (folder + "/joints.txt", jointsText (clouds));
}

} // namespace pcl_msf::synthetic
