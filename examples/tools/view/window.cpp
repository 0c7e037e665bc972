// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "view/window.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <opencv2/core.hpp>

#include "visualization/base/vtk_actors.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/visualization/view.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>

namespace pcl_msf::tool {

namespace {

using namespace visualization;
using Clock = std::chrono::steady_clock;

constexpr int kMilliseconds = 40;       ///< for events between two looks at the solver
constexpr double kPlaySeconds = 1.0;    ///< for each pair while playing
constexpr const char* kCloud = "cloud"; ///< ids in PCLVisualizer
constexpr const char* kStatus = "status";
constexpr double kInFront = -2000.0; ///< of arrows, in 2^-16 of the depth's range

/** What a function key shows. */
struct Mode {
  const char* key;
  const char* name;
  PictureKind kind;
};

constexpr std::array<Mode, 8> kModes{
    {{"F1", "reference and current", PictureKind::Before},
     {"F2", "warped and current", PictureKind::After},
     {"F3", "before, in tints", PictureKind::BeforeTints},
     {"F4", "after, in tints", PictureKind::AfterTints},
     {"F5", "warped", PictureKind::Warped},
     {"F6", "segments", PictureKind::Segments},
     {"F7", "motion groups", PictureKind::Motions},
     {"F8", "occlusion", PictureKind::Occlusion}}};

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
cloudOf (const Scene& scene)
{
  pcl::PointCloud<pcl::PointXYZRGB>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZRGB>);
  for (const PointSet& set : scene.points)
    for (int row = 0; row < set.positions.rows; ++row)
      for (int col = 0; col < set.positions.cols; ++col) {
        const auto& p = set.positions.at<cv::Vec3f> (row, col);
        const auto& c = set.colors.at<cv::Vec3b> (row, col);
        if (std::isfinite (p[0] + p[1] + p[2]))
          cloud->push_back (pcl::PointXYZRGB (p[0], p[1], p[2], c[2], c[1], c[0]));
      }
  return cloud;
}

} // namespace

/** What the window shows and how keys change it. */
class ViewWindow::Content {
public:
  explicit Content (const ResultSource& source)
  : source_ (source), viewer_ ("pcl_msf_view")
  {
    viewer_.setBackgroundColor (1.0, 1.0, 1.0);
    viewer_.setSize (1024, 768);
    viewer_.setShowFPS (false);
    viewer_.addText ("solving ...", 10, 10, 15, 0.0, 0.0, 0.0, kStatus);
    viewer_.registerKeyboardCallback (
        [this] (const pcl::visualization::KeyboardEvent& event) { take (event); });
  }

  bool
  spin ()
  {
    viewer_.spinOnce (kMilliseconds);
    if (viewer_.wasStopped())
      return false;
    if (source_.solved() != seen_) {
      seen_ = source_.solved();
      if (source_.isLive())
        pair_ = seen_ - 1;
      changed_ = changed_ || shown_ != pair_;
      tell();
    }
    if (playing_ &&
        Clock::now() - stepped_ > std::chrono::duration<double> (kPlaySeconds))
      step (pair_ + 1 < source_.solved() ? 1 : -pair_);
    if (const auto result = changed_ ? source_.result (pair_) : nullptr)
      show (*result);
    return true;
  }

private:
  void
  take (const pcl::visualization::KeyboardEvent& event)
  {
    if (!event.keyDown())
      return;
    const std::string& key = event.getKeySym();
    for (std::size_t i = 0; i < kModes.size(); ++i)
      if (key == kModes[i].key)
        setMode (i);
    if (key == "F9") {
      arrows_ = !arrows_;
      changed_ = true;
    }
    else if (key == "Right" || key == "Left")
      step (key == "Right" ? 1 : -1);
    else if (key == "space")
      playing_ = !playing_;
  }
  void
  setMode (std::size_t mode)
  {
    mode_ = mode;
    changed_ = true;
  }
  void
  step (int by)
  {
    const int last = std::max (0, source_.solved() - 1);
    const int next = std::clamp (pair_ + by, 0, last);
    changed_ = changed_ || next != pair_;
    pair_ = next;
    stepped_ = Clock::now();
  }

  /** The status line. */
  void
  tell ()
  {
    std::string words = source_.title (pair_) + ", " + kModes[mode_].name;
    if (!source_.problem().empty())
      words += ": " + source_.problem();
    viewer_.updateText (words, 10, 10, 15, 0.0, 0.0, 0.0, kStatus);
  }

  void
  show (const ResultClouds& result)
  {
    const auto cloud = cloudOf (resultScene (kModes[mode_].kind, result));
    if (!viewer_.updatePointCloud (cloud, kCloud)) {
      viewer_.addPointCloud (cloud, kCloud);
      viewer_.setPointCloudRenderingProperties (
          pcl::visualization::PCL_VISUALIZER_POINT_SIZE, 2, kCloud);
      lookFromSensor (result);
    }
    vtkRenderer* renderer = viewer_.getRendererCollection()->GetFirstRenderer();
    if (arrow_actor_ != nullptr)
      renderer->RemoveActor (arrow_actor_);
    arrow_actor_ = nullptr;
    if (arrows_)
      arrow_actor_ = arrowActor (resultScene (PictureKind::Arrows, result).arrows);
    if (arrow_actor_ != nullptr) {
      vtkMapper* mapper =
          arrow_actor_->GetMapper(); // seen though they lie in the cloud
      mapper->SetResolveCoincidentTopologyToPolygonOffset();
      mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters (0.0, kInFront);
      renderer->AddActor (arrow_actor_);
    }
    shown_ = pair_;
    changed_ = false;
    tell();
  }

  void
  lookFromSensor (const ResultClouds& result)
  {
    const SceneBounds bounds = boundsOf (result.scene_flow.points);
    const Eigen::Vector3d& c = bounds.center;
    viewer_.setCameraPosition (
        0.0, 0.0, -0.7 * bounds.radius, c.x(), c.y(), c.z(), 0.0, -1.0, 0.0);
  }

  const ResultSource& source_;
  pcl::visualization::PCLVisualizer viewer_;
  vtkSmartPointer<vtkActor> arrow_actor_;
  std::size_t mode_{1};
  int pair_{0};
  int shown_{-1};
  int seen_{0};
  bool arrows_{true};
  bool playing_{false};
  bool changed_{true};
  Clock::time_point stepped_{Clock::now()};
};

ViewWindow::ViewWindow (const ResultSource& source)
: content_ (std::make_unique<Content> (source))
{}

ViewWindow::~ViewWindow() = default;

bool
ViewWindow::spin()
{
  return content_->spin();
}

const char*
ViewWindow::keys()
{
  return "  F1  reference and current cloud      F2  warped reference and current "
         "cloud\n"
         "  F3  the first in two tints           F4  the second in two tints\n"
         "  F5  the warped reference alone       F6  segments\n"
         "  F7  motion groups                    F8  occlusion\n"
         "  F9  displacement arrows on and off\n"
         "  left, right: the pair before, after  space: play and pause\n"
         "  and all keys of PCLVisualizer; h lists them\n";
}

} // namespace pcl_msf::tool
