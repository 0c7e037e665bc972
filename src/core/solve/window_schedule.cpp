// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/solve/window_solve.h"

#include <algorithm>
#include <cmath>

/* The rounds of WindowSolve. */
namespace pcl_msf {

/** From coarse to fine. At the coarsest level, segments that start at one pose are
 * solved for as one body, of which there are far fewer; at the two finest ones,
 * segments that move as one merge: above the finest one before it is solved, too, as
 * bodies are steadier than segments. The finest level is about half of the work, the
 * start a fifth. */
std::vector<WindowSolve::Round>
WindowSolve::pairSchedule (int finest_level) const
{
  std::vector<Round> rounds;
  const SolveTuning& tuning = scene_.tuning.solve;
  const int finest = std::min (finest_level, levels_ - 1);
  const int coarsest = std::min (tuning.coarsest_level, levels_ - 1);
  const int few = std::min (user_.max_iterations, tuning.later_iterations);
  for (int level = coarsest; level >= finest; --level) {
    const double begin = level == 0 ? 0.5 : 0.5 - 0.15 * level;
    Round round{"solve",
                level,
                begin,
                begin + (level == 0 ? 0.3 : 0.15),
                level == coarsest ? user_.max_iterations : few};
    round.propose = round.merge = level < tuning.coarsest_level;
    round.presort = round.rescale_noise =
        user_.merge_bodies && 0 < level && level < coarsest;
    round.results = level == 0;
    if (level == 0 && coarsest > 0)
      round.iterations = std::min (few, tuning.finest_iterations);
    round.together = level == tuning.coarsest_level && !apart_;
    rounds.push_back (round);
    if (level == tuning.coarsest_level)
      addSpreads (rounds);
    else if (level > 0 && user_.merge_bodies)
      addBodies (rounds);
  }
  if (finest > 0)
    return rounds;
  if (user_.merge_bodies) {
    rounds.push_back ({"bodies", 0, 0.8, 1.0, few});
    rounds.back().anew = false;
    rounds.back().rescale_noise = true;
  }
  rounds.back().last = true;
  return rounds;
}

/** Above the finest level bodies are found twice, which is cheap there: those that move
 * as one body fit their place better than the segments did, so more of them find
 * theirs. */
void
WindowSolve::addBodies (std::vector<Round>& rounds) const
{
  Round again = rounds.back();
  rounds.back().end = again.begin = 0.5 * (again.begin + again.end);
  again.stage = "bodies";
  again.anew = again.propose = false;
  again.rescale_noise = true;
  rounds.push_back (again);
}

/** At the coarsest level, segments that lie beyond the start's reach get their motions
 * from neighbours, step by step: as the end of a sheet that bends. */
void
WindowSolve::addSpreads (std::vector<Round>& rounds) const
{
  const int spreads = scene_.tuning.solve.spreads;
  const double share = (rounds.back().end - rounds.back().begin) / (1 + spreads);
  rounds.back().end = rounds.back().begin + share;
  for (int i = 0; i < spreads; ++i) {
    Round again = rounds.back();
    again.begin += share;
    again.end += share;
    again.anew = false;
    again.spread = true;
    if (i + 1 == spreads)
      again.together = false; // each for itself, as what bends needs
    again.iterations = static_cast<int> (
        std::ceil (scene_.tuning.solve.spread_share * user_.max_iterations));
    again.measure = i + 1 == spreads;
    rounds.push_back (again);
  }
}

/** The start has solved the pairs from the reference. Bodies merge before the first
 * solve: what the frames tell together they did not tell one by one. Of coloured frames
 * half resolution is left out: the start has been there, and a joint solve of it drags
 * bodies away by shades that differ between frames. */
std::vector<WindowSolve::Round>
WindowSolve::windowSchedule() const
{
  const int few = std::min (user_.max_iterations, scene_.tuning.solve.later_iterations);
  std::vector<Round> rounds;
  if (!frames_[pairs_.reference()].hasIntensity() && levels_ > 1)
    rounds.push_back ({"window", 1, 0.0, 0.0, user_.max_iterations});
  for (int i = 0; i < 2; ++i) {
    rounds.push_back ({"window", 0, 0.0, 0.0, few});
    rounds.back().rescale_noise = true;
  }
  const double share = (1.0 - kStartShare) / static_cast<double> (rounds.size());
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    rounds[i].begin = kStartShare + static_cast<double> (i) * share;
    rounds[i].end = rounds[i].begin + share;
    rounds[i].merge = i + 1 < rounds.size();
  }
  rounds.front().presort = true;
  rounds.back().fuse = rounds.back().results = true;
  return rounds;
}

/** Of motions that are nearly known: bodies are formed at half resolution, the finest
 * level only moves them. */
std::vector<WindowSolve::Round>
WindowSolve::followSchedule() const
{
  const SolveTuning& tuning = scene_.tuning.solve;
  const int coarsest = std::min (tuning.start_level, levels_ - 1);
  const int few = std::min (user_.max_iterations, tuning.later_iterations);
  std::vector<Round> rounds;
  for (int level = coarsest; level >= 0; --level) {
    rounds.push_back ({"follow",
                       level,
                       level == 0 ? 0.6 : 0.2,
                       level == 0 ? 1.0 : 0.6,
                       level == 0 ? tuning.finest_iterations : few});
    rounds.back().anew = level < coarsest; // startFollowing () entered that one
    rounds.back().rescale_noise = true;
    rounds.back().merge = level > 0 || coarsest == 0;
    rounds.back().keep_worth = true;
    rounds.back().results = level == 0;
  }
  rounds.back().last = true;
  return rounds;
}

} // namespace pcl_msf
