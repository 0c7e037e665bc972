// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "window_log.h"

#include "common/command_line.h"
#include "io/base/json.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/text_files.h>
#include <pcl_msf/version.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

namespace pcl_msf::tool {

namespace {

std::string
pathIn (const std::string& folder)
{
  return (std::filesystem::path (folder) / WindowLog::kName).string();
}

io::Json
jsonOf (const WindowRecord& record)
{
  io::Json motions = io::Json::array();
  for (const RigidPose& motion : record.motions)
    motions.push_back (motion.parameters);
  return {{"window", record.window},
          {"frames", record.frames},
          {"reference", record.reference},
          {"converged", record.converged},
          {"motions", motions},
          {"seconds", record.seconds}};
}

double
numberOf (const io::Json& json)
{
  return json.is_null() ? std::nan ("") : json.get<double>();
}

WindowRecord
recordOf (const io::Json& json)
{
  WindowRecord record;
  json.at ("window").get_to (record.window);
  json.at ("frames").get_to (record.frames);
  json.at ("reference").get_to (record.reference);
  json.at ("converged").get_to (record.converged);
  for (const io::Json& seconds : json.at ("seconds"))
    record.seconds.push_back (numberOf (seconds));
  for (const io::Json& motion : json.at ("motions")) {
    auto& parameters = record.motions.emplace_back().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      parameters[i] = numberOf (motion.at (i));
  }
  if (record.motions.empty() || record.motions.size() != record.seconds.size() ||
      record.motions.size() != record.frames.size())
    throw InvalidInput ("frames, motions and seconds differ in number");
  return record;
}

} // namespace

WindowLog::WindowLog (std::string settings, int windows, Shard shard)
: settings_ (std::move (settings)), windows_ (windows), shard_ (shard)
{}

WindowLog
WindowLog::read (const std::string& folder)
{
  const std::string path = pathIn (folder);
  std::ifstream stream (path, std::ios::binary);
  try {
    const io::Json json = io::Json::parse (stream);
    WindowLog log (json.at ("settings").get<std::string>(),
                   json.at ("windows").get<int>(),
                   {json.at ("shard").get<int>(), json.at ("shards").get<int>()});
    for (const io::Json& record : json.at ("done"))
      log.add (recordOf (record));
    return log;
  }
  catch (const std::exception& error) {
    throw IoError (path +
                   ": no list of windows; remove the folder and run its shard "
                   "again (" +
                   error.what() + ")");
  }
}

void
WindowLog::resume (const std::string& folder)
{
  if (!std::filesystem::exists (pathIn (folder)))
    return;
  WindowLog found = read (folder);
  requireSameRun (found, folder);
  records_ = std::move (found.records_);
}

void
WindowLog::write (const std::string& folder) const
{
  io::Json json{{"version", PCL_MSF_VERSION_PRETTY},
                {"settings", settings_},
                {"windows", windows_},
                {"shard", shard_.index},
                {"shards", shard_.count},
                {"done", io::Json::array()}};
  for (const auto& [window, record] : records_)
    json["done"].push_back (jsonOf (record));
  io::writeText (pathIn (folder), io::jsonText (json));
}

void
WindowLog::requireSameRun (const WindowLog& other, const std::string& folder) const
{
  if (other.settings_ != settings_ || other.windows_ != windows_ ||
      other.shard_.count != shard_.count)
    throw UsageError (folder + ": holds another run ('" + other.settings_ + "', " +
                      std::to_string (other.windows_) + " windows, " +
                      std::to_string (other.shard_.count) + " shards; this is '" +
                      settings_ + "', " + std::to_string (windows_) + ", " +
                      std::to_string (shard_.count) +
                      "); remove it or give another --output");
}

} // namespace pcl_msf::tool
