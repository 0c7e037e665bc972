// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/start/pair_start.h"

#include "core/base/meanwhile.h"
#include "core/frame/light_change.h"
#include "core/segments/segment_graph.h"
#include "core/segments/surface_links.h"
#include "core/start/far_motions.h"
#include "core/start/flow_precision.h"
#include "core/start/pose_proposals.h"

#include <algorithm>
#include <utility>

namespace pcl_msf {

namespace {

RigidFitOptions
fitOptions (const WindowScene& scene)
{
  const NoiseModel& noise = scene.noise;
  return {scene.frames[scene.pairs[0].to].camera(),
          scene.tuning.start.flow.noise * noise.inverse_depth,
          scene.tuning.start.flow.noise * noise.relative_depth,
          scene.tuning.start.fit};
}

} // namespace

PairStart::PairStart (WindowScene& scene,
                      const EnergyParameters& energy,
                      const SolverParameters& solver)
: scene_ (scene)
, energy_ (energy)
, solver_ (solver)
, reference_ (scene.frames[scene.pairs[0].from])
, current_ (scene.frames[scene.pairs[0].to])
{}

std::vector<RigidPose>
PairStart::run (const cv::Mat& labels,
                int at,
                const RigidPose& guess,
                const std::vector<RigidPose>& given)
{
  Meanwhile<CoarseFlow> depth_flow;
  if (solver_.flow_proposals && given.empty())
    depth_flow = meanwhile (scene_.threads, [this] {
      return estimateDepthFlow (reference_, current_, scene_.tuning.start.flow);
    });
  SegmentPixels points =
      probePoints (reference_.levels()[at], labels, scene_, pointOptions (scene_, at));
  linkSegments (labels, at, points);
  FlowHypotheses flow;
  optical_ = {};
  if (solver_.flow_proposals && reference_.hasIntensity()) {
    optical_ = estimateOpticalFlow (
        reference_, current_, scene_.tuning.start.flow, scene_.threads - 1);
    flow = liftOptical (optical_, at, guess, points);
  }
  if (!given.empty())
    return given;
  std::vector<RigidPose> poses (scene_.segments, guess);
  common_ = {guess, RigidPose{}};
  const Texture texture (comparable (current_.levels()[at]));
  DataTerm probes (points,
                   texture,
                   makeRules (energy_, points, scene_.tuning.data.missing),
                   scene_.threads);
  if (scene_.flow)
    probes.setFlow (*scene_.flow, 1.0 / residualScale (energy_, points), 0.0);
  suggest (probes, at, flow, poses);
  const std::vector<char> wanted = unexplained (probes, poses);
  if (solver_.flow_proposals &&
      std::find (wanted.begin(), wanted.end(), 1) != wanted.end())
    suggest (probes, at, lift (depth_flow.get(), at, guess, points, wanted), poses);
  if (!optical_.flow.empty() && lostShare (probes, poses) > scene_.tuning.start.lost &&
      (flow.bodies.empty() || !followsFlow (flow.samples, flow.bodies.front())))
    suggestFarMotions (optical_, at, guess, points, probes, poses);
  return poses;
}

void
PairStart::linkSegments (const cv::Mat& labels, int at, const SegmentPixels& points)
{
  scene_.links = linkNearestCentroids (points.centroid, energy_.neighbors);
  weighLinksBySurface (labels,
                       reference_.levels()[at],
                       reference_.inverseDepthNoise(),
                       scene_.tuning.segments,
                       scene_.links);
}

FlowHypotheses
PairStart::lift (const CoarseFlow& flow,
                 int at,
                 const RigidPose& guess,
                 const SegmentPixels& points,
                 const std::vector<char>& wanted) const
{
  return hypothesesFromFlow (flow,
                             current_,
                             points,
                             wanted,
                             at,
                             scene_.noise,
                             guess,
                             scene_.tuning.start,
                             scene_.threads);
}

/** Motions of the optical flow, which tells the exposure and stays as evidence. */
FlowHypotheses
PairStart::liftOptical (const CoarseFlow& optical,
                        int at,
                        const RigidPose& guess,
                        SegmentPixels& points)
{
  const std::vector<char> all (scene_.segments, 1);
  FlowHypotheses flow = lift (optical, at, guess, points, all);
  scene_.flow =
      std::make_unique<FlowEvidence> (evidenceOfFlow (flow,
                                                      reference_,
                                                      current_.camera(),
                                                      scene_.noise,
                                                      scene_.tuning.start.evidence,
                                                      scene_.threads));
  scene_.change = fitBrightnessChange (flow.matches, scene_.tuning.frame.brightness);
  changeBrightness (at, points);
  return flow;
}

/** Brings the points' intensities to the current frame's. */
void
PairStart::changeBrightness (int at, SegmentPixels& points) const
{
  const cv::Mat intensity = comparable (reference_.levels()[at]).intensity;
  const int width = intensity.cols;
  for (std::size_t i = 0; i < points.pixel.size(); ++i)
    points.intensity[i] =
        scene_.change.gain *
            intensity.at<float> (points.pixel[i] / width, points.pixel[i] % width) +
        scene_.change.offset;
}

/** The level with what both frames show alike of its brightness. */
FrameLevel
PairStart::comparable (FrameLevel level) const
{
  if (scene_.change.local)
    level.intensity =
        localContrast (level.intensity, scene_.tuning.frame.brightness.contrast_radius);
  return level;
}

/** The motions that many share become common to all segments. */
void
PairStart::suggest (const DataTerm& probes,
                    int at,
                    const FlowHypotheses& from,
                    std::vector<RigidPose>& poses)
{
  common_.insert (common_.end(), from.bodies.begin(), from.bodies.end());
  propose (probes,
           reference_.levels()[at].camera.fx,
           from,
           scene_.tuning.start.evidence.proposing,
           scene_.tuning.start.proposals.first_rounds,
           {},
           poses);
}

/** Motions of matched features; where they contradict the flow, it is forgotten. */
void
PairStart::suggestFarMotions (const CoarseFlow& optical,
                              int at,
                              const RigidPose& guess,
                              SegmentPixels& points,
                              DataTerm& probes,
                              std::vector<RigidPose>& poses)
{
  const FarMotions far = findFarMotions (reference_,
                                         current_,
                                         optical,
                                         guess,
                                         fitOptions (scene_),
                                         scene_.tuning.start.far_motion,
                                         scene_.threads);
  if (far.instead_of_flow) {
    probes.dropFlow();
    scene_.flow.reset();
    compareExposure (far.motions.front(), at, points);
    poses.assign (scene_.segments, guess);
    common_ = {guess, RigidPose{}};
  }
  if (far.motions.empty())
    return;
  FlowHypotheses matched;
  matched.bodies = far.motions;
  suggest (probes, at, matched, poses);
}

void
PairStart::proposeAgain (const WindowLevel& level, std::vector<RigidPose>& poses) const
{
  propose (level.probes (0),
           level.focalLength(),
           {},
           0.0,
           scene_.tuning.start.proposals.later_rounds,
           {},
           poses);
}

int
PairStart::proposeToLost (const WindowLevel& level, std::vector<RigidPose>& poses) const
{
  return proposeTo (unexplained (level.probes (0), poses), level, poses);
}

int
PairStart::proposeTo (std::vector<char> segments,
                      const WindowLevel& level,
                      std::vector<RigidPose>& poses) const
{
  return propose (level.probes (0),
                  level.focalLength(),
                  {},
                  0.0,
                  scene_.tuning.start.proposals.later_rounds,
                  std::move (segments),
                  poses);
}

/** Lets segments jump to the common poses, their flow's and their neighbours'. */
int
PairStart::propose (const DataTerm& probes,
                    double focal_length,
                    const FlowHypotheses& flow,
                    double flow_worth,
                    int rounds,
                    std::vector<char> moving,
                    std::vector<RigidPose>& poses) const
{
  PoseProposals proposals (probes,
                           scene_.links,
                           energy_,
                           focal_length,
                           scene_.tuning.start.proposals,
                           scene_.threads);
  proposals.weighFlow (flow_worth);
  for (const RigidPose& pose : common_)
    proposals.addCommon (pose);
  for (std::size_t k = 0; k < flow.fitted.size(); ++k)
    if (flow.fitted[k])
      proposals.addOwn (static_cast<int> (k), flow.of_segment[k]);
  if (!moving.empty())
    proposals.restrictTo (std::move (moving));
  return proposals.run (rounds, poses);
}

/** Fits the exposure anew, where points go by a motion that most of the image shares;
 * whether light changed stays as the flow told. */
void
PairStart::compareExposure (const RigidPose& pose, int at, SegmentPixels& points)
{
  const cv::Mat from_image = comparable (reference_.levels()[at]).intensity;
  const FrameLevel level = comparable (current_.levels()[at]);
  const UnpackedPose motion (pose);
  std::vector<float> from;
  std::vector<float> to;
  for (std::size_t i = 0; i < points.pixel.size(); ++i) {
    const Eigen::Vector3d q =
        motion.rotation * Eigen::Vector3d (points.x[i], points.y[i], points.z[i]) +
        motion.translation;
    if (!(q.z() > 0.0))
      continue;
    const int u = cvRound (level.camera.fx * q.x() / q.z() + level.camera.cx);
    const int v = cvRound (level.camera.fy * q.y() / q.z() + level.camera.cy);
    if (u < 0 || v < 0 || u >= level.width() || v >= level.height())
      continue;
    if (std::abs (level.inverse_depth.at<float> (v, u) * q.z() - 1.0) >
        scene_.tuning.start.same_depth)
      continue;
    from.push_back (from_image.at<float> (points.pixel[i] / level.width(),
                                          points.pixel[i] % level.width()));
    to.push_back (level.intensity.at<float> (v, u));
  }
  const bool local = scene_.change.local;
  scene_.change = fitExposureChange (from, to, scene_.tuning.frame.brightness);
  if (local)
    scene_.change.offset = 0.0f;
  scene_.change.local = local;
  changeBrightness (at, points);
}

double
PairStart::lostShare (const DataTerm& probes, const std::vector<RigidPose>& poses) const
{
  const std::vector<char> lost = unexplained (probes, poses);
  const auto count = static_cast<double> (std::count (lost.begin(), lost.end(), 1));
  return count / std::max<double> (1.0, static_cast<double> (lost.size()));
}

/** Does much of the flow follow one motion? Then it has not lost the scene, even where
 * residuals are larger than the noise explains. */
bool
PairStart::followsFlow (const SampleTable& flow, const RigidPose& pose) const
{
  const std::vector<float> errors =
      sampleErrors (flow.samples.data(),
                    static_cast<int> (flow.samples.size()),
                    pose,
                    fitOptions (scene_));
  const FarMotionTuning& far = scene_.tuning.start.far_motion;
  const auto following =
      std::count_if (errors.begin(), errors.end(), [&far] (float error) {
        return error < far.explained * far.agree;
      });
  return static_cast<double> (following) >
         (1.0 - scene_.tuning.start.lost) * static_cast<double> (errors.size());
}

/** Which segments do not fit the current frame at their present poses. */
std::vector<char>
PairStart::unexplained (const DataTerm& probes,
                        const std::vector<RigidPose>& poses) const
{
  std::vector<char> result (scene_.segments, 0);
  for (int k = 0; k < scene_.segments; ++k) {
    const DataTerm::Probe probe = probes.probe (k, poses[k]);
    result[k] = probe.cost + probe.hidden * probe.weight * probes.isolatedHiddenCost() >
                scene_.tuning.start.unexplained * probe.weight;
  }
  return result;
}

} // namespace pcl_msf
