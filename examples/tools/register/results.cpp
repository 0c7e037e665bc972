// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "register/results.h"

#include <pcl/console/print.h>

#include "common/interruption.h"
#include <pcl_msf/io/text_files.h>

#include <algorithm>
#include <regex>

namespace pcl_msf::tool {

namespace {

std::string
partsText (const CloudFlow& flow)
{
  std::string text;
  for (const int part : flow.part)
    text += std::to_string (part) + "\n";
  return text;
}

/** What belongs to one target. \param ending of the names, before the type */
void
writeTarget (const RegisterResults& results,
             const CloudFlow& flow,
             const std::string& folder,
             const std::string& ending)
{
  throwIfInterrupted();
  io::writePointsPly (folder + "/warped" + ending + ".ply", flow.warped);
  io::writeRegisteredCloud (
      folder + "/registered" + ending + ".pcd", flow, results.source);
  io::writeJoints (folder + "/joints" + ending + ".json", flow);
  io::writeCloudReport (folder + "/report" + ending + ".json",
                        flow,
                        results.load_seconds,
                        results.total_seconds);
}

} // namespace

const CloudFlow&
RegisterResults::verdict() const
{
  const auto lost = std::find_if (flows.begin(), flows.end(), [] (const auto& flow) {
    return !flow.report.converged;
  });
  return lost == flows.end() ? flows.back() : *lost;
}

bool
isResultName (const std::string& name)
{
  static const std::regex names (
      R"((warped(_0_\d+)?\.ply|registered(_0_\d+)?\.pcd|parts(_0)?\.txt|)"
      R"((joints|report)(_0_\d+)?\.json))");
  return std::regex_match (name, names);
}

void
writeResults (const RegisterResults& results, const std::string& folder)
{
  const std::string parts = partsText (results.flows.front());
  if (results.flows.size() == 1) {
    writeTarget (results, results.flows.front(), folder, "");
    io::writeText (folder + "/parts.txt", parts);
    return;
  }
  for (std::size_t k = 0; k < results.flows.size(); ++k)
    writeTarget (results, results.flows[k], folder, "_0_" + std::to_string (k + 1));
  io::writeText (folder + "/parts_0.txt", parts);
  io::writeCloudReport (folder + "/report.json",
                        results.verdict(),
                        results.load_seconds,
                        results.total_seconds);
}

void
printSummary (const RegisterResults& results, const std::string& folder)
{
  using namespace pcl::console;
  setVerbosityLevel (L_INFO);
  for (std::size_t k = 0; k < results.flows.size(); ++k) {
    const CloudFlow& flow = results.flows[k];
    const std::string name =
        results.flows.size() > 1 ? "target " + std::to_string (k + 1) + ": " : "";
    print_highlight ("%s%zu points, %zu parts, %zu joints, %.0f %% and %.0f %% of the "
                     "clouds found on each other\n",
                     name.c_str(),
                     flow.warped.size(),
                     flow.parts.size(),
                     flow.joints.size(),
                     100.0 * flow.explained_source,
                     100.0 * flow.explained_target);
  }
  print_info ("[done, ");
  print_value ("%.1f", 1000.0 * results.total_seconds);
  print_info (" ms; written to ");
  print_value ("%s", folder.c_str());
  print_info ("]\n");
}

} // namespace pcl_msf::tool
