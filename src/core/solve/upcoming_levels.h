// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/meanwhile.h"
#include "core/data/window_level.h"

#include <future>
#include <map>
#include <vector>

namespace pcl_msf {

/** \brief Points of levels that are made by another thread, one level after the other,
 * while the caller solves those before. It waits for that thread as it goes. */
class UpcomingLevels {
public:
  struct Request {
    std::vector<cv::Mat> labels; ///< as prepareLevel () takes them
    PointOptions options;        ///< the level among them
    LevelNeeds needs{};          ///< what is wanted of it
  };

  /** \brief Begins to make levels. \param scene must stay */
  void
  begin (const WindowScene& scene, std::vector<Request> requests);

  bool
  has (int level) const
  {
    return levels_.count (level) > 0;
  }

  /** \brief Waits for a level that there is, and gives it away. */
  LevelPoints
  take (int level);

private:
  std::map<int, std::future<LevelPoints>> levels_;
  Meanwhile<void> work_;
};

} // namespace pcl_msf
