// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/datasets/dataset_kinds.h"
#include "io/datasets/file_lists.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/datasets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>

namespace pcl_msf::io {

namespace {

/** When "auto" asks whether a path holds a kind. */
enum class Guess {
  First, ///< it has marks of its own
  Last,  ///< other kinds may look like it, too
  Never  ///< it is another name of one of these
};

/** Whether the user may say how many units of depth make a metre. */
enum class DepthUnit { Asked, Known };

struct Kind {
  const char* name;
  DatasetKind kind;
  Sequences (*open) (const std::string& path, const DatasetOptions& options);
  Guess guess;
  DepthUnit depth_unit;
};

constexpr std::array kKinds{
    Kind{"cases", DatasetKind::Cases, openCases, Guess::First, DepthUnit::Asked},
    Kind{"tum", DatasetKind::Tum, openTum, Guess::First, DepthUnit::Asked},
    Kind{"sintel", DatasetKind::Sintel, openSintel, Guess::First, DepthUnit::Known},
    Kind{"vkitti1",
         DatasetKind::VirtualKitti1,
         openVirtualKitti1,
         Guess::First,
         DepthUnit::Known},
    Kind{"vkitti2",
         DatasetKind::VirtualKitti2,
         openVirtualKitti2,
         Guess::First,
         DepthUnit::Known},
    Kind{"flyingthings",
         DatasetKind::FlyingThings,
         openFlyingThings,
         Guess::First,
         DepthUnit::Known},
    Kind{"kitti2015",
         DatasetKind::Kitti2015,
         openKitti2015,
         Guess::First,
         DepthUnit::Known},
    Kind{"middlebury",
         DatasetKind::Middlebury,
         openMiddlebury,
         Guess::First,
         DepthUnit::Known},
    Kind{"folder", DatasetKind::Folder, openFolder, Guess::Last, DepthUnit::Asked},
    Kind{"bonn", DatasetKind::Folder, openFolder, Guess::Never, DepthUnit::Asked},
    Kind{"pcd", DatasetKind::Clouds, openClouds, Guess::Last, DepthUnit::Asked},
};

std::string
allNames ()
{
  std::string names;
  for (const auto& known : datasetKinds())
    names += known.first + ", ";
  return names + "auto";
}

void
checkOptions (const DatasetOptions& options)
{
  if (options.depth_scale &&
      !(*options.depth_scale > 0.0 && std::isfinite (*options.depth_scale)))
    throw InvalidInput ("depth_scale: " + generalText (*options.depth_scale) +
                        ", must be > 0; give units per metre, for example 1000");
  if (!(options.max_time_difference > 0.0))
    throw InvalidInput (
        "max_time_difference: " + generalText (options.max_time_difference) +
        ", must be > 0, in seconds");
}

/** What a kind finds, or the error that says that it is there and damaged. */
struct Finding {
  const Kind* kind;
  Sequences sequences;
  std::exception_ptr error;
};

std::vector<Finding>
findAll (const std::string& path, const DatasetOptions& options, Guess guess)
{
  std::vector<Finding> findings;
  for (const Kind& kind : kKinds) {
    if (kind.guess != guess)
      continue;
    Finding finding{&kind, {}, nullptr};
    try {
      finding.sequences = kind.open (path, options);
    }
    catch (const IoError&) {
      finding.error = std::current_exception();
    }
    if (!finding.sequences.empty() || finding.error)
      findings.push_back (std::move (finding));
  }
  return findings;
}

/** What is given counts, or else the caller hears that it does not. */
void
checkFor (const Kind& kind, const DatasetOptions& options)
{
  if (options.distortion &&
      (kind.depth_unit == DepthUnit::Known || kind.kind == DatasetKind::Clouds))
    throw InvalidInput (std::string ("distortion: not for the kind '") + kind.name +
                        "', which has none; leave it away");
  if (options.depth_scale && kind.depth_unit == DepthUnit::Known)
    throw InvalidInput ("depth_scale: " + generalText (*options.depth_scale) +
                        " is not for the kind '" + kind.name +
                        "', which defines its unit of depth; leave it away");
}

Sequences
openAny (const std::string& path, const DatasetOptions& options)
{
  std::vector<Finding> findings = findAll (path, options, Guess::First);
  if (findings.empty())
    findings = findAll (path, options, Guess::Last);
  if (findings.empty())
    throw IoError (path +
                   ": kind: no data set known here is below this folder; the "
                   "kinds are " +
                   allNames());
  if (findings.size() > 1) {
    std::string names;
    for (const Finding& finding : findings)
      names += std::string (names.empty() ? "" : ", ") + finding.kind->name;
    throw IoError (path + ": kind: could be any of " + names + "; name the kind");
  }
  if (findings.front().error)
    std::rethrow_exception (findings.front().error);
  checkFor (*findings.front().kind, options);
  return findings.front().sequences;
}

} // namespace

const char*
toString (RenderPass pass)
{
  return pass == RenderPass::Clean ? "clean" : "final";
}

const char*
toString (StereoView view)
{
  return view == StereoView::Left ? "left" : "right";
}

const std::vector<std::pair<std::string, DatasetKind>>&
datasetKinds ()
{
  static const auto names = [] {
    std::vector<std::pair<std::string, DatasetKind>> result;
    for (const Kind& kind : kKinds)
      result.emplace_back (kind.name, kind.kind);
    return result;
  }();
  return names;
}

DatasetKind
datasetKindFromName (const std::string& name)
{
  if (name == "auto")
    return DatasetKind::Automatic;
  for (const auto& [known, kind] : datasetKinds())
    if (known == name)
      return kind;
  throw InvalidInput ("data set kind: '" + name + "'; choose one of " + allNames());
}

Sequences
openDataset (DatasetKind kind,
             const std::string& given_path,
             const DatasetOptions& options)
{
  checkOptions (options);
  if (!isFolder (given_path))
    throw IoError (given_path + ": path: no such folder; check the path");
  // Some kinds are known by the names of folders above.
  const std::string path =
      std::filesystem::absolute (given_path).lexically_normal().string();
  const auto* chosen =
      std::find_if (kKinds.begin(), kKinds.end(), [kind] (const Kind& known) {
        return known.kind == kind;
      });
  if (chosen == kKinds.end())
    return openAny (path, options);
  checkFor (*chosen, options);
  Sequences sequences = chosen->open (path, options);
  if (sequences.empty())
    throw IoError (path + ": sequences: no data set of the kind '" + chosen->name +
                   "' is below this folder; check path and kind");
  return sequences;
}

} // namespace pcl_msf::io
