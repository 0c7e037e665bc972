// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/pcd_blob.h"

#include "io/base/classic_locale.h"
#include "io/base/pcl_io.h"
#include <pcl_msf/errors.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace pcl_msf::io {

namespace {

namespace fs = std::filesystem;

/** A file under a name by which PCL takes it for a .pcd file, from its header on: its
 * own, or that of a copy for as long as this is there. */
class PcdFile {
public:
  PcdFile (const std::string& path, int begin) : name_ (path)
  {
    if (begin == 0 && fs::path (path).extension() == ".pcd")
      return;
    std::error_code none;
    const fs::path folder = fs::temp_directory_path (none);
    name_ = (folder / "pcl_msf_XXXXXX.pcd").string();
    const int file = none ? -1 : mkstemps (name_.data(), 4);
    copied_ = file >= 0;
    if (copied_)
      ::close (file);
    if (copied_ && !copy (path, begin)) {
      fs::remove (name_, none);
      copied_ = false;
    }
    if (!copied_)
      throw IoError (path + ": points: cannot be copied to " + name_ +
                     "; name the file .pcd, save it without a byte order mark");
  }
  ~PcdFile()
  {
    std::error_code ignored;
    if (copied_)
      fs::remove (name_, ignored);
  }
  PcdFile (const PcdFile&) = delete;
  PcdFile&
  operator= (const PcdFile&) = delete;

  const std::string&
  name () const
  {
    return name_;
  }

private:
  bool
  copy (const std::string& path, int begin) const
  {
    std::ifstream from (path, std::ios::binary);
    std::ofstream to (name_, std::ios::binary);
    from.seekg (begin);
    to << from.rdbuf();
    return from.good() && to.flush().good();
  }

  std::string name_;
  bool copied_{false};
};

} // namespace

pcl::PCLPointCloud2
readPcd (const std::string& path, Viewpoint* viewpoint, PcdShape shape)
{
  const PcdHead head = checkPcdHeader (path, shape);
  pcl::PCLPointCloud2 blob;
  const PcdFile file (path, head.begin);
  const ClassicLocale classic;
  const bool read = readByPcl (file.name(), blob);
  const bool whole =
      blob.data.size() == std::size_t{blob.width} * blob.height * blob.point_step;
  if (!read || !whole)
    throw IoError (path + ": points: PCL cannot read them; the file is damaged");
  if (viewpoint)
    *viewpoint = head.viewpoint;
  return blob;
}

} // namespace pcl_msf::io
