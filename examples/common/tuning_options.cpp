// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/tuning_options.h"

#include "common/command_line.h"
#include "core/base/number_text.h"
#include "core/base/tuning/tuning.h"
#include <CLI/App.hpp>
#include <pcl_msf/errors.h>

#include <cstdio>

namespace pcl_msf::tool {

namespace {

void
take (const std::string& assignment)
{
  const std::size_t sign = assignment.find ('=');
  if (sign == std::string::npos)
    throw UsageError ("--tuning: '" + assignment + "' is no NAME=VALUE");
  try {
    setTuning (assignment.substr (0, sign), assignment.substr (sign + 1));
  }
  catch (const InvalidInput& e) {
    throw UsageError (std::string ("--tuning: ") + e.what());
  }
}

/** A line each: name, value, least, most, whole or real. */
void
list ()
{
  Tuning tuning = currentTuning();
  for (const TunedValue& value : tunedValues (tuning))
    std::printf ("%s %s %s %s %s\n",
                 value.name.c_str(),
                 valueText (value).c_str(),
                 generalText (value.least).c_str(),
                 generalText (value.most).c_str(),
                 std::holds_alternative<int*> (value.place) ? "whole" : "real");
}

} // namespace

void
addTuningOptions (CLI::App& app)
{
  const auto read = [] (const CLI::results_t& values) {
    for (const std::string& value : values)
      take (value);
    return true;
  };
  app.add_option ("--tuning", read, "a tuned value")
      ->type_name ("NAME=VALUE")
      ->expected (-1)
      ->allow_extra_args (false)
      ->multi_option_policy (CLI::MultiOptionPolicy::TakeAll)
      ->trigger_on_parse() // before --list-tuning
      ->group ("");
  app.add_flag_callback (
         "--list-tuning",
         [] {
           list();
           throw CLI::Success();
         },
         "all of them")
      ->trigger_on_parse()
      ->group ("");
}

} // namespace pcl_msf::tool
