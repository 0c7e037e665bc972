// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/tuned_value.h"

#include <array>

namespace pcl_msf {

// Values of the solve on points without a grid. A "size" is the source's, a "spacing"
// the target's median distance between neighbours. All were chosen on pairs of clouds
// of bodies with exact correspondences; see "Far limbs by geodesic anchors" in
// DECISIONS.md.

/** \brief How many points take part. */
struct PointCloudTuning {
  int most_points{
      40000};        ///< of a cloud; others move as their neighbours; more is slower
  int samples{4000}; ///< of these in all solves but the last; more is slower
  int least_samples{12}; ///< of a given segment: fewer leave its motion open
};

/** \brief How points are matched. */
struct PointMatchTuning {
  double isotropy{0.1}; ///< share of point-to-point in point-to-plane: more holds
                        ///< against sliding, less lets surfaces slide to fit
  double backward{1.0}; ///< weight of the target's points' own matches: less leaves
                        ///< parts of the target bare
  double least_mutual{0.02}; ///< sizes: least scale of the way there and back: less
                             ///< leaves few matches
  double normal_length{1.0}; ///< what a difference of normals of 1 counts as, scales of
                             ///< the distance: more tells sides apart, less turns far
  double least_normal{0.01}; ///< sizes: that length is no smaller; likewise
  double tight{0.01}; ///< sizes: distance of pairs that are surely right: more lets
                      ///< wrong ones in
  double tight_normal{0.02}; ///< sizes: length of normals for these; less does, too
  double tight_weight{0.4};  ///< least robust weight of such a pair: likewise
  int iterations{1};    ///< of the solver between two searches for matches; more is
                        ///< slower
  float one_side{0.3f}; ///< least cosine between normals of one side, for known
                        ///< pairs: less takes the back of thin parts for the front
};

/** \brief How brightness takes part where both clouds have some. */
struct PointBrightnessTuning {
  double weight{0.3}; ///< of a difference over the texture's slope, squared, beside
                      ///< a squared distance in the solve: more lets colours that
                      ///< contradict the shape lead astray, less leaves what slides
  double part_weight{1.0}; ///< likewise where parts are told, beside its own noise
  double radius{3.0};   ///< of the planes fitted to it, spacings of the sparser cloud:
                        ///< more sees through noise, less keeps fine texture
  int neighbors{48};    ///< in that radius at the most; more is slower
  double outlying{2.5}; ///< deviations: scale of the robust weight
  double least_trust{0.3}; ///< share of the texture's squared gradients that is no
                           ///< noise, at least: less may be chance
  double agreement{0.8};   ///< least correlation between points and their matches in
                           ///< the end: with less, colours are of something else
};

/** \brief How much bending may change distances along the surface. */
struct IsometryTuning {
  float stretch{
      0.08f}; ///< of a distance: more matches what bends, and what is elsewhere
  float slack{0.015f};    ///< sizes, besides: what sampling does; likewise
  double agreement{0.55}; ///< of an anchor with the others, mean, at least: more leaves
                          ///< few anchors, less lets wrong ones in
  double sure_agreement{0.72}; ///< when that has led to nothing
  float score{0.5f};           ///< of a match, at least: likewise
  float way_back{0.04f};       ///< sizes: scale of the way there and back: likewise
  float near{0.1f};            ///< sizes: nearer anchors all count alike; more tells
                               ///< less of a place
};

/** \brief A resolution of the solve. Lengths in sizes. */
struct PointStage {
  int segments;       ///< of the source: more bends more, and is slower
  double regularizer; ///< gamma: more is stiffer
  double from; ///< scale of the matches' robust weight in the first step: more reaches
               ///< farther, and lets wrong matches in
  double to;   ///< and in the last one: more is smoother where surfaces differ
  int steps;   ///< more is slower
};

/** \brief Limbs that moved far, started anew from distances along the surface. */
struct LimbTuning {
  int rounds{6};           ///< of starting anew, at the most; more is slower
  double gain{2e-3};       ///< of what is explained, for one more round; less is slower
  int cut{2};              ///< the stage whose segments are started: more finds small
                           ///< limbs, and fits fewer pairs each
  int steps{15};           ///< along the pairs; more is slower
  double regularizer{0.2}; ///< gamma meanwhile: more bends less
  double from{0.2}; ///< sizes: scale of the pairs' robust weight, at first: more lets
                    ///< wrong ones pull
  double to{0.03};  ///< and last
  double match_from{0.15};  ///< sizes: scale of the matches that follow, at first: less
                            ///< keeps what the pairs are wrong about
  double hold{0.3};         ///< share of the pairs in these matches, at first: more
                            ///< keeps what they are wrong about
  double elsewhere{0.06};   ///< sizes: a pair this far apart conflicts with the motion;
                            ///< less is slower
  double conflicting{0.04}; ///< share of the pairs that may do so without a fresh
                            ///< start: more loses limbs, less is slower
  double early_end{0.01};   ///< less of what was explained: a fresh start ends early;
                            ///< more is slower
  double uncovered{0.005};  ///< share of both clouds that may be off the other one
                            ///< without a fresh start: more loses limbs
  int anchors{80};          ///< pairs that may be; more is slower
  int fewer_anchors{50};    ///< when these have led to nothing; likewise
  int source_points{1000};  ///< points that are matched by isometry; more is slower
  int target_points{2000};  ///< and those they are matched with; likewise
  int fit_rounds{5};        ///< of the robust fit of a segment to its pairs; likewise
  int fit_pairs{4};         ///< that determine a segment's motion: more leaves small
                            ///< segments to their neighbours
};

/** \brief The cross-section at which a limb is held; see "Limbs turn about their
 * middle" in DECISIONS.md. */
struct LimbSectionTuning {
  double filled{0.8}; ///< share of the directions about the middle that have points: a
                      ///< tube; less holds what is none
  int rounds{3};      ///< of centering; more is slower
  double from{0.5};   ///< mean radii from the seam to where the section begins: less
                      ///< has what bends there tell
  double to{2.5};     ///< and where it ends: more has what is another limb tell
};

/** \brief What moves as one. */
struct PointPartTuning {
  LimbSectionTuning section;
  double allowance{10.0};   ///< of a merge, halved squared deviations: more makes fewer
                            ///< parts
  double per_point{0.25};   ///< further, per point of the smaller part: likewise
  double rigid_share{0.02}; ///< of the points: a body of its own, else motions blend:
                            ///< more blends more
  double free{0.03};    ///< share of what holds a body: held less in a direction, its
                        ///< seams hold it there; more leaves fewer to them
  double seam{0.1};     ///< weight of an edge of a seam then: more keeps joints closed
  int polish{4};        ///< rounds of fitting the bodies' motions; more is slower
  double outlying{2.5}; ///< deviations from the plane: scale of the weight then;
                        ///< more lets wrong matches in
  int absorb{5};        ///< rounds of joining what fits a larger body as well; more
                        ///< is slower
  double worse{0.12};   ///< spacings that joining may cost: more makes fewer parts
  double worse_share{0.1};  ///< and a share of the part's own distance: likewise
  int smoothing{2};         ///< rounds over neighbours when borders are drawn: more
                            ///< is smoother
  double least_weight{0.1}; ///< robust weight of matches that tell the deviation: less
                            ///< has wrong ones tell
  double floor{0.1}; ///< spacings: least deviation; planes are no better; more makes
                     ///< fewer parts
  double reach{2.0}; ///< spacings: scale of matches between parts: more takes farther
                     ///< points for their own
  double limit{3.0}; ///< spacings: farther is no match; likewise
  double normal_length{0.01}; ///< sizes: what a difference of normals of 1 counts as:
                              ///< more tells sides apart
  double isotropy{0.01};      ///< keeps near what planes leave free: more hinders
                              ///< sliding to fit
};

/** \brief Where a surface lies on itself; see "A surface cannot lie on itself" in
 * DECISIONS.md. */
struct SelfOverlapTuning {
  double most{0.04};  ///< share of the source that may: more hides limbs that ended on
                      ///< others, less refuses sharp bends
  double near{3.0};   ///< spacings between points that lie on each other: more takes
                      ///< what touches for it
  double apart{9.0};  ///< spacings that they had: less takes creases for it, more
                      ///< overlooks thin limbs
  float facing{0.5f}; ///< least cosine between their normals: less takes what touches
                      ///< for it
  int neighbors{32};  ///< that are looked at, about those that are near on two
                      ///< surfaces; more is slower
  int samples{4000};  ///< of the source; likewise
};

/** \brief When one rigid motion of all is the answer; see "Parts must explain what one
 * motion leaves" in DECISIONS.md. */
struct WholeTuning {
  double from{0.1};  ///< sizes: scale of the matches' robust weight in the first step
  double to{0.01};   ///< and in the last one
  int steps{30};     ///< more is slower
  double near{0.01}; ///< sizes: a point this near the other cloud is covered ...
  double spacings{1.5}; ///< ... or this many spacings of the target: more sees less of
                        ///< what is wrong
  double left{0.6};     ///< of what one motion leaves uncovered: parts that leave more
                        ///< give way; more believes in parts that are chance
  double least{0.04};   ///< share that is left at all events before this is asked: less
                        ///< is slower
};

/** \brief What is told of the result. */
struct PointResultTuning {
  SelfOverlapTuning overlap;
  double found{4.0};          ///< spacings: a surface is seen there; more finds what is
                              ///< not
  float facing{-0.15f};       ///< least cosine between its normals: below a right angle
                              ///< by their error, as walls that a joint opens meet the
                              ///< moved surface at right angles
  double normal_length{0.02}; ///< sizes: what a difference of normals of 1 counts as:
                              ///< more finds less
  double joint_share{0.02};   ///< of the points: a part that has joints; less finds
                              ///< joints of scraps
  double unexplained{0.02};  ///< of both clouds, without a cut: it lies elsewhere; more
                             ///< hides lost limbs
  double least_source{0.05}; ///< share of the source that must be found; less lets
                             ///< other bodies pass
  double border{1.0};        ///< spacings of samples: so near a cut is at its border;
                             ///< more hides lost limbs
  double loose{0.02};        ///< share of the target in one piece that may be bare
                             ///< without a cut in the source: more hides lost limbs
  double scattered{0.4};     ///< of both clouds: more may not lie off each other where
                             ///< parts gave way to one motion: more believes in it
  double gap{0.2}; ///< radii of a segment between neighbours, mean: more hides
                   ///< torn surfaces
};

/** \brief Several targets solved jointly. Lengths in sizes. */
struct PointWindowTuning {
  double from{0.01}; ///< scale of the matches' robust weight in the first step: more
                     ///< lets wrong ones in
  double to{0.005};  ///< and in the last one: more is smoother where surfaces differ
  int steps{8};      ///< more is slower
  double near{0.02}; ///< points of a target that go with the moved source: more takes
                     ///< what is not of it
  double regularizer{0.002}; ///< gamma between targets: more keeps joints from bending
};

/** \brief The solve on points. */
struct PointTuning {
  PointCloudTuning clouds;
  PointMatchTuning match;
  PointBrightnessTuning brightness;
  std::array<PointStage, 4> stages{{{30, 0.6, 0.10, 0.06, 10},
                                    {60, 0.2, 0.08, 0.03, 15},
                                    {150, 0.06, 0.05, 0.02, 15},
                                    {400, 0.02, 0.03, 0.005, 15}}};
  IsometryTuning isometry;
  LimbTuning limbs;
  WholeTuning whole;
  PointWindowTuning window;
  PointPartTuning parts;
  PointResultTuning result;
};

void
listValues (PointTuning& tuning, TunedValues& values);

} // namespace pcl_msf
