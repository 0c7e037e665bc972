// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// One page over results: folders of pcl_msf_scene_flow and CSV tables in, HTML out.
#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.h"
#include "common/option_values.h"
#include "common/tool_main.h"
#include <pcl_msf/io/folders.h>
#include <pcl_msf/io/html_report.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace {

using namespace pcl_msf;
using tool::CommandLine;
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

/** Names that tell the results apart: their paths, without what all have in common. */
void
nameEntries (const std::vector<std::string>& folders, io::HtmlReport& report)
{
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const std::string name = report.entries[i].name;
    const auto same = std::count_if (report.entries.begin(),
                                     report.entries.end(),
                                     [&] (auto& entry) { return entry.name == name; });
    if (same > 1)
      report.entries[i].name = folders[i];
  }
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
  for (const std::string& folder : folders)
    report.entries.push_back (io::entryOfFolder (folder));
  nameEntries (folders, report);
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
