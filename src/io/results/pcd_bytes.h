// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/io/pcd_io.h>

#include "io/base/classic_locale.h"

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace pcl_msf::io {

/** \brief A cloud as the bytes of a binary .pcd file, the same that
 * pcl::PCDWriter::writeBinary writes: PCL's header, then the fields of each point
 * without what lies between them. PCL's own function would need libpcl_io, which takes
 * 0.1 s of a program's start. */
template <typename PointT>
std::string
pcdBytes (const pcl::PointCloud<PointT>& cloud)
{
  struct Field {
    std::size_t offset, size;
  };
  std::vector<Field> fields;
  std::size_t point_size = 0;
  for (const pcl::PCLPointField& field : pcl::getFields<PointT>())
    if (field.name != "_") {
      const auto size =
          static_cast<std::size_t> (pcl::getFieldSize (field.datatype)) * field.count;
      fields.push_back ({field.offset, size});
      point_size += size;
    }
  const ClassicLocale classic;
  std::string bytes = pcl::PCDWriter::generateHeader (cloud) + "DATA binary\n";
  std::size_t at = bytes.size();
  bytes.resize (at + point_size * cloud.size());
  for (const PointT& point : cloud)
    for (const Field& field : fields) {
      std::memcpy (&bytes[at],
                   reinterpret_cast<const char*> (&point) + field.offset,
                   field.size);
      at += field.size;
    }
  return bytes;
}

} // namespace pcl_msf::io
