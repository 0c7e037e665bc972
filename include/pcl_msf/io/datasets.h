// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_sequence.h>
#include <pcl_msf/pinhole_camera.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_msf::io {

/** \brief Which rendering of a data set. */
enum class RenderPass {
  Clean,
  Final ///< with motion blur, haze and the like
};

/** \brief "clean", "final" */
PCL_MSF_EXPORT const char*
toString (RenderPass pass);

/** \brief Which camera of a stereo rig. */
enum class StereoView { Left, Right };

/** \brief "left", "right" */
PCL_MSF_EXPORT const char*
toString (StereoView view);

/** \brief What a data set does not say of itself, or what is to be taken instead. */
struct DatasetOptions {
  /** \brief Camera of all frames, pixels; none (default) = the data set's own. */
  std::optional<PinholeCamera> camera;

  /** \brief Distortion of all frames, from which they are freed when they are read;
   * none (default) = the data set's own, where it says one, and none with `camera`. The
   * camera stays, and truth belongs to the frames without distortion. Images of cases,
   * TUM and folders only: the others have none and refuse it. */
  std::optional<LensDistortion> distortion;

  /** \brief Units of depth per metre, > 0, of integers, floats and clouds; none
   * (default) = the data set's own for integers, metres for floats and clouds. Cases,
   * TUM, folders and clouds only: the others define their unit and refuse it. */
  std::optional<double> depth_scale;

  /** \brief Sintel and FlyingThings3D only. */
  RenderPass pass{RenderPass::Clean};

  /** \brief FlyingThings3D and Virtual KITTI 2 only, the others have no depth of the
   * right one. */
  StereoView view{StereoView::Left};

  /** \brief Between colour and depth, and between colour and pose; TUM, and
   * folders whose images are named by their times. Seconds, > 0. */
  double max_time_difference{0.02};
};

/** \brief The kinds of data sets, by their names in `datasetKinds`.
 *
 * - "cases": the project's own layout, see DataFolder; with `gt/object_poses_K.txt` the
 *   motion of each body. Truth from frame 0; poses, labels and bodies also between
 *   others. `rigid` where no label or body tells that there are several.
 * - "tum": TUM RGB-D. Colour and depth by rgb.txt and depth.txt, paired as the
 *   benchmark's tool does; poses from groundtruth.txt at the colour's time, between
 *   neighbours that are both within `max_time_difference`. Camera from camera.txt, else
 *   the published one for a folder named after freiburg1, 2 or 3, else ROS' default;
 *   distortion likewise (freiburg3's images are published without).
 * - "sintel": MPI-Sintel with its depth and camera files. Flow to the next frame as in
 *   the file; `visible` = neither in the occlusion nor in the invalid mask and inside
 *   the image. No scene flow.
 * - "vkitti1": Virtual KITTI 1.3.1 (rgb, depthgt, flowgt, extrinsicsgt beside each
 *   other). Flow to the next frame.
 * - "vkitti2": Virtual KITTI 2, archives merged or beside each other. Flow and scene
 *   flow to both neighbours, as far as they are there; scene flow reaches to 10 m per
 *   component, more is unknown.
 * - "flyingthings": FlyingThings3D, Monkaa, Driving; units are those of the models, the
 *   baseline is 1. Flow, and scene flow from disparity and its change, to both
 *   neighbours, as far as they are there.
 * - "kitti2015": KITTI 2015 scene flow, frames 10 and 11. Their depth comes from dense
 *   disparities that the user computes: disp_0/ID_10 and disp_1/ID_11 (or disp_0/ID_11)
 *   .png or .pfm beside image_2, each at its own frame's pixels. The data set's
 *   disparities are sparse truth and never input. `visible` = in flow_noc, that is, the
 *   point stays inside the image; `labels` from obj_map, 0 = static.
 * - "middlebury": stereo pairs as two frames of a camera that moves by the baseline;
 *   2003 (im2, im6, disp2, disp6; focal length and baseline are made up) and 2014 or
 *   2021 (im0, im1, disp0.pfm, disp1.pfm, calib.txt; the second camera's cx differs).
 *   `visible` by comparing both disparities, to one pixel.
 * - "folder", also "bonn": colour and depth images, in subfolders (rgb or color, depth)
 *   or told apart by those words in their names; paired by their order, or by times in
 *   their names. Camera and depth scale from camera.txt or the options. No truth.
 * - "pcd": the organized clouds of a folder; camera from camera.txt, the options, or
 *   the first cloud. No truth.
 *
 * Where depths of both frames and the flow are known, but no masks, a point is
 * `visible` when its depth is within 1 % of what the second frame shows around its
 * pixel. */
enum class DatasetKind {
  Automatic, ///< the only kind whose marks are there
  Cases,
  Tum,
  Sintel,
  VirtualKitti1,
  VirtualKitti2,
  FlyingThings,
  Kitti2015,
  Middlebury,
  Folder,
  Clouds
};

/** \brief Names of all kinds but Automatic, as command lines have them; Folder has two.
 */
PCL_MSF_EXPORT const std::vector<std::pair<std::string, DatasetKind>>&
datasetKinds ();

/** \brief The kind of a name of `datasetKinds` or "auto". \throws InvalidInput listing
 * all names for another one */
PCL_MSF_EXPORT DatasetKind
datasetKindFromName (const std::string& name);

/** \brief Opens all sequences below a path, sorted by name (numbers by value).
 *
 * \param path a data set's top folder, a part of it, or a single sequence; sequences
 * are looked for up to six folders below
 * \return one sequence or more; nothing but lists and cameras has been read
 * \throws IoError when nothing of that kind is there, or its lists are damaged
 * \throws InvalidInput for options outside their ranges
 *
 * Thread-safe, and so are the sequences; these throw InvalidInput for frames that there
 * are not. */
PCL_MSF_EXPORT std::vector<std::shared_ptr<const RgbdSequence>>
openDataset (DatasetKind kind,
             const std::string& path,
             const DatasetOptions& options = {});

/** \brief The same for a kind's name, as programs written for 0.1.0 give it: see
 * datasetKindFromName. */
inline std::vector<std::shared_ptr<const RgbdSequence>>
openDataset (const std::string& kind,
             const std::string& path,
             const DatasetOptions& options = {})
{
  return openDataset (datasetKindFromName (kind), path, options);
}

} // namespace pcl_msf::io
