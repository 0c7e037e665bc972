// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "render/options.h"

#include "common/command_line.h"
#include "render/option_table.h"
#include <CLI/App.hpp>

#include <string>

namespace pcl_msf::tool {

namespace {

void
takeKind (const std::string& word, RenderOptions& o)
{
  const bool sheet = word == "sheet" || word == "all";
  const std::size_t before = o.kinds.size();
  o.sheet = o.sheet || sheet;
  for (const auto& [name, kind] : visualization::pictureKinds())
    if (name == word || word == "all")
      o.kinds.push_back (kind);
  if (!sheet && o.kinds.size() == before)
    throw UsageError ("--kind: '" + word + "' is none; --help lists them");
}

void
check (RenderOptions& o)
{
  std::string why;
  for (const std::string& word : o.kind_words)
    takeKind (word, o);
  if (o.kind_words.empty() && o.animation == Animation::None)
    takeKind (kUsualKind, o);
  if (o.gif)
    throw UsageError ("--gif: no longer made here; the pictures of --animation can be "
                      "joined: ffmpeg -i DIR/warp/warp_%04d.png warp.gif");
  if (o.input.empty())
    throw UsageError ("give a folder of pcl_msf_scene_flow or one with frames");
  if (!o.style.isValid (&why))
    throw UsageError ("--" + why);
  if (o.view == ViewPreset::User && !o.eye)
    throw UsageError ("--view user: needs --eye X,Y,Z");
}

} // namespace

void
declareOptions (CLI::App& app, RenderOptions& options)
{
  addRenderOptions (app, options);
  app.final_callback ([&options] { check (options); });
}

} // namespace pcl_msf::tool
