// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "view/result_source.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pcl_msf::tool {

/** \brief Makes the results of pairs one after the other in a thread of its own; what
 * is done can be looked at meanwhile. */
class SequenceSolver : public ResultSource {
public:
  /** \brief Makes a pair's result; asked for 0, 1, ... in turn.
   * \param go_on asked now and then; false = the result is not wanted any more */
  using Maker = std::function<visualization::ResultClouds (
      int pair, const std::function<bool()>& go_on)>;

  SequenceSolver (int pairs, Maker make);

  /** \brief Gives up what is being solved and waits for the thread. */
  ~SequenceSolver() override;
  SequenceSolver (const SequenceSolver&) = delete;
  SequenceSolver&
  operator= (const SequenceSolver&) = delete;

  int
  solved () const override;
  Result
  result (int pair) const override;
  std::string
  title (int pair) const override;
  std::string
  problem () const override;

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
