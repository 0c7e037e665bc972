// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include "io/datasets/frame_parts.h"
#include "io/datasets/listed_sequence.h"
#include "io/input_file.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace pcl_msf::io {

namespace {

using Names = std::vector<std::string>;

const Names kColorWords{"color", "colour", "rgb", "image"};
const Names kColorExtensions{".png", ".jpg", ".jpeg", ".ppm", ".pgm"};
const Names kDepthExtensions{".png", ".tiff", ".tif", ".dpt", ".pfm", ".exr", ".pgm"};

std::string
lower (std::string text)
{
  std::transform (text.begin(), text.end(), text.begin(), [] (unsigned char c) {
    return static_cast<char> (std::tolower (c));
  });
  return text;
}

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
    if (hasWord (lower (std::filesystem::path (file).stem().string()), words))
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
    if (lower (name) == "depth")
      files.depth = filesIn (path, kDepthExtensions);
    else if (files.color.empty() && (hasWord (lower (name), kColorWords)))
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

std::shared_ptr<const RgbdSequence>
openOne (const std::string& name,
         const std::string& folder,
         const DatasetOptions& options)
{
  const FolderFiles found = listFiles (folder);
  if (!found.color.empty() && found.color.size() != found.depth.size())
    throw IoError (folder + ": frames: " + std::to_string (found.color.size()) +
                   " colour and " + std::to_string (found.depth.size()) +
                   " depth images do not pair up; remove those without a partner");
  const CameraChoice choice = chooseCamera (folder, options, {});
  if (choice.camera.fx <= 0.0)
    throw IoError (inside (folder, "camera.txt") +
                   ": camera: no such file; write one or give the camera");
  if (choice.depth_scale <= 0.0 && isInteger (found.depth.front()))
    throw IoError (inside (folder, "camera.txt") +
                   ": depth_scale: unknown; write the file or give the depth scale");
  std::vector<FrameFiles> files;
  for (std::size_t k = 0; k < found.depth.size(); ++k) {
    FrameFiles frame;
    frame.color = found.color.empty() ? std::string() : found.color[k];
    frame.depth = found.depth[k];
    frame.camera = choice.camera;
    files.push_back (frame);
  }
  const double scale = choice.depth_scale > 0.0 ? choice.depth_scale : 1.0;
  return std::make_shared<ListedSequence> (name, std::move (files), scale, choice.size);
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
