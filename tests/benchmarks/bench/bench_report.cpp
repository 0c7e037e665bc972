// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "bench_report.h"

#include "common/table_text.h"
#include <nlohmann/json.hpp>
#include <pcl_msf/version.h>

#include <cmath>
#include <limits>

namespace pcl_msf::benchmarks {

namespace {

using tool::cell;

constexpr std::pair<const char*, double tool::StageSeconds::*> kStages[] = {
    {"frame", &tool::StageSeconds::frame},
    {"segment", &tool::StageSeconds::segment},
    {"start", &tool::StageSeconds::start},
    {"solve", &tool::StageSeconds::solve},
    {"result", &tool::StageSeconds::result}};

/** Seconds of DIS medium alone with as many threads; NaN when it was not run. */
double
yardstick (const BenchReport& report, unsigned threads)
{
  for (const Measured& m : report.methods)
    if (m.method == "dis_medium" && m.threads == threads)
      return m.seconds.solve;
  return std::numeric_limits<double>::quiet_NaN();
}

std::string
methodTable (const BenchReport& report)
{
  tool::TableText table (
      {"method", "threads", "ms", "x DIS", "pairs/s", "Mpixel/s", "MB", "runs"});
  const double megapixels = 1e-6 * report.width * report.height;
  for (const Measured& m : report.methods) {
    const double seconds = m.seconds.total;
    table.add ({m.method,
                std::to_string (m.threads),
                cell (1e3 * seconds, 1),
                cell (seconds / yardstick (report, m.threads), 1),
                cell (1.0 / seconds, 1),
                cell (megapixels / seconds, 1),
                cell (m.megabytes, 0),
                std::to_string (m.runs)});
    for (const auto& [name, stage] : kStages)
      if (std::isfinite (m.seconds.*stage))
        table.add ({std::string (". ") + name,
                    "",
                    cell (1e3 * m.seconds.*stage, 1),
                    "",
                    "",
                    "",
                    "",
                    ""});
  }
  return table.text();
}

std::string
kernelTable (const BenchReport& report)
{
  tool::TableText table (
      {"kernel, one core", "Mpoint/s", "GB/s", "% of memory", "Gop/s", "% of units"});
  for (const KernelSpeed& k : report.kernels)
    table.add ({k.name,
                cell (1e-6 * k.points_per_second, 0),
                cell (1e-9 * k.bytes_per_second, 1),
                cell (100.0 * k.memory_share, 0),
                cell (1e-9 * k.operations_per_second, 1),
                cell (100.0 * k.units_share, 0)});
  return "\n" + table.text();
}

nlohmann::json
number (double value)
{
  return std::isfinite (value) ? nlohmann::json (value) : nlohmann::json();
}

} // namespace

std::string
tableText (const BenchReport& report)
{
  return "pcl_msf " PCL_MSF_VERSION_PRETTY ", " + report.processor + ", " +
         std::to_string (report.processors) + " processors\n" + report.pair + ", " +
         std::to_string (report.width) + "x" + std::to_string (report.height) +
         "; medians; MB: what a run with one thread adds at its peak\n\n" +
         methodTable (report) + (report.kernels.empty() ? "" : kernelTable (report));
}

std::string
jsonText (const BenchReport& report)
{
  nlohmann::json root{{"version", PCL_MSF_VERSION_PRETTY},
                      {"processor", report.processor},
                      {"processors", report.processors},
                      {"pair", report.pair},
                      {"width", report.width},
                      {"height", report.height},
                      {"methods", nlohmann::json::array()},
                      {"kernels", nlohmann::json::array()}};
  for (const Measured& m : report.methods) {
    nlohmann::json seconds{{"total", number (m.seconds.total)}};
    for (const auto& [name, stage] : kStages)
      seconds[name] = number (m.seconds.*stage);
    root["methods"].push_back ({{"method", m.method},
                                {"threads", m.threads},
                                {"runs", m.runs},
                                {"seconds", seconds},
                                {"megabytes", number (m.megabytes)}});
  }
  for (const KernelSpeed& k : report.kernels)
    root["kernels"].push_back ({{"kernel", k.name},
                                {"points_per_second", k.points_per_second},
                                {"bytes_per_second", k.bytes_per_second},
                                {"operations_per_second", k.operations_per_second},
                                {"memory_share", k.memory_share},
                                {"units_share", k.units_share}});
  return root.dump (2) + "\n";
}

} // namespace pcl_msf::benchmarks
