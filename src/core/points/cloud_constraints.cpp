// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/cloud_constraints.h>

#include <algorithm>

namespace pcl_msf {

namespace {

constexpr double kHeaviestPair = 1e9;
constexpr float kHeaviestPoint = 1e6F;

const char*
wrongPairs (const std::vector<KnownPair>& pairs)
{
  for (const KnownPair& pair : pairs) {
    if (pair.source < 0 || pair.target < 0)
      return "indices of pairs must be >= 0";
    if (pair.cloud < 0)
      return "targets of pairs must be >= 0";
    if (!(pair.weight > 0.0 && pair.weight <= kHeaviestPair))
      return "weights of pairs must be in (0, 1e9]";
  }
  return nullptr;
}

const char*
wrongWeights (const std::vector<float>& weights)
{
  for (const float weight : weights)
    if (!(weight >= 0.0F && weight <= kHeaviestPoint))
      return "point_weights must be in [0, 1e6]";
  if (!weights.empty() && *std::max_element (weights.begin(), weights.end()) == 0.0F)
    return "point_weights must not all be 0";
  return nullptr;
}

const char*
wrongSegments (const CloudConstraints& constraints)
{
  for (const int label : constraints.fixed_segments)
    if (label < 0)
      return "labels in fixed_segments must be >= 0";
  for (const SegmentGuess& guess : constraints.guesses) {
    if (guess.segment < 0)
      return "labels in guesses must be >= 0";
    if (!guess.target_from_source.isFinite())
      return "poses in guesses must be finite";
  }
  return nullptr;
}

} // namespace

bool
CloudConstraints::isValid (std::string* why) const
{
  const char* wrong = wrongPairs (pairs);
  if (!wrong)
    wrong = wrongWeights (point_weights);
  if (!wrong)
    wrong = wrongSegments (*this);
  if (wrong && why)
    *why = wrong;
  return !wrong;
}

} // namespace pcl_msf
