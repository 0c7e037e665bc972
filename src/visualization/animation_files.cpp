// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/videoio.hpp>

#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/visualization/animation_files.h>

#include <filesystem>

namespace pcl_msf::visualization {

namespace {

/** A film that is being written. */
class Film {
public:
  Film (const std::string& path, double rate, const cv::Size& size)
  : path_ (path), size_ (size.width / 2 * 2, size.height / 2 * 2)
  {
    for (const auto& codec : {cv::VideoWriter::fourcc ('a', 'v', 'c', '1'),
                              cv::VideoWriter::fourcc ('m', 'p', '4', 'v')})
      if (writer_.open (path_, cv::CAP_FFMPEG, codec, rate, size_))
        return;
  }

  void
  add (const cv::Mat& image)
  {
    if (writer_.isOpened())
      writer_.write (image (cv::Rect (cv::Point(), size_)).clone());
  }

  /** False when it could not be written. */
  bool
  finish ()
  {
    writer_.release();
    std::error_code error;
    return std::filesystem::file_size (path_, error) > 0 && !error;
  }

private:
  std::string path_;
  cv::Size size_;
  cv::VideoWriter writer_;
};

} // namespace

void
writeMp4 (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const std::function<bool()>& cancelled)
{
  if (pictures.empty())
    throw IoError (path + ": an animation needs one picture at least");
  if (io::lowerExtension (path) != ".mp4") // it tells OpenCV the format
    throw IoError (path + ": a film's name ends in .mp4; give one that does");
  io::writeThenRename (path, [&] (const std::string& temporary) {
    Film film (temporary, rate, io::readColor (pictures.front()).size());
    for (const std::string& picture : pictures) {
      if (cancelled && cancelled())
        throw IoError (path + ": stopped before the animation was written");
      film.add (io::readColor (picture));
    }
    if (!film.finish())
      throw IoError (path + ": OpenCV has no FFmpeg here that writes an MP4; the "
                            "pictures are there, join them by another program");
  });
}

} // namespace pcl_msf::visualization
