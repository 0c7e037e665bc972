// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/data_folder.h>
#include <pcl_msf/visualization/result_scenes.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace pcl_msf::tool {

/** \brief Solves the pairs of a sequence one after the other in a thread of its own;
 * what is done can be looked at meanwhile. */
class SequenceSolver {
public:
  using Result = std::shared_ptr<const visualization::ResultClouds>;

  /** \brief Every frame to the next. */
  explicit SequenceSolver (const io::DataFolder& folder);

  /** \brief A result that is there already. */
  explicit SequenceSolver (Result result);

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
  run (const io::DataFolder& folder);

  int pairs_{0};
  mutable std::mutex mutex_;
  std::vector<Result> results_;
  std::string problem_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

} // namespace pcl_msf::tool
