// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "view/sequence_solver.h"

#include <exception>
#include <utility>

namespace pcl_msf::tool {

SequenceSolver::SequenceSolver (int pairs, Maker make)
: pairs_ (pairs), thread_ ([this, make = std::move (make)] { run (make); })
{}

SequenceSolver::~SequenceSolver()
{
  stop_ = true;
  if (thread_.joinable())
    thread_.join();
}

void
SequenceSolver::run (const Maker& make)
{
  try {
    for (int k = 0; k < pairs_ && !stop_; ++k) {
      auto solved = std::make_shared<visualization::ResultClouds> (
          make (k, [this] { return !stop_; }));
      const std::lock_guard<std::mutex> lock (mutex_);
      results_.push_back (std::move (solved));
    }
  }
  catch (const std::exception& e) {
    const std::lock_guard<std::mutex> lock (mutex_);
    problem_ = e.what();
  }
}

int
SequenceSolver::solved() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return static_cast<int> (results_.size());
}

SequenceSolver::Result
SequenceSolver::result (int pair) const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return pair >= 0 && pair < static_cast<int> (results_.size()) ? results_[pair]
                                                                : nullptr;
}

std::string
SequenceSolver::title (int pair) const
{
  const std::string words =
      "pair " + std::to_string (pair + 1) + " of " + std::to_string (pairs_);
  const int done = solved();
  return done < pairs_ ? words + ", solved " + std::to_string (done) : words;
}

std::string
SequenceSolver::problem() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return problem_;
}

} // namespace pcl_msf::tool
