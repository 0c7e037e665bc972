// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/pcd_blob.h"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include "io/classic_locale.h"
#include "io/pcd_header.h"
#include <pcl_msf/errors.h>

#include <exception>

namespace pcl_msf::io {

pcl::PCLPointCloud2
readPcd (const std::string& path)
{
  const int begin = checkPcdHeader (path);
  pcl::PCLPointCloud2 blob;
  int status = -1;
  try {
    const ClassicLocale classic;
    status = pcl::PCDReader().read (path, blob, begin);
  }
  catch (const std::exception&) {
    status = -1;
  }
  const bool whole =
      blob.data.size() == std::size_t{blob.width} * blob.height * blob.point_step;
  if (status < 0 || !whole)
    throw IoError (path + ": points: PCL cannot read them; the file is damaged");
  return blob;
}

} // namespace pcl_msf::io
