// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/point_tuning.h"

namespace pcl_msf {

namespace {

TunedValues
matchingValues (PointTuning& tuning)
{
  PointMatchTuning& match = tuning.match;
  PointBrightnessTuning& brightness = tuning.brightness;
  IsometryTuning& isometry = tuning.isometry;
  return {{"points.clouds.most_points", &tuning.clouds.most_points, 100, 1e6},
          {"points.clouds.samples", &tuning.clouds.samples, 100, 1e6},
          {"points.clouds.least_samples", &tuning.clouds.least_samples, 3, 1e4},
          {"points.match.isotropy", &match.isotropy, 0, 1},
          {"points.match.backward", &match.backward, 0, 10},
          {"points.match.least_mutual", &match.least_mutual, 1e-6, 1},
          {"points.match.normal_length", &match.normal_length, 0, 100},
          {"points.match.least_normal", &match.least_normal, 0, 1},
          {"points.match.tight", &match.tight, 1e-6, 1},
          {"points.match.tight_normal", &match.tight_normal, 0, 1},
          {"points.match.tight_weight", &match.tight_weight, 0, 1},
          {"points.match.iterations", &match.iterations, 1, 100},
          {"points.match.one_side", &match.one_side, -1, 1},
          {"points.brightness.weight", &brightness.weight, 0, 1e3},
          {"points.brightness.part_weight", &brightness.part_weight, 0, 1e3},
          {"points.brightness.least_trust", &brightness.least_trust, 0, 1},
          {"points.brightness.agreement", &brightness.agreement, -1, 1},
          {"points.brightness.radius", &brightness.radius, 1, 100},
          {"points.brightness.neighbors", &brightness.neighbors, 6, 1000},
          {"points.brightness.outlying", &brightness.outlying, 0, 1e6},
          {"points.isometry.stretch", &isometry.stretch, 1e-4, 1},
          {"points.isometry.slack", &isometry.slack, 1e-4, 1},
          {"points.isometry.agreement", &isometry.agreement, 0, 1},
          {"points.isometry.sure_agreement", &isometry.sure_agreement, 0, 1},
          {"points.isometry.score", &isometry.score, 0, 1},
          {"points.isometry.way_back", &isometry.way_back, 1e-4, 1},
          {"points.isometry.near", &isometry.near, 1e-4, 10}};
}

TunedValues
limbValues (LimbTuning& limbs)
{
  return {{"points.limbs.rounds", &limbs.rounds, 0, 100},
          {"points.limbs.gain", &limbs.gain, 0, 1},
          {"points.limbs.cut", &limbs.cut, 0, 3},
          {"points.limbs.steps", &limbs.steps, 2, 1000},
          {"points.limbs.regularizer", &limbs.regularizer, 0, 100},
          {"points.limbs.from", &limbs.from, 1e-6, 10},
          {"points.limbs.to", &limbs.to, 1e-6, 10},
          {"points.limbs.match_from", &limbs.match_from, 1e-6, 10},
          {"points.limbs.hold", &limbs.hold, 0, 100},
          {"points.limbs.elsewhere", &limbs.elsewhere, 0, 10},
          {"points.limbs.conflicting", &limbs.conflicting, 0, 1},
          {"points.limbs.early_end", &limbs.early_end, 0, 1},
          {"points.limbs.uncovered", &limbs.uncovered, 0, 1},
          {"points.limbs.anchors", &limbs.anchors, 3, 10000},
          {"points.limbs.fewer_anchors", &limbs.fewer_anchors, 3, 10000},
          {"points.limbs.source_points", &limbs.source_points, 10, 1e6},
          {"points.limbs.target_points", &limbs.target_points, 10, 1e6},
          {"points.limbs.fit_rounds", &limbs.fit_rounds, 1, 100},
          {"points.limbs.fit_pairs", &limbs.fit_pairs, 3, 1000}};
}

TunedValues
windowValues (PointWindowTuning& window)
{
  return {{"points.window.from", &window.from, 1e-6, 10},
          {"points.window.to", &window.to, 1e-6, 10},
          {"points.window.steps", &window.steps, 0, 1000},
          {"points.window.near", &window.near, 1e-6, 10},
          {"points.window.regularizer", &window.regularizer, 0, 100}};
}

TunedValues
sectionValues (LimbSectionTuning& sections)
{
  return {{"points.parts.section.filled", &sections.filled, 0, 1},
          {"points.parts.section.rounds", &sections.rounds, 0, 1000},
          {"points.parts.section.from", &sections.from, 0, 100},
          {"points.parts.section.to", &sections.to, 0, 100}};
}

TunedValues
partValues (PointTuning& tuning)
{
  PointPartTuning& parts = tuning.parts;
  PointResultTuning& result = tuning.result;
  return {{"points.parts.allowance", &parts.allowance, 0, 1e6},
          {"points.parts.per_point", &parts.per_point, 0, 1e3},
          {"points.parts.rigid_share", &parts.rigid_share, 0, 1},
          {"points.parts.free", &parts.free, 0, 1},
          {"points.parts.seam", &parts.seam, 0, 1e3},
          {"points.parts.polish", &parts.polish, 1, 100},
          {"points.parts.outlying", &parts.outlying, 0, 1e6},
          {"points.parts.absorb", &parts.absorb, 0, 100},
          {"points.parts.worse", &parts.worse, 0, 100},
          {"points.parts.worse_share", &parts.worse_share, 0, 10},
          {"points.parts.smoothing", &parts.smoothing, 0, 100},
          {"points.parts.least_weight", &parts.least_weight, 0, 1},
          {"points.parts.floor", &parts.floor, 1e-6, 10},
          {"points.parts.reach", &parts.reach, 1e-3, 100},
          {"points.parts.limit", &parts.limit, 1e-3, 1000},
          {"points.parts.normal_length", &parts.normal_length, 0, 1},
          {"points.parts.isotropy", &parts.isotropy, 0, 1},
          {"points.result.found", &result.found, 1e-3, 1000},
          {"points.result.facing", &result.facing, -1, 1},
          {"points.result.normal_length", &result.normal_length, 0, 1},
          {"points.result.joint_share", &result.joint_share, 0, 1},
          {"points.result.unexplained", &result.unexplained, 0, 1},
          {"points.result.least_source", &result.least_source, 0, 1},
          {"points.result.border", &result.border, 0, 100},
          {"points.result.loose", &result.loose, 0, 1},
          {"points.result.scattered", &result.scattered, 0, 1},
          {"points.result.gap", &result.gap, 0, 100},
          {"points.result.overlap.most", &result.overlap.most, 0, 1},
          {"points.result.overlap.near", &result.overlap.near, 0, 1000},
          {"points.result.overlap.apart", &result.overlap.apart, 0, 1000},
          {"points.result.overlap.facing", &result.overlap.facing, -1, 1},
          {"points.result.overlap.neighbors", &result.overlap.neighbors, 2, 1000},
          {"points.result.overlap.samples", &result.overlap.samples, 1, 1e7}};
}

TunedValues
wholeValues (WholeTuning& whole)
{
  return {{"points.whole.from", &whole.from, 1e-6, 10},
          {"points.whole.to", &whole.to, 1e-6, 10},
          {"points.whole.steps", &whole.steps, 2, 1000},
          {"points.whole.near", &whole.near, 1e-6, 1},
          {"points.whole.spacings", &whole.spacings, 0, 100},
          {"points.whole.left", &whole.left, 0, 1},
          {"points.whole.least", &whole.least, 0, 1}};
}

} // namespace

void
listValues (PointTuning& tuning, TunedValues& values)
{
  for (const TunedValues& own : {matchingValues (tuning),
                                 limbValues (tuning.limbs),
                                 wholeValues (tuning.whole),
                                 windowValues (tuning.window),
                                 sectionValues (tuning.parts.section),
                                 partValues (tuning)})
    values.insert (values.end(), own.begin(), own.end());
  for (std::size_t i = 0; i < tuning.stages.size(); ++i) {
    const std::string name = "points.stage_" + std::to_string (i) + ".";
    PointStage& stage = tuning.stages[i];
    values.push_back ({name + "segments", &stage.segments, 1, 1e5});
    values.push_back ({name + "regularizer", &stage.regularizer, 0, 100});
    values.push_back ({name + "from", &stage.from, 1e-6, 10});
    values.push_back ({name + "to", &stage.to, 1e-6, 10});
    values.push_back ({name + "steps", &stage.steps, 1, 1000});
  }
}

} // namespace pcl_msf
