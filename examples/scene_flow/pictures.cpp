// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pictures.h"

#include "interruption.h"
#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/flow_color.h>
#include <pcl_msf/io/images.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl_msf::tool {

namespace {

constexpr int kPlotWidth = 640;
constexpr int kPlotHeight = 480;

/** Writes pictures into a folder and keeps those for the overview. */
class Album {
public:
  explicit Album (const std::filesystem::path& folder) : folder_ (folder) {}

  void
  write (const char* name, const cv::Mat& picture) const
  {
    throwIfInterrupted();
    io::writeImage ((folder_ / name).string(), picture);
  }
  void
  show (const std::string& label, const cv::Mat& picture)
  {
    if (!picture.empty())
      pictures_.push_back ({label, picture});
  }
  void
  add (const char* name, const std::string& label, const cv::Mat& picture)
  {
    write (name, picture);
    show (label, picture);
  }
  void
  writeOverview () const
  {
    write ("overview.png", io::contactSheet (pictures_, 4, 480));
  }

private:
  std::filesystem::path folder_;
  std::vector<io::LabelledPicture> pictures_;
};

cv::Mat
residualPicture (const Outcome& o)
{
  const SceneFlow& flow = o.scene_flow;
  if (o.reference_color.empty())
    return io::scalarPicture (io::depthResidual (flow, o.current_depth), 0.0, "m");
  const cv::Mat residual =
      io::brightnessResidual (o.reference_color, o.current_color, flow.flow);
  return io::scalarPicture (residual, 0.0, "grey levels of 255");
}

/** Both frames over each other, the current one carried back by the flow. */
cv::Mat
overlayAfter (const Outcome& o)
{
  const cv::Mat& flow = o.scene_flow.flow;
  cv::Mat overlay = io::tintedOverlay (o.reference_color,
                                       io::warpToReference (o.current_color, flow));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col)
      if (!std::isfinite (flow.at<cv::Vec2f> (row, col)[0]))
        overlay.at<cv::Vec3b> (row, col) = {0, 0, 0};
  return overlay;
}

void
addFlow (Album& album, const cv::Mat& flow, double maximum)
{
  const double full = maximum > 0.0 ? maximum : io::flowLength (flow, 0.99);
  const cv::Mat colors = io::flowColors (flow, full);
  album.write ("flow_0_1.png", colors);
  std::ostringstream label;
  label << "optical flow, full colour " << std::setprecision (3) << full << " px";
  album.show (label.str(), io::flowPicture (flow, full));
}

} // namespace

void
writePictures (const Outcome& o, const Options& options)
{
  const SceneFlow& flow = o.scene_flow;
  Album album (options.output);
  album.show ("reference", o.reference_color);
  album.show ("current", o.current_color);
  album.add (
      "depth_0.png", "depth of the reference", io::depthPicture (o.reference_depth));
  album.add ("segments_0.png",
             std::to_string (flow.segments.size()) + " segments",
             io::segmentOverlay (o.reference_color, flow.labels));
  addFlow (album, flow.flow, options.flow_maximum);
  album.add ("motions_0.png",
             std::to_string (flow.bodies) + " motion groups",
             io::motionOverlay (o.reference_color, flow));
  album.add ("occlusion_0_1.png",
             "visibility",
             io::visibilityPicture (o.reference_color, flow.visibility));
  album.add ("weights_0.png",
             "connections of segments",
             io::weightsPicture (o.reference_color, flow));
  album.add ("residual_0_1.png", "residual", residualPicture (o));
  if (!o.reference_color.empty()) {
    album.show ("both frames before",
                io::tintedOverlay (o.reference_color, o.current_color));
    album.add ("overlay_0_1.png", "both frames after", overlayAfter (o));
    const io::FlickerPair flicker =
        io::flickerPair (o.reference_color, o.current_color, flow.flow);
    album.write ("flicker_0_1_before.png", flicker.before);
    album.write ("flicker_0_1_after.png", flicker.after);
  }
  album.add ("convergence.png",
             "convergence",
             io::convergencePlot (flow.report, {kPlotWidth, kPlotHeight}));
  album.writeOverview();
}

} // namespace pcl_msf::tool
