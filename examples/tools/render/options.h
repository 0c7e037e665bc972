// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <Eigen/Core>

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

/** \brief Everything that the command line of pcl_msf_render says. */
struct RenderOptions {
  std::string input;            ///< a result folder or a folder with frames
  std::string sequence;         ///< a folder with the frames of a result folder
  std::optional<int> reference; ///< of a result; none = the first that there is
  std::optional<int> frame;     ///< the current one; none = next to the reference
  io::DatasetOptions reading;   ///< of frames
  int window{0}; ///< last frame of trajectories and warps; 0 = the current one
  std::vector<visualization::PictureKind> kinds;
  bool sheet{false};
  std::string output;

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
  bool gif{false};
  bool mp4{false};

  bool quiet{false};
  bool help{false};
};

/** \brief Reads the command line. \throws UsageError */
RenderOptions
parseRenderOptions (int argc, const char* const* argv);

void
printRenderHelp ();

} // namespace pcl_msf::tool
