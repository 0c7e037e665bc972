// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/methods/method.h"
#include "options.h"
#include "score.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief One pair of frames of one sequence. */
struct WorkItem {
  std::size_t number{0};
  std::shared_ptr<const io::RgbdSequence> sequence;
  std::string name; ///< the sequence's, in one line; each has its own
  int from{0};
  int to{0};
};

/** \brief All pairs that the options ask for, in the order of the data set; the same on
 * all machines. \throws IoError, InvalidInput; UsageError when there is none */
std::vector<WorkItem>
listWork (const EvaluateOptions& options);

/** \brief Runs all methods on a pair; the rows in the order of the methods. A method
 * that cannot run on this pair (no colour, no truth) has a row of unknowns. What of the
 * files is not used, and depth that can hardly be in metres, is told on stderr, once a
 * sequence. */
class PairRunner {
public:
  /** \throws UsageError for an unknown method */
  explicit PairRunner (const EvaluateOptions& options);

  std::vector<Row>
  run (const WorkItem& item);

private:
  void
  tellOnce (const WorkItem& item, int frame, const io::RgbdImages& images);

  std::string dataset_;
  std::optional<double> depth_scale_;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<Method>> methods_;
  std::set<std::string> told_; ///< by sequence and kind of problem
};

} // namespace pcl_msf::tool
