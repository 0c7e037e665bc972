// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/pcd_blob.h"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include "io/base/classic_locale.h"
#include <pcl_msf/errors.h>

#include <exception>

namespace pcl_msf::io {

pcl::PCLPointCloud2
readPcd (const std::string& path, Viewpoint* viewpoint, PcdShape shape)
{
  const int begin = checkPcdHeader (path, shape);
  pcl::PCLPointCloud2 blob;
  Eigen::Vector4f t = Eigen::Vector4f::Zero();
  Eigen::Quaternionf q = Eigen::Quaternionf::Identity();
  int status = -1;
  try {
    const ClassicLocale classic;
    int version = 0;
    status = pcl::PCDReader().read (path, blob, t, q, version, begin);
  }
  catch (const std::exception&) {
    status = -1;
  }
  const bool whole =
      blob.data.size() == std::size_t{blob.width} * blob.height * blob.point_step;
  if (status < 0 || !whole)
    throw IoError (path + ": points: PCL cannot read them; the file is damaged");
  if (viewpoint)
    *viewpoint = {{t.x(), t.y(), t.z()}, {q.w(), q.x(), q.y(), q.z()}};
  return blob;
}

} // namespace pcl_msf::io
