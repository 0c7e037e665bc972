// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/videoio.hpp>

#include "core/base/number_text.h"
#include "io/base/output_file.h"
#include "visualization/child_process.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/images.h>
#include <pcl_msf/visualization/animation_files.h>

#include <filesystem>
#include <fstream>

namespace pcl_msf::visualization {

namespace {

namespace fs = std::filesystem;

using Arguments = std::vector<std::string>;
using Cancelled = std::function<bool()>;

constexpr double kPatience = 3600.0; ///< seconds for an encoder

/** A text file beside the output that is gone at the end. */
class ListFile {
public:
  ListFile (const std::string& path, const std::vector<std::string>& pictures)
  : path_ (path)
  {
    std::ofstream stream (path_);
    for (const std::string& picture : pictures) {
      std::string quoted;
      for (const char c : fs::absolute (picture).string())
        quoted += c == '\'' ? std::string ("'\\''") : std::string (1, c);
      stream << "file '" << quoted << "'\n";
    }
    stream.close();
    if (!stream)
      throw IoError (path_ +
                     ": cannot be written; check the folder's space and rights");
  }
  ~ListFile()
  {
    std::error_code ignored;
    fs::remove (path_, ignored);
  }
  ListFile (const ListFile&) = delete;
  ListFile&
  operator= (const ListFile&) = delete;

private:
  std::string path_;
};

/** Runs an encoder; false when it fails. \throws IoError when cancelled */
bool
run (const Arguments& arguments, const Cancelled& cancelled)
{
  ChildProcess child (arguments);
  const auto status = child.wait (kPatience, cancelled);
  if (cancelled && cancelled())
    throw IoError (arguments.front() + ": stopped before the animation was written");
  return status == 0;
}

bool
isWritten (const std::string& path)
{
  std::error_code error;
  return fs::file_size (path, error) > 0 && !error;
}

bool
byFfmpeg (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const Arguments& how,
          const Cancelled& cancelled)
{
  const std::string program = findProgram ("ffmpeg");
  if (program.empty())
    return false;
  const std::string list = path + ".txt";
  const ListFile file (list, pictures);
  Arguments arguments{program,
                      "-y",
                      "-loglevel",
                      "error",
                      "-f",
                      "concat",
                      "-safe",
                      "0",
                      "-r",
                      fixedText (rate, 6),
                      "-i",
                      list};
  arguments.insert (arguments.end(), how.begin(), how.end());
  arguments.push_back (path);
  return run (arguments, cancelled) && isWritten (path);
}

bool
byImageMagick (const std::string& path,
               const std::vector<std::string>& pictures,
               double rate,
               const Cancelled& cancelled)
{
  for (const char* name : {"magick", "convert"}) {
    const std::string program = findProgram (name);
    if (program.empty())
      continue;
    Arguments arguments{program, "-delay", fixedText (100.0 / rate, 6), "-loop", "0"};
    arguments.insert (arguments.end(), pictures.begin(), pictures.end());
    arguments.push_back ("gif:" + path);
    if (run (arguments, cancelled) && isWritten (path))
      return true;
  }
  return false;
}

bool
byOpenCv (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const Cancelled& cancelled)
{
  const std::string named = path + ".mp4"; // the name tells OpenCV the format
  cv::VideoWriter writer;
  for (const std::string& picture : pictures) {
    if (cancelled && cancelled())
      throw IoError (path + ": stopped before the animation was written");
    const cv::Mat image = io::readColor (picture);
    const cv::Rect even (0, 0, image.cols / 2 * 2, image.rows / 2 * 2);
    if (!writer.isOpened())
      for (const auto& codec : {cv::VideoWriter::fourcc ('a', 'v', 'c', '1'),
                                cv::VideoWriter::fourcc ('m', 'p', '4', 'v')})
        if (writer.open (named, cv::CAP_FFMPEG, codec, rate, even.size()))
          break;
    if (!writer.isOpened())
      return false;
    writer.write (image (even).clone());
  }
  writer.release();
  if (!isWritten (named))
    return false;
  fs::rename (named, path);
  return true;
}

void
requirePictures (const std::string& path, const std::vector<std::string>& pictures)
{
  if (pictures.empty())
    throw IoError (path + ": an animation needs one picture at least");
}

} // namespace

void
writeGif (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const Cancelled& cancelled)
{
  requirePictures (path, pictures);
  const Arguments how{
      "-filter_complex",
      "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer",
      "-loop",
      "0",
      "-f",
      "gif"};
  io::writeThenRename (path, [&] (const std::string& temporary) {
    if (!byFfmpeg (temporary, pictures, rate, how, cancelled) &&
        !byImageMagick (temporary, pictures, rate, cancelled))
      throw IoError (path +
                     ": no program here can write a GIF: install FFmpeg (Debian: "
                     "ffmpeg) or ImageMagick (imagemagick); the pictures are there");
  });
}

void
writeMp4 (const std::string& path,
          const std::vector<std::string>& pictures,
          double rate,
          const Cancelled& cancelled)
{
  requirePictures (path, pictures);
  const Arguments how{"-vf",
                      "crop=trunc(iw/2)*2:trunc(ih/2)*2",
                      "-c:v",
                      "libx264",
                      "-pix_fmt",
                      "yuv420p",
                      "-crf",
                      "18",
                      "-f",
                      "mp4"};
  io::writeThenRename (path, [&] (const std::string& temporary) {
    if (!byFfmpeg (temporary, pictures, rate, how, cancelled) &&
        !byOpenCv (temporary, pictures, rate, cancelled))
      throw IoError (path + ": nothing here can write an MP4: install FFmpeg (Debian: "
                            "ffmpeg); the pictures are there");
  });
}

} // namespace pcl_msf::visualization
