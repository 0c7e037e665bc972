// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/tool_main.h"

#include <pcl/console/print.h>

#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.h"
#include "common/interruption.h"
#include "common/one_line.h"
#include "common/standard_streams.h"
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <exception>
#include <memory>

namespace pcl_msf::tool {

namespace {

/** The help with defaults in brackets: "--window N [0]". */
class HelpFormatter : public CLI::Formatter {
public:
  std::string
  make_option_opts (const CLI::Option* option) const override
  {
    std::string text;
    if (option->get_type_size() != 0 && !option->get_type_name().empty())
      text += " " + option->get_type_name();
    if (!option->get_default_str().empty())
      text += " [" + option->get_default_str() + "]";
    if (option->get_required())
      text += " (required)";
    for (const CLI::Option* other : option->get_needs())
      text += " (with " + other->get_name() + ")";
    for (const CLI::Option* other : option->get_excludes())
      text += " (not with " + other->get_name() + ")";
    return text;
  }
};

} // namespace

void
complain (const std::string& program, const std::string& message)
{
  std::fprintf (stderr, "%s: %s\n", program.c_str(), oneLine (message).c_str());
}

int
runTool (const std::string& program, const std::function<int()>& work)
{
  cv::utils::logging::setLogLevel (cv::utils::logging::LOG_LEVEL_SILENT);
  keepStandardStreams();
  try {
    const int status = work();
    finishStandardOutput();
    return status;
  }
  catch (const std::exception& e) {
    complain (program, e.what());
    return interrupted() ? interruptedStatus() : 1;
  }
}

int
runWithOptions (const std::string& program,
                const std::string& summary,
                const std::function<void (CLI::App&)>& declare,
                const std::function<int()>& run,
                bool needs_arguments,
                int argc,
                const char* const* argv)
{
  return runTool (program, [&] {
    CLI::App app (summary, program);
    app.set_help_flag ("-h,--help", "print this");
    app.formatter (std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width (34);
    declare (app);
    if (argc < 2 && needs_arguments) {
      std::fputs (app.help().c_str(), stdout);
      readCommandLine (app, {}); // says what is missing
      throw UsageError ("arguments: missing; --help shows the syntax");
    }
    if (!readCommandLine (app, {argv + 1, argv + argc}))
      return 0;
    pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
    noteSignals();
    return run();
  });
}

} // namespace pcl_msf::tool
