// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

#include "common/command_line.h"
#include <pcl_msf/io/datasets.h>
#include <pcl_msf/pinhole_camera.h>
#include <pcl_msf/visualization/result_scenes.h>
#include <pcl_msf/visualization/scene.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_msf::tool {

enum class ViewPreset { Sensor, Orbit, Top, User };

enum class Animation { None, Orbit, Warp };

/** \brief What is drawn when neither --kind nor --animation is given. */
constexpr const char* kUsualKind = "sheet";

/** \brief Everything that the command line of pcl_msf_render says. */
struct RenderOptions {
  std::string input;            ///< a result folder or a folder with frames
  std::string sequence;         ///< a folder with the frames of a result folder
  std::optional<int> reference; ///< of a result; none = the first that there is
  std::optional<int> frame;     ///< the current one; none = next to the reference
  io::DatasetOptions reading;   ///< of frames
  int window{0}; ///< last frame of trajectories and warps; 0 = the current one
  std::vector<std::string> kind_words; ///< as given; read into the next two
  std::vector<visualization::PictureKind> kinds;
  bool sheet{false};
  std::string output{"."};

  ViewPreset view{ViewPreset::Sensor};
  double azimuth{25.0};
  double elevation{20.0};
  double sweep{60.0}; ///< of an orbit, degrees; 360 = a whole turn
  double field_of_view{45.0};
  double zoom{1.0};
  bool parallel{false};
  std::optional<Eigen::Vector3d> eye;
  std::optional<Eigen::Vector3d> target;
  Eigen::Vector3d up{0.0, -1.0, 0.0};

  visualization::PictureStyle style;
  bool size_given{false};
  visualization::SceneOptions scene;

  Animation animation{Animation::None};
  int pictures{48};
  double rate{24.0}; ///< pictures per second
  bool gif{false};   ///< refused
  bool mp4{false};

  bool quiet{false};
};

constexpr const char* kSummary =
    "Pictures of a scene flow in 3-D, made without a display.\n\n"
    "  pcl_msf_render RESULT [--sequence FOLDER] [options]\n"
    "  pcl_msf_render FOLDER [options]\n\n"
    "RESULT is a folder that pcl_msf_scene_flow wrote: scene_flow_R_K.pcd is read,\n"
    "bodies_R.png and visibility_R_K.png when they are there. Kinds that show the\n"
    "current frame need --sequence. A folder of pcl_msf_register gives before_tints,\n"
    "after_tints (with --sequence TARGET, the target's file), warped, and motions "
    "with\n"
    "the joints' axes; of several targets --frame K chooses the K-th. FOLDER holds "
    "frames,\n"
    "as pcl_msf_scene_flow takes them; their scene flow is computed first, with the\n"
    "default parameters. Without a display an Xvfb is started. Exit status: 0 = "
    "written,\n"
    "3 = written, but a scene flow that was computed has not converged, else an "
    "error.";

/** \brief Adds the options to a command line, which checks them when it is read; it
 * throws UsageError then. */
void
declareOptions (CLI::App& app, RenderOptions& options);

} // namespace pcl_msf::tool
