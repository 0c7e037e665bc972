// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "work.h"

#include "common/command_line.h"
#include "common/depth_check.h"
#include "common/methods/peak_memory.h"
#include "common/one_line.h"
#include "common/tool_main.h"
#include "score_pair.h"
#include <pcl_msf/errors.h>

#include <map>

namespace pcl_msf::tool {

namespace {

void
addPairs (const EvaluateOptions& options,
          const std::shared_ptr<const io::RgbdSequence>& sequence,
          const std::string& name,
          std::vector<WorkItem>& work)
{
  const int frames = sequence->frames();
  int count = 0;
  for (int to = options.step; to < frames; to += options.step) {
    if (options.limit > 0 && count++ == options.limit)
      break;
    const int from = options.pairs == Pairs::Adjacent ? to - options.step : 0;
    work.push_back ({work.size(), sequence, name, from, to});
  }
}

PairData
load (const WorkItem& item)
{
  PairData pair;
  pair.reference = item.sequence->frame (item.from);
  pair.current = item.sequence->frame (item.to);
  io::unifyColors ({&pair.reference, &pair.current});
  if (pair.reference.depth.size() != pair.current.depth.size())
    throw IoError (item.name + ": frames " + std::to_string (item.from) + " and " +
                   std::to_string (item.to) +
                   ": size: " + std::to_string (pair.reference.depth.cols) + "x" +
                   std::to_string (pair.reference.depth.rows) + " and " +
                   std::to_string (pair.current.depth.cols) + "x" +
                   std::to_string (pair.current.depth.rows) +
                   "; all frames must have one size");
  if (pair.reference.color.empty() || pair.current.color.empty()) {
    pair.reference.color.release();
    pair.current.color.release();
  }
  pair.truth = item.sequence->truth (item.from, item.to);
  const auto from = item.sequence->cameraPose (item.from);
  const auto to = item.sequence->cameraPose (item.to);
  if (from && to)
    pair.camera_motion = to->inverse() * *from;
  else
    pair.camera_motion = pair.truth.rigid;
  return pair;
}

/** Methods that need no depth run all the same. */
std::string
depthProblem (const cv::Mat& depth, const std::string& name, const DepthUnit& unit)
{
  try {
    return checkDepth (depth, {}, name, unit);
  }
  catch (const UsageError& problem) {
    return problem.what();
  }
}

} // namespace

std::vector<WorkItem>
listWork (const EvaluateOptions& options)
{
  const auto sequences =
      options.dataset == "generated"
          ? openGenerated (options.generated)
          : io::openDataset (io::datasetKindFromName (options.dataset),
                             options.path,
                             options.reading);
  std::vector<WorkItem> work;
  std::map<std::string, int> uses;
  for (const auto& sequence : sequences) {
    std::string name = oneLine (sequence->name()); // a row of the table is a line
    if (const int use = ++uses[name]; use > 1)     // rows are told apart by it
      name += "#" + std::to_string (use);
    addPairs (options, sequence, name, work);
  }
  if (work.empty())
    throw UsageError ((options.path.empty() ? "--frames" : options.path) +
                      std::string (": no pair of frames; the sequences have too few "
                                   "frames for --step ") +
                      std::to_string (options.step));
  return work;
}

PairRunner::PairRunner (const EvaluateOptions& options)
: dataset_ (options.dataset)
, depth_scale_ (options.reading.depth_scale)
, names_ (options.methods)
{
  for (const std::string& name : names_)
    methods_.push_back (makeMethod (name, options.threads));
}

void
PairRunner::tellOnce (const WorkItem& item, int frame, const io::RgbdImages& images)
{
  const std::string name = item.name + ": frame " + std::to_string (frame);
  const auto tell = [&] (const std::string& kind, const std::string& text) {
    if (!text.empty() && told_.insert (item.name + kind).second)
      complain ("pcl_msf_evaluate", "warning: " + text);
  };
  if (!images.note.empty())
    tell (images.note, name + ": " + images.note);
  const DepthUnit unit{depth_scale_, item.sequence->definesDepthUnit()};
  tell ("depth", depthProblem (images.depth, name, unit));
}

std::vector<Row>
PairRunner::run (const WorkItem& item)
{
  const PairData pair = load (item);
  tellOnce (item, item.from, pair.reference);
  tellOnce (item, item.to, pair.current);
  const bool color = !pair.reference.color.empty();
  const PairScorer scorer (pair);
  cv::Mat seen;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < methods_.size(); ++i) {
    Row row{item.number, dataset_, item.name, item.from, item.to, names_[i], {}};
    const Method& method = *methods_[i];
    if ((color || !method.needsColor()) && method.canRun (pair)) {
      const PeakMemory memory;
      const Estimate estimate = method.run (pair);
      const double megabytes = memory.megabytes();
      if (seen.empty())
        seen = estimate.visible;
      row.score = scorer.score (estimate, seen);
      row.score.peak_mb = megabytes;
    }
    rows.push_back (std::move (row));
  }
  return rows;
}

} // namespace pcl_msf::tool
