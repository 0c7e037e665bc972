// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/datasets/timed_lists.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace pcl_msf::io {

namespace {

using Names = std::vector<std::string>;

const Names kColorWords{"color", "colour", "rgb", "image"};
const Names kDepthExtensions{".png", ".tiff", ".tif", ".dpt", ".pfm", ".exr", ".pgm"};

bool
hasWord (const std::string& name, const Names& words)
{
  return std::any_of (words.begin(), words.end(), [&] (const std::string& word) {
    return name.find (word) != std::string::npos;
  });
}

/** The image files of a folder whose names hold one of the words. */
Names
filesNamed (const std::string& folder, const Names& extensions, const Names& words)
{
  Names files;
  for (const std::string& file : filesIn (folder, extensions))
    if (hasWord (lowerCase (std::filesystem::path (file).stem().string()), words))
      files.push_back (file);
  return files;
}

struct FolderFiles {
  Names color;
  Names depth;
};

/** Either subfolders for colour and depth or all in one, told apart by their names. */
FolderFiles
listFiles (const std::string& folder)
{
  FolderFiles files;
  for (const std::string& name : foldersIn (folder)) {
    const std::string path = inside (folder, name);
    if (lowerCase (name) == "depth")
      files.depth = filesIn (path, kDepthExtensions);
    else if (files.color.empty() && (hasWord (lowerCase (name), kColorWords)))
      files.color = filesIn (path, kColorExtensions);
  }
  if (!files.depth.empty())
    return files;
  files.depth = filesNamed (folder, kDepthExtensions, {"depth"});
  files.color = filesNamed (folder, kColorExtensions, kColorWords);
  return files;
}

bool
isInteger (const std::string& depth_file)
{
  const std::string extension = lowerExtension (depth_file);
  return extension == ".png" || extension == ".pgm";
}

/** Digits of a name, to tell which images belong together. */
std::string
digitsOf (const std::string& path)
{
  std::string digits;
  for (const char c : lastName (path))
    if (std::isdigit (static_cast<unsigned char> (c)) != 0)
      digits.push_back (c);
  return digits;
}

/** Files whose names are times in seconds with a point, as of "1311868164.363.png";
 * nothing when one of the names is none. */
std::vector<TimedFile>
timedByName (const Names& files)
{
  std::vector<TimedFile> list;
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path (file).stem().string();
    double time = 0.0;
    if (stem.find ('.') == std::string::npos || !parseNumber (stem, time))
      return {};
    list.push_back ({time, file});
  }
  return list;
}

/** Pairs by the times in their names or else by their order. */
std::vector<FrameFiles>
pairUp (const std::string& folder, const FolderFiles& found, double max_difference)
{
  std::vector<FrameFiles> frames;
  const auto color = timedByName (found.color), depth = timedByName (found.depth);
  if (!color.empty() && !depth.empty()) {
    for (const auto& [c, d] : associate (color, depth, max_difference))
      frames.push_back ({color[c].file, depth[d].file, {}, color[c].time, {}, {}, -1});
    if (frames.empty())
      throw IoError (
          folder + ": frames: by the times in the images' names " +
          nothingAssociated (color, depth, max_difference, {"colour", "depth"}));
    return frames;
  }
  if (!found.color.empty() && found.color.size() != found.depth.size())
    throw IoError (folder + ": frames: " + std::to_string (found.color.size()) +
                   " colour and " + std::to_string (found.depth.size()) +
                   " depth images do not pair up; remove those without a partner");
  for (std::size_t k = 0; k < found.depth.size(); ++k) {
    FrameFiles frame;
    frame.color = found.color.empty() ? std::string() : found.color[k];
    frame.depth = found.depth[k];
    const bool together = parentFolder (frame.color) == parentFolder (frame.depth);
    if (together && digitsOf (frame.color) != digitsOf (frame.depth))
      throw IoError (frame.color + ": frames: its number is not that of " +
                     lastName (frame.depth) + "; remove what has no partner");
    frames.push_back (frame);
  }
  return frames;
}

std::shared_ptr<const RgbdSequence>
openOne (const std::string& name,
         const std::string& folder,
         const DatasetOptions& options)
{
  const FolderFiles found = listFiles (folder);
  std::vector<FrameFiles> frames = pairUp (folder, found, options.max_time_difference);
  const CameraChoice choice = chooseCamera (folder, options, {});
  if (choice.camera.fx <= 0.0)
    throw IoError (inside (folder, "camera.txt") +
                   ": camera: no such file; write one or give the camera");
  if (choice.depth_scale <= 0.0 && isInteger (found.depth.front()))
    throw IoError (inside (folder, "camera.txt") +
                   ": depth_scale: unknown; write the file or give the depth scale");
  for (FrameFiles& frame : frames) {
    frame.camera = choice.camera;
    frame.distortion = choice.distortion;
  }
  const double scale = choice.depth_scale > 0.0 ? choice.depth_scale : 1.0;
  return std::make_shared<ListedSequence> (
      name, std::move (frames), scale, choice.size, choice.float_scale);
}

} // namespace

Sequences
openFolder (const std::string& path, const DatasetOptions& options)
{
  const auto isSequence = [] (const std::string& folder) {
    return !listFiles (folder).depth.empty();
  };
  Sequences sequences;
  for (const std::string& folder : foldersWhere (path, isSequence))
    sequences.push_back (openOne (nameBelow (path, folder), folder, options));
  return sequences;
}

} // namespace pcl_msf::io
