// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// One page over results: folders of pcl_msf_scene_flow and CSV tables in, HTML out.
#include "common/command_line.h"
#include "common/input_files.h"
#include "common/tool_main.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/html_report.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

namespace {

using namespace pcl_msf;
using tool::InputFiles;
using tool::requireNoInput;
using tool::UsageError;

struct ReportOptions {
  std::vector<std::string> folders;
  std::vector<std::string> tables;
  std::string title{"pcl_msf"};
  std::string output{"index.html"};
};

constexpr const char* kProgram = "pcl_msf_report";
constexpr const char* kSummary =
    "Writes a page over results that opens from disk: thumbnails, sliders,\n"
    "tables and plots. Pictures stay where they are and are linked.";

void
declareOptions (CLI::App& app, ReportOptions& options)
{
  tool::addTexts (
      app, "FOLDER", "PATH", "of pcl_msf_scene_flow, or above some", options.folders);
  tool::addTexts (app,
                  "--csv",
                  "FILE",
                  "a table, e.g. of an evaluation; may be given again",
                  options.tables);
  tool::addText (app, "--title", "TEXT", "of the page", options.title);
  tool::addText (app, "--output", "FILE", "the page", options.output);
  app.final_callback ([&options] {
    if (options.folders.empty() && options.tables.empty())
      throw UsageError ("give folders of pcl_msf_scene_flow, or --csv FILE");
  });
}

/** A folder as it was found, and what is in it. */
using FolderEntries = std::pair<std::string, std::vector<io::HtmlEntry>>;

/** A report that is damaged or of another program is left out, with a warning. */
std::vector<FolderEntries>
readFolders (const std::vector<std::string>& folders)
{
  std::vector<FolderEntries> found;
  for (const std::string& folder : folders)
    try {
      found.emplace_back (folder, io::entriesOfFolder (folder));
    }
    catch (const IoError& problem) {
      tool::complain (kProgram, std::string ("warning: left out: ") + problem.what());
    }
  return found;
}

/** Entries of all folders. Where folders have one name, their paths tell them apart. */
std::vector<io::HtmlEntry>
entriesOf (std::vector<FolderEntries> folders)
{
  std::map<std::string, int> uses;
  for (const auto& [folder, part] : folders)
    ++uses[part.front().name];
  std::vector<io::HtmlEntry> entries;
  for (auto& [folder, part] : folders) {
    const bool clear = uses[part.front().name] == 1;
    for (io::HtmlEntry& entry : part) {
      if (!clear)
        entry.name = folder + (part.size() > 1 ? ": " + entry.name : "");
      entries.push_back (std::move (entry));
    }
  }
  return entries;
}

/** Is the page to be written over something that is no page of this tool? */
void
checkOutput (const ReportOptions& options, const std::vector<std::string>& folders)
{
  if (std::filesystem::is_directory (options.output))
    throw UsageError ("--output: '" + options.output +
                      "' is a folder; give a file, for "
                      "example " +
                      (std::filesystem::path (options.output) / "index.html").string());
  InputFiles inputs;
  for (const auto& paths : {options.tables, folders})
    for (const std::string& path : paths)
      inputs.add (path);
  std::ifstream page (options.output, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char> (page), {}};
  if (!page || io::isHtmlReport (text))
    return;
  requireNoInput ("--output", options.output, inputs);
  throw UsageError ("--output: '" + options.output +
                    "' is there and no page of this tool; give another name");
}

int
run (const ReportOptions& options)
{
  io::HtmlReport report;
  report.title = options.title;
  for (const std::string& table : options.tables)
    report.tables.push_back (io::readCsvTable (table));
  std::vector<std::string> folders;
  for (const std::string& folder : options.folders) {
    const std::vector<std::string> found = io::resultFolders (folder);
    if (found.empty())
      throw UsageError (folder + ": no report.json in it or below; give a folder "
                                 "of pcl_msf_scene_flow");
    folders.insert (folders.end(), found.begin(), found.end());
  }
  report.entries = entriesOf (readFolders (folders));
  if (report.entries.empty() && report.tables.empty())
    throw UsageError ("no report of this library is left; give a folder of "
                      "pcl_msf_scene_flow");
  checkOutput (options, folders);
  const std::string parent =
      std::filesystem::path (options.output).parent_path().string();
  if (!parent.empty())
    io::makeFolder (parent);
  io::writeHtmlReport (options.output, report);
  std::printf ("%s: results %zu, tables %zu\n",
               options.output.c_str(),
               report.entries.size(),
               report.tables.size());
  return 0;
}

} // namespace

int
main (int argc, char** argv)
{
  return tool::toolMain<ReportOptions> (
      {kProgram, kSummary, declareOptions, run, false}, argc, argv);
}
