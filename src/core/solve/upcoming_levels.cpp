// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/upcoming_levels.h"

#include <exception>
#include <memory>
#include <utility>

namespace pcl_msf {

void
UpcomingLevels::begin (const WindowScene& scene, std::vector<Request> requests)
{
  const auto made =
      std::make_shared<std::vector<std::promise<LevelPoints>>> (requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i)
    levels_[requests[i].options.level] = (*made)[i].get_future();
  work_ = meanwhile (scene.threads, [&scene, made, requests = std::move (requests)] {
    for (std::size_t i = 0; i < requests.size(); ++i)
      try {
        const Request& request = requests[i];
        (*made)[i].set_value (prepareLevel (scene,
                                            request.options.level,
                                            request.labels,
                                            request.options,
                                            request.needs));
      }
      catch (...) {
        (*made)[i].set_exception (std::current_exception());
      }
  });
}

LevelPoints
UpcomingLevels::take (int level)
{
  // Where there was no thread, this one does it now.
  if (work_.valid() && work_.isLeftToCaller())
    work_.get();
  const auto found = levels_.find (level);
  LevelPoints points = found->second.get();
  levels_.erase (found);
  return points;
}

} // namespace pcl_msf
