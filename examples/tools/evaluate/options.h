// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include "common/shard.h"
#include "generated.h"
#include <pcl_msf/io/datasets.h>

#include <string>
#include <vector>

namespace pcl_msf::tool {

/** \brief Which two frames make a pair. */
enum class Pairs {
  Adjacent, ///< each frame and the next one
  FromFirst ///< frame 0 and each later one
};

/** \brief In place of the methods' names: all that there are, or with an ablation only
 * ours. */
constexpr const char* kAllMethods = "all";

/** \brief Everything that the command line of pcl_msf_evaluate says. */
struct EvaluateOptions {
  std::vector<std::string> words; ///< without a name: the data set and its path
  std::string dataset;            ///< a kind, "auto" or "generated"
  std::string path;
  io::DatasetOptions reading;
  GeneratedOptions generated;
  std::vector<std::string> methods{kAllMethods};
  Pairs pairs{Pairs::Adjacent};
  int step{1};  ///< every so many frames
  int limit{0}; ///< pairs of a sequence at the most; 0 = all
  bool ablation{false};
  std::string labels{"method"}; ///< of all methods "msf"
  std::string start{"method"};  ///< likewise
  unsigned threads{0};
  Shard shard;
  std::string csv;
  std::string json;
  bool merge{false};
  std::vector<std::string> merged; ///< the files to merge, into `csv`
  bool quiet{false};

  /** \brief What results depend on, as one line: rows of different settings are not
   * comparable. */
  std::string
  settings () const;
};

constexpr const char* kSummary =
    "Scores our method and baselines on a data set.\n\n"
    "  pcl_msf_evaluate DATASET PATH [options]\n"
    "  pcl_msf_evaluate generated [options]\n"
    "  pcl_msf_evaluate clouds FOLDER | bodies [options]\n"
    "  pcl_msf_evaluate --merge --csv OUT.csv SHARD.csv ...";

/** \brief Adds the options to a command line, which checks them when it is read; it
 * throws UsageError then. The help has the methods and the columns of the CSV, too. */
void
declareOptions (CLI::App& app, EvaluateOptions& options);

} // namespace pcl_msf::tool
