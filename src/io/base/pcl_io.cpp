// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/pcl_io.h"

#include <pcl/io/auto_io.h>
#include <pcl/io/lzf.h>

#include "core/base/lazy_library.h"

#include <exception>

namespace pcl_msf::io {

bool
readByPcl (const std::string& path, pcl::PCLPointCloud2& cloud)
{
#ifdef PCL_MSF_PCL_IO_FILES
  static auto* const load =
      loadFunction<int (const std::string&, pcl::PCLPointCloud2&)> (
          {PCL_MSF_PCL_IO_FILES},
          "_ZN3pcl2io4loadERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEERNS_"
          "14PCLPointCloud2E");
#else
  constexpr int (*load) (const std::string&, pcl::PCLPointCloud2&) = pcl::io::load;
#endif
  try {
    return load (path, cloud) >= 0;
  }
  catch (const std::exception&) {
    return false;
  }
}

bool
unpackByPcl (const std::vector<char>& from, std::vector<char>& to)
{
  const auto packed = static_cast<unsigned> (from.size());
  const auto unpacked = static_cast<unsigned> (to.size());
#ifdef PCL_MSF_PCL_IO_FILES
  static auto* const unpack =
      loadFunction<unsigned (const void*, unsigned, void*, unsigned)> (
          {PCL_MSF_PCL_IO_FILES}, "_ZN3pcl13lzfDecompressEPKvjPvj");
  return unpack (from.data(), packed, to.data(), unpacked) == unpacked;
#else
  return pcl::lzfDecompress (from.data(), packed, to.data(), unpacked) == unpacked;
#endif
}

} // namespace pcl_msf::io
