// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/io/image_grabber.h>
#include <pcl/point_types.h>

#include <opencv2/imgproc.hpp>

#include "common/command_line.h"
#include "common/player/cloud_images.h"
#include "common/player/grabbed_files.h"
#include "io/base/classic_locale.h"
#include "io/base/folder_files.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

namespace {

namespace fs = std::filesystem;

constexpr double kSaturated = 65535.0;  // in a 16-bit file: no measurement
constexpr double kMillimetres = 1000.0; // per metre, the grabber's default

/** Those whose names hold a word, of extensions that the grabber reads. */
std::vector<std::string>
filesOf (const std::string& folder,
         const std::string& word,
         const std::vector<std::string>& extensions)
{
  std::vector<std::string> files = io::filesIn (folder, extensions);
  const auto other = [&word] (const std::string& file) {
    return fs::path (file).stem().string().find (word) == std::string::npos;
  };
  files.erase (std::remove_if (files.begin(), files.end(), other), files.end());
  return files;
}

/** Two or more of depth, and as many of colour or none. */
void
requirePairs (const std::string& source, std::size_t depth, std::size_t color)
{
  if (depth < 2)
    throw UsageError ("'" + source + "': holds " + std::to_string (depth) +
                      " images with 'depth' in their names, as PCL's ImageGrabber "
                      "wants them; two are needed");
  if (color > 0 && color != depth)
    throw UsageError ("'" + source + "': holds " + std::to_string (color) +
                      " images with 'rgb' in their names and " +
                      std::to_string (depth) +
                      " with 'depth'; PCL's ImageGrabber pairs them by their order");
}

/** The grabber reads beyond the end of images of other types.
 * \return one channel, or BGR */
cv::Mat
requireImage (const std::string& file, bool color)
{
  cv::Mat image = io::readImage (file);
  const bool fits = color ? image.depth() == CV_8U && image.channels() >= 3
                          : image.type() == CV_16UC1;
  if (!fits)
    throw IoError (file +
                   (color ? ": PCL's ImageGrabber reads colours of 3 x 8 bit alone"
                          : ": PCL's ImageGrabber reads depth of 16 bit alone") +
                   "; leave out --grabber, or convert the image");
  if (image.channels() == 4)
    cv::cvtColor (image, image, cv::COLOR_BGRA2BGR);
  return image;
}

/** The grabber gives the rows of most formats, not of all, from the last one up.
 * \param stored the image as it is in the file, of the same type */
cv::Mat
upright (const cv::Mat& grabbed, const cv::Mat& stored)
{
  cv::Mat known = grabbed.clone(), flipped;
  if (known.depth() == CV_32F)
    cv::patchNaNs (known); // as no measurement is 0 in the file
  cv::flip (known, flipped, 0);
  if (cv::norm (known, stored) <= cv::norm (flipped, stored))
    return grabbed;
  cv::flip (grabbed, flipped, 0);
  return flipped;
}

using Load = std::function<io::RgbdImages (std::size_t)>;

/** The frames of a grabber, whatever its points. */
class ImageFiles : public io::RgbdSequence {
public:
  ImageFiles (std::string name,
              std::size_t frames,
              std::shared_ptr<const pcl::ImageGrabberBase> grabber,
              Load load)
  : name_ (std::move (name))
  , frames_ (frames)
  , grabber_ (std::move (grabber))
  , load_ (std::move (load))
  {}
  std::string
  name () const override
  {
    return name_;
  }
  int
  frames () const override
  {
    return static_cast<int> (frames_);
  }
  double
  timestamp (int k) const override
  {
    std::uint64_t microseconds = 0;
    try {
      if (grabber_->getTimestampAtIndex (static_cast<std::size_t> (k), microseconds))
        return 1e-6 * static_cast<double> (microseconds);
    }
    catch (const std::exception&) { // a name like that of a time, but none
    }
    return std::numeric_limits<double>::quiet_NaN();
  }
  io::RgbdImages
  frame (int k) const override
  {
    const auto place = static_cast<std::size_t> (k);
    const std::lock_guard<std::mutex> lock (mutex_);
    const io::ClassicLocale classic;
    try {
      return load_ (place);
    }
    catch (const IoError&) {
      throw;
    }
    catch (const std::exception& e) { // of PCL or boost
      throw IoError (grabber_->getDepthFileNameAtIndex (place) + ": " + e.what());
    }
  }

private:
  std::string name_;
  std::size_t frames_;
  std::shared_ptr<const pcl::ImageGrabberBase> grabber_;
  Load load_;
  mutable std::mutex mutex_; ///< of the grabber
};

/** What the grabber does not tell of images. */
struct Sensor {
  PinholeCamera camera;
  double depth_scale; ///< units per metre
};

Sensor
sensorOf (const PlayerSettings& settings)
{
  const auto known = cameraBeside (settings);
  const auto& given = settings.reading.camera;
  if (!known && !given)
    throw UsageError ("--camera: missing; '" + settings.source +
                      "' has no camera.txt either");
  if (!given && !known->distortion.isNone())
    throw UsageError ("'" + settings.source +
                      "': its images are distorted, by its camera.txt, which PCL's "
                      "ImageGrabber leaves as it is; leave out --grabber");
  const double scale = known ? known->depth_scale : kMillimetres;
  return {given ? *given : known->camera,
          settings.reading.depth_scale.value_or (scale)};
}

/** Of depth, and of colour where that is there. */
struct Files {
  std::vector<std::string> depth;
  std::vector<std::string> color;
};

template <typename PointT>
std::shared_ptr<const io::RgbdSequence>
openImages (const Files& files, const PlayerSettings& settings)
{
  const Sensor sensor = sensorOf (settings);
  const auto grabber = std::make_shared<pcl::ImageGrabber<PointT>> (files.depth);
  if (!files.color.empty())
    grabber->setRGBImageFiles (files.color);
  grabber->setDepthImageUnits (static_cast<float> (1.0 / sensor.depth_scale));
  const auto load = [grabber, sensor, files] (std::size_t k) {
    cv::Mat depth, color;
    requireImage (files.depth[k], false).convertTo (depth, CV_32F);
    if (!files.color.empty())
      color = requireImage (files.color[k], true);
    if (!color.empty() && color.size() != depth.size())
      throw IoError (files.color[k] + ": is not as large as its depth image");
    const auto cloud = (*grabber)[k];
    io::RgbdImages images;
    images.camera = sensor.camera;
    images.depth =
        upright (depthImage (pointImage (*cloud)), depth / sensor.depth_scale);
    images.depth.setTo (0.0F, depth == kSaturated);
    if (color.empty())
      images.note = "there is no image with 'rgb' in its name: geometry alone";
    else {
      images.color = upright (colorImage (*cloud), color);
    }
    return images;
  };
  return std::make_shared<ImageFiles> (
      settings.source, files.depth.size(), grabber, load);
}

/** What PCL's recorders write: the cameras are in files beside the images. */
template <typename PointT>
std::shared_ptr<const io::RgbdSequence>
openCompressed (const Files& files, const PlayerSettings& settings)
{
  const std::size_t cameras = io::filesIn (settings.source, {".xml"}).size();
  if (cameras != files.depth.size())
    throw UsageError ("'" + settings.source + "': holds " + std::to_string (cameras) +
                      " .xml files for " + std::to_string (files.depth.size()) +
                      " of depth; each needs its own");
  if (settings.reading.depth_scale)
    throw UsageError ("--depth-scale: .pclzf files have their own");
  const auto grabber =
      std::make_shared<pcl::ImageGrabber<PointT>> (settings.source, 0.0F, false, true);
  if (const auto& camera = settings.reading.camera)
    grabber->setCameraIntrinsics (camera->fx, camera->fy, camera->cx, camera->cy);
  const auto images = std::make_shared<CloudImages> (settings.reading.camera);
  const auto load = [grabber, images] (std::size_t k) {
    return images->convert (*(*grabber)[k]);
  };
  return std::make_shared<ImageFiles> (
      settings.source, files.depth.size(), grabber, load);
}

} // namespace

std::shared_ptr<const io::RgbdSequence>
openImageFiles (const PlayerSettings& settings)
{
  const std::string& source = settings.source;
  if (!fs::is_directory (source))
    throw UsageError ("'" + source + "': is no folder of images");
  const bool compressed = !io::filesIn (source, {".pclzf"}).empty();
  const std::vector<std::string> extensions =
      compressed ? std::vector<std::string>{".pclzf"}
                 : std::vector<std::string>{".png", ".jpg", ".jpeg", ".ppm", ".tiff"};
  const Files files{filesOf (source, "depth", extensions),
                    filesOf (source, "rgb", extensions)};
  requirePairs (source, files.depth.size(), files.color.size());
  if (files.color.empty())
    return compressed ? openCompressed<pcl::PointXYZ> (files, settings)
                      : openImages<pcl::PointXYZ> (files, settings);
  return compressed ? openCompressed<pcl::PointXYZRGBA> (files, settings)
                    : openImages<pcl::PointXYZRGBA> (files, settings);
}

} // namespace pcl_msf::tool
