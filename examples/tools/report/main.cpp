// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// One page over results: folders of pcl_msf_scene_flow and CSV tables in, HTML out.
#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.h"
#include "common/input_files.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/html_report.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

namespace {

using namespace pcl_msf;
using tool::CommandLine;
using tool::InputFiles;
using tool::requireNoInput;
using tool::UsageError;

struct ReportOptions {
  std::vector<std::string> folders;
  std::vector<std::string> tables;
  std::string title{"pcl_msf"};
  std::string output{"index.html"};
  bool help{false};
};

CommandLine
makeCommandLine (ReportOptions& options)
{
  CommandLine line;
  line.summary =
      "Writes a page over results that opens from disk: thumbnails, sliders,\n"
      "tables and plots. Pictures stay where they are and are linked.";
  line.syntax = {"pcl_msf_report FOLDER... [--csv FILE]... [--output index.html]"};
  line.options = {{"--csv",
                   "FILE",
                   "a table, e.g. of an evaluation; may be given again",
                   [&options] (const std::string& word) {
                     options.tables.push_back (word);
                     return !word.empty();
                   }},
                  {"--title",
                   "TEXT",
                   "[pcl_msf]",
                   [&options] (const std::string& word) {
                     options.title = word;
                     return true;
                   }},
                  {"--output", "FILE", "[index.html]", tool::text (options.output)},
                  {"--help", "", "print this", tool::flag (options.help)}};
  line.take_word = [&options] (const std::string& word) {
    options.folders.push_back (word);
  };
  return line;
}

/** Entries of all folders. Where folders have one name, their paths tell them apart. */
std::vector<io::HtmlEntry>
readEntries (const std::vector<std::string>& folders)
{
  std::map<std::string, int> uses;
  std::vector<std::vector<io::HtmlEntry>> parts;
  for (const std::string& folder : folders) {
    parts.push_back (io::entriesOfFolder (folder));
    ++uses[parts.back().front().name];
  }
  std::vector<io::HtmlEntry> entries;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const bool clear = uses[parts[i].front().name] == 1;
    for (io::HtmlEntry& entry : parts[i]) {
      if (!clear)
        entry.name = folders[i] + (parts[i].size() > 1 ? ": " + entry.name : "");
      entries.push_back (std::move (entry));
    }
  }
  return entries;
}

/** Is the page to be written over something that is no page of this tool? */
void
checkOutput (const ReportOptions& options, const std::vector<std::string>& folders)
{
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
  report.entries = readEntries (folders);
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
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  ReportOptions options;
  const CommandLine line = makeCommandLine (options);
  try {
    line.read (argc, argv);
    if (options.help) {
      line.printHelp();
      return 0;
    }
    if (options.folders.empty() && options.tables.empty())
      throw UsageError ("give folders of pcl_msf_scene_flow, or --csv FILE");
    return run (options);
  }
  catch (const std::exception& e) {
    tool::complain ("pcl_msf_report", e.what());
    return 1;
  }
}
