// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "register/options.h"

#include "common/default_help.h"
#include "common/option_values.h"

namespace pcl_msf::tool {

namespace {

CommandLine
commandLine (RegisterOptions& o)
{
  CommandLine line;
  line.summary = "Registers an articulated or deforming body given as two clouds of "
                 "points without a grid: its parts,\ntheir motions and joints, and "
                 "where every point has gone. Any unit; the same in the results.\n"
                 "Exit status: 0 = written and found, 3 = written but not found or cut "
                 "short (stderr says why), else an error.";
  line.syntax = {"SOURCE TARGET --output DIR [options]"};
  line.options = {
      {"--output",
       "DIR",
       "folder for warped.ply, registered.pcd, parts.txt, joints.json, report.json",
       text (o.output)},
      numeric ("--threads", "N", "0 = all", o.solver.threads),
      numeric ("--max-seconds", "S", "time budget, 0 = none", o.solver.max_seconds),
      switchable ("--merge-bodies", "join what moves as one part", o.solver.merge_bodies),
      {"--quiet", "", "print errors and warnings only", flag (o.quiet)},
      {"--help", "", "print this", flag (o.help)}};
  line.take_word = [&o] (const std::string& word) {
    std::string& free = o.source.empty() ? o.source : o.target;
    if (!free.empty() || word.empty())
      throw UsageError ("'" + word + "': not an option; --help lists them");
    free = word;
  };
  return line;
}

} // namespace

RegisterOptions
parseRegisterOptions (int argc, const char* const* argv)
{
  RegisterOptions options;
  commandLine (options).read (argc, argv);
  if (options.help)
    return options;
  if (options.source.empty())
    throw UsageError ("SOURCE: missing; give a .pcd, .ply or .obj file");
  if (options.target.empty())
    throw UsageError ("TARGET: missing; give a .pcd, .ply or .obj file");
  if (options.output.empty())
    throw UsageError ("--output: missing; give a folder for the results");
  std::string why;
  if (!options.solver.isValid (&why)) {
    for (char& c : why)
      c = c == '_' ? '-' : c;
    throw UsageError ("--" + why);
  }
  return options;
}

void
printRegisterHelp (const char*)
{
  RegisterOptions defaults;
  commandLine (defaults).printHelp();
}

} // namespace pcl_msf::tool
