// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pictures.h"

#include "common/interruption.h"
#include "output.h"
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
  write (const std::string& name, const cv::Mat& picture) const
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
  add (const std::string& name, const std::string& label, const cv::Mat& picture)
  {
    write (name, picture);
    show (label, picture);
  }
  void
  writeOverview (const std::string& name) const
  {
    write (name, io::contactSheet (pictures_, 4, 480));
  }

private:
  std::filesystem::path folder_;
  std::vector<io::LabelledPicture> pictures_;
};

/** The reference, a frame of the window, and the motion between them. */
struct Scene {
  const SceneFlow& flow;
  const io::RgbdImages& reference;
  const io::RgbdImages& current;
};

cv::Mat
residualPicture (const Scene& s)
{
  if (s.reference.color.empty())
    return io::scalarPicture (io::depthResidual (s.flow, s.current.depth), 0.0, "m");
  const cv::Mat residual =
      io::brightnessResidual (s.reference.color, s.current.color, s.flow.flow);
  return io::scalarPicture (residual, 0.0, "grey levels of 255");
}

/** Both frames over each other, the current one carried back by the flow. */
cv::Mat
overlayAfter (const Scene& s)
{
  const cv::Mat& flow = s.flow.flow;
  cv::Mat overlay = io::tintedOverlay (s.reference.color,
                                       io::warpToReference (s.current.color, flow));
  for (int row = 0; row < flow.rows; ++row)
    for (int col = 0; col < flow.cols; ++col)
      if (!std::isfinite (flow.at<cv::Vec2f> (row, col)[0]))
        overlay.at<cv::Vec3b> (row, col) = {0, 0, 0};
  return overlay;
}

void
addFlow (Album& album, const std::string& name, const cv::Mat& flow, double maximum)
{
  const double full = maximum > 0.0 ? maximum : io::flowLength (flow, 0.99);
  const cv::Mat colors = io::flowColors (flow, full);
  album.write (name, colors);
  std::ostringstream label;
  label << "optical flow, full colour " << std::setprecision (3) << full << " px";
  album.show (label.str(), io::flowPicture (flow, full));
}

/** Both frames over each other, and as a pair to be shown in turn. */
void
addOverlays (Album& album, const Outcome& o, const Scene& s, int frame)
{
  const std::string pair = pairName (o, frame);
  album.show ("both frames before",
              io::tintedOverlay (s.reference.color, s.current.color));
  album.add ("overlay" + pair + ".png", "both frames after", overlayAfter (s));
  const io::FlickerPair flicker =
      io::flickerPair (s.reference.color, s.current.color, s.flow.flow);
  album.write ("flicker" + pair + "_before.png", flicker.before);
  album.write ("flicker" + pair + "_after.png", flicker.after);
}

} // namespace

void
writePictures (const Outcome& o, int frame, const Options& options)
{
  const Scene s{o.result.frames[frame], o.images[o.result.reference], o.images[frame]};
  const std::string reference = "_" + std::to_string (o.reference());
  const std::string pair = pairName (o, frame) + ".png";
  Album album (options.output);
  album.show ("reference", s.reference.color);
  album.show ("current", s.current.color);
  album.add ("range" + reference + ".png", // "depth" would name a recording's
             "depth of the reference",
             io::depthPicture (s.reference.depth));
  album.add ("segments" + reference + ".png",
             std::to_string (s.flow.segments.size()) + " segments",
             io::segmentOverlay (s.reference.color, s.flow.labels));
  addFlow (album, "flow" + pair, s.flow.flow, options.flow_maximum);
  album.add ("motions" + reference + ".png",
             std::to_string (s.flow.bodies) + " motion groups",
             io::motionOverlay (s.reference.color, s.flow));
  album.add ("occlusion" + pair,
             "visibility",
             io::visibilityPicture (s.reference.color, s.flow.visibility));
  album.add ("weights" + reference + ".png",
             "connections of segments",
             io::weightsPicture (s.reference.color, s.flow));
  album.add ("residual" + pair, "residual", residualPicture (s));
  if (!s.reference.color.empty())
    addOverlays (album, o, s, frame);
  album.add ("convergence" + reference + ".png",
             "convergence",
             io::convergencePlot (s.flow.report, {kPlotWidth, kPlotHeight}));
  if (frame == o.lastTarget())
    album.writeOverview ("overview" + reference + ".png");
}

} // namespace pcl_msf::tool
