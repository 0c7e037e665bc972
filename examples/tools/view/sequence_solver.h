// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/result_scenes.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pcl_msf::tool {

/** \brief Makes the results of pairs one after the other in a thread of its own; what
 * is done can be looked at meanwhile. */
class SequenceSolver {
public:
  using Result = std::shared_ptr<const visualization::ResultClouds>;

  /** \brief Makes a pair's result; asked for 0, 1, ... in turn.
   * \param go_on asked now and then; false = the result is not wanted any more */
  using Maker = std::function<visualization::ResultClouds (
      int pair, const std::function<bool()>& go_on)>;

  SequenceSolver (int pairs, Maker make);

  /** \brief Gives up what is being solved and waits for the thread. */
  ~SequenceSolver();
  SequenceSolver (const SequenceSolver&) = delete;
  SequenceSolver&
  operator= (const SequenceSolver&) = delete;

  int
  pairs () const
  {
    return pairs_;
  }

  /** \brief Number of pairs that are solved. */
  int
  solved () const;

  /** \brief A solved pair; null when it is not there yet. */
  Result
  result (int pair) const;

  /** \brief Why solving ended before the end; empty when it did not. */
  std::string
  problem () const;

private:
  void
  run (const Maker& make);

  int pairs_{0};
  mutable std::mutex mutex_;
  std::vector<Result> results_;
  std::string problem_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

} // namespace pcl_msf::tool
