// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include <pcl_msf/build_compatibility.h>
#include <pcl_msf/cloud_flow.h>
#include <pcl_msf/export.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief The points of a file, whatever their order. */
struct PointFile {
  std::vector<Eigen::Vector3f> points; ///< as in the file; NaN = no point
  std::vector<std::uint32_t> colors; ///< 0xRRGGBB per point; empty when there are none
};

/** \brief Brightness of the colours, [0, 1], as CloudBrightness takes it; empty when
 * there are none. */
PCL_MSF_EXPORT std::vector<float>
brightnessOf (const PointFile& file);

/** \brief Reads the points of a .pcd, .ply (ascii or binary) or .obj file; of the last
 * two the vertices. Fields other than x y z and colours are ignored; a .pcd's are those
 * of readOrganizedCloud, an .obj's the three numbers behind x y z, 0 to 1 or 0 to 255.
 * \throws IoError */
PCL_MSF_EXPORT PointFile
readPoints (const std::string& path);

/** \brief Writes a binary .ply of points, x y z as float32. \throws IoError */
PCL_MSF_EXPORT void
writePointsPly (const std::string& path, const std::vector<Eigen::Vector3f>& points);

/** \brief Writes a result as a binary .pcd: the moved points `x y z`, their `rgb`, the
 * motion `dx dy dz`, `part` (-1 = none) and `confidence`; NaN where unknown.
 * \param source as given to the estimator \throws IoError */
PCL_MSF_EXPORT void
writeRegisteredCloud (const std::string& path,
                      const CloudFlow& flow,
                      const PointFile& source);

/** \brief What writeRegisteredCloud wrote. */
struct RegisteredCloud {
  std::vector<Eigen::Vector3f> source; ///< NaN where the motion is unknown
  std::vector<Eigen::Vector3f> warped; ///< likewise
  std::vector<int> part;               ///< -1 = none
};

/** \throws IoError */
PCL_MSF_EXPORT RegisteredCloud
readRegisteredCloud (const std::string& path);

/** \brief Reads what writeJoints wrote. \throws IoError */
PCL_MSF_EXPORT std::vector<CloudJoint>
readJoints (const std::string& path);

/** \brief Writes joints as JSON: parent, child, axis, angle_deg, point, shift and
 * deviations. \throws IoError */
PCL_MSF_EXPORT void
writeJoints (const std::string& path, const CloudFlow& flow);

/** \brief Writes the report of a cloud's registration as JSON, with the fields of
 * writeReport as far as they mean something here. \throws IoError */
PCL_MSF_EXPORT void
writeCloudReport (const std::string& path,
                  const CloudFlow& flow,
                  double load_seconds,
                  double total_seconds);

} // namespace pcl_msf::io
