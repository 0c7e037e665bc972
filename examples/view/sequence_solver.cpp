// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "view/sequence_solver.h"

#include "render/inputs.h"

#include <exception>

namespace pcl_msf::tool {

SequenceSolver::SequenceSolver (const io::DataFolder& folder)
: pairs_ (folder.frames() - 1), thread_ ([this, folder] { run (folder); })
{}

SequenceSolver::SequenceSolver (Result result) : pairs_ (1)
{
  results_.push_back (std::move (result));
}

SequenceSolver::~SequenceSolver()
{
  stop_ = true;
  if (thread_.joinable())
    thread_.join();
}

void
SequenceSolver::run (const io::DataFolder& folder)
{
  try {
    io::RgbdImages reference = folder.frame (0);
    for (int k = 1; k <= pairs_ && !stop_; ++k) {
      io::RgbdImages current = folder.frame (k);
      auto solved = std::make_shared<visualization::ResultClouds> (
          estimatePair (reference, current, [this] { return !stop_; }));
      const std::lock_guard<std::mutex> lock (mutex_);
      results_.push_back (std::move (solved));
      reference = std::move (current);
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
SequenceSolver::problem() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return problem_;
}

} // namespace pcl_msf::tool
