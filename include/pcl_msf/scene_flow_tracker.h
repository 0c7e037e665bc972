// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/multiframe_scene_flow.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/parameters.h>
#include <pcl_msf/rgbd_frame.h>

#include <memory>
#include <string>

namespace pcl_msf {

class FrameTracker;

/** \brief How a SceneFlowTracker goes from frame to frame. */
struct PCL_MSF_EXPORT TrackerParameters {
  int window{0}; ///< 0: each frame is followed from the reference, from where its
                 ///< bodies should be by now; [2, 16]: so many frames are kept and
                 ///< solved jointly (section 3.1), which takes five times as long
  double least_visible{0.5};   ///< share of the reference's points seen in the newest
                               ///< frame below which the window begins anew, [0, 1]
  double least_explained{0.5}; ///< share of the newest frame's points that a segment of
                               ///< the reference covers below which it begins anew
  bool dense{true}; ///< fill in the images of results: without, these are empty, which
                    ///< takes less time where segments, groups and poses are enough;
                    ///< a segment's points are then counted on a pattern of pixels
  bool merge_segments{
      false}; ///< of a window: segments that moved as one rigid body over a full
              ///< window become one, until the reference is given up
              ///< (they never split). Faster, but what a window takes
              ///< for one stays one: not for scenes with slow objects

  bool
  isValid (std::string* why = nullptr) const;
};

/** \brief Scene flow of an endless sequence, frame by frame, from a reference that
 * stays.
 *
 * The first frame is the reference: its points and segments are followed. Each new
 * frame is solved from where the reference's bodies should be by now: at their last
 * speed, at rest, or by what all have done together, as a coarse registration of the
 * whole frame tells. Only segments that do not fit there are looked for, and when they
 * are many, the whole frame. What the frames measure is averaged into the reference's
 * depth. Once the newest frame and the reference show too little of each other, or the
 * motion is lost, the newest frame becomes the reference, with segments of its own.
 *
 * With a window, the frames kept are solved jointly instead (section 3.1); motions
 * between frames that the window held before are where it starts. When the window is
 * full, the oldest frame beside the reference leaves. Windows of two frames go from
 * frame to frame.
 *
 * Memory does not grow with the number of frames. Not thread-safe; different trackers
 * are independent.
 */
class PCL_MSF_EXPORT SceneFlowTracker {
public:
  SceneFlowTracker();
  /** \throws InvalidInput for parameters outside their ranges */
  SceneFlowTracker (const TrackerParameters& tracker,
                    const SegmentationParameters& segmentation,
                    const EnergyParameters& energy,
                    const SolverParameters& solver,
                    const MultiframeParameters& multiframe);
  SceneFlowTracker (const SceneFlowTracker& other);
  SceneFlowTracker&
  operator= (const SceneFlowTracker& other);
  /** \brief The other one is left as the first constructor makes it. */
  SceneFlowTracker (SceneFlowTracker&& other);
  SceneFlowTracker&
  operator= (SceneFlowTracker&& other);
  ~SceneFlowTracker();

  /** \brief Takes the next frame; it needs normals. With the first one there is no
   * motion yet. After an exception the tracker is as before, and the next frame may
   * follow.
   * \throws InvalidInput when the frame is empty or does not fit the ones before
   * (size, colour) */
  void
  add (const RgbdFrame& frame);

  /** \brief Forgets all frames; the trajectory begins at the identity again. */
  void
  reset ();

  /** \brief Frames in the window; without one at most two, the reference and the
   * newest.
   */
  int
  frames () const;
  /** \brief How many frames were given before the window's reference. */
  long
  firstFrame () const;
  /** \brief How many frames were given before a frame of the window.
   * \param frame 0 to frames () - 1 \throws InvalidInput for others */
  long
  frameIndex (int frame) const;

  /** \brief The window's result; frame 0 is its reference. No frames before the second
   * add. */
  const MultiframeSceneFlow&
  result () const;
  /** \brief The motion from the window's reference to the newest frame; empty before
   * the second add. */
  const SceneFlow&
  sceneFlow () const;

  /** \brief Segments of the window's reference. */
  const Oversegmentation&
  segments () const;

  /** \brief Camera pose of the newest frame if the dominant motion is that of the
   * static scene: `world_from_camera`, the first frame's camera being the world. */
  RigidPose
  cameraPose () const;

private:
  std::unique_ptr<FrameTracker> own_;
};

} // namespace pcl_msf
