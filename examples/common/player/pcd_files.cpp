// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/pcd_grabber.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include "common/command_line.h"
#include "common/player/cloud_images.h"
#include "common/player/grabbed_files.h"
#include "io/base/classic_locale.h"
#include "io/base/folder_files.h"
#include "io/base/input_file.h"
#include "io/base/pcd_header.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

using Load = std::function<io::RgbdImages (std::size_t)>;

/** Empty when PCDGrabber can read it. */
std::string
problemOf (const std::string& file)
{
  try {
    if (io::checkPcdHeader (file, io::PcdShape::Image).begin > 0)
      return file + ": begins with a byte order mark, which PCL's PCDGrabber cannot "
                    "read; save it as plain ASCII";
  }
  catch (const IoError& e) {
    return e.what();
  }
  return {};
}

/** By the grabber of those files, with points of that type. */
template <typename PointT>
Load
loadAs (const std::vector<std::string>& files, const PlayerSettings& settings)
{
  const auto grabber = std::make_shared<const pcl::PCDGrabber<PointT>> (files);
  std::optional<PinholeCamera> camera = settings.reading.camera;
  if (const auto known = cameraBeside (settings); known && !camera)
    camera = known->camera;
  const auto images = std::make_shared<CloudImages> (
      camera, settings.reading.depth_scale.value_or (1.0));
  return [grabber, images] (std::size_t k) { return images->convert (*(*grabber)[k]); };
}

/** All clouds are read as the first one's fields say. */
Load
loader (const std::vector<std::string>& files, const PlayerSettings& settings)
{
  pcl::PCLPointCloud2 header;
  const io::ClassicLocale classic;
  pcl::PCDReader().readHeader (files.front(), header);
  const auto has = [&header] (const char* name) {
    return std::any_of (header.fields.begin(),
                        header.fields.end(),
                        [name] (const auto& field) { return field.name == name; });
  };
  if (has ("rgb") || has ("rgba"))
    return loadAs<pcl::PointXYZRGBA> (files, settings);
  if (has ("intensity"))
    return loadAs<pcl::PointXYZI> (files, settings);
  return loadAs<pcl::PointXYZ> (files, settings);
}

class PcdFiles : public io::RgbdSequence {
public:
  PcdFiles (std::vector<std::string> files, const PlayerSettings& settings)
  : name_ (settings.source), files_ (std::move (files)), places_ (files_.size())
  {
    std::vector<std::string> sound;
    for (std::size_t k = 0; k < files_.size(); ++k) {
      problems_.push_back (problemOf (files_[k]));
      places_[k] = sound.size();
      if (problems_.back().empty())
        sound.push_back (files_[k]);
    }
    if (sound.empty())
      throw IoError (problems_.front());
    load_ = loader (sound, settings);
  }
  std::string
  name () const override
  {
    return name_;
  }
  int
  frames () const override
  {
    return static_cast<int> (files_.size());
  }
  io::RgbdImages
  frame (int k) const override
  {
    const auto place = static_cast<std::size_t> (k);
    if (!problems_.at (place).empty())
      throw IoError (problems_[place]);
    const std::lock_guard<std::mutex> lock (mutex_);
    const io::ClassicLocale classic;
    try {
      return load_ (places_[place]);
    }
    catch (const std::exception& e) {
      throw IoError (files_[place] + ": " + e.what());
    }
  }

private:
  std::string name_;
  std::vector<std::string> files_;
  std::vector<std::size_t> places_;   ///< in the grabber's list
  std::vector<std::string> problems_; ///< per file; not in that list unless empty
  Load load_;
  mutable std::mutex mutex_; ///< the grabber reads its list when first asked
};

/** One path a line, from the list's folder. */
std::vector<std::string>
listedIn (const std::string& list)
{
  std::vector<std::string> files;
  std::istringstream lines (io::InputFile (list).text());
  for (std::string line; std::getline (lines, line);) {
    if (!line.empty() && line.back() == '\r')
      line.pop_back();
    if (line.empty() || line.front() == '#')
      continue;
    files.push_back ((fs::path (list).parent_path() / line).string());
  }
  return files;
}

} // namespace

std::shared_ptr<const io::RgbdSequence>
openPcdFiles (const PlayerSettings& settings)
{
  const std::string& source = settings.source;
  std::vector<std::string> files;
  if (fs::is_directory (source))
    files = io::filesIn (source, {".pcd"});
  else if (io::lowerExtension (source) == ".pcd")
    files = {source};
  else
    files = listedIn (source);
  if (files.size() < 2)
    throw UsageError ("'" + source + "': holds " + std::to_string (files.size()) +
                      " .pcd files; two are needed, in a folder or a list of paths");
  return std::make_shared<PcdFiles> (std::move (files), settings);
}

} // namespace pcl_msf::tool
