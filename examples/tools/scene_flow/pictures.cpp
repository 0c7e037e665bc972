// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "pictures.h"

#include "common/interruption.h"
#include "core/base/parallel_for.h"
#include "output.h"
#include <pcl_msf/io/figures.h>
#include <pcl_msf/io/flow_color.h>
#include <pcl_msf/io/images.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <future>
#include <iomanip>
#include <sstream>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr int kPlotWidth = 640;
constexpr int kPlotHeight = 480;

/** Pictures that are made, then written, each at once with others, and the overview of
 * them. */
class PictureSet {
public:
  using Make = std::function<cv::Mat()>;

  PictureSet (const std::filesystem::path& folder, int threads)
  : folder_ (folder), threads_ (threads)
  {}

  /** \param name of its file, empty = only in the overview \param label in the
   * overview, empty = not there */
  void
  add (const std::string& name, const std::string& label, const Make& make)
  {
    entries_.push_back ({name, {label, {}}, make});
  }
  void
  make ()
  {
    forEach ([] (Entry& entry) { entry.shown.picture = entry.make(); });
  }
  void
  addOverview (const std::string& name)
  {
    std::vector<io::LabelledPicture> shown;
    for (const Entry& entry : entries_)
      if (!entry.shown.label.empty() && !entry.shown.picture.empty())
        shown.push_back (entry.shown);
    // First, as it takes longest.
    entries_.insert (entries_.begin(), {name, {}, [shown = std::move (shown)] {
                                          return io::contactSheet (shown, 4, 480);
                                        }});
  }
  void
  write ()
  {
    forEach ([this] (Entry& entry) {
      if (entry.shown.picture.empty())
        entry.shown.picture = entry.make();
      if (!entry.name.empty())
        io::writeImage ((folder_ / entry.name).string(), entry.shown.picture);
    });
  }

private:
  struct Entry {
    std::string name;
    io::LabelledPicture shown;
    Make make;
  };

  template <typename F>
  void
  forEach (const F& f)
  {
    parallelFor (threads_, static_cast<int> (entries_.size()), 1, [&] (int i) {
      throwIfInterrupted();
      f (entries_[i]);
    });
  }

  std::filesystem::path folder_;
  int threads_;
  std::vector<Entry> entries_;
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
addFlow (PictureSet& set, const std::string& name, const cv::Mat& flow, double maximum)
{
  const double full = maximum > 0.0 ? maximum : io::flowLength (flow, 0.99);
  set.add (name, "", [&flow, full] { return io::flowColors (flow, full); });
  std::ostringstream label;
  label << "optical flow, full colour " << std::setprecision (3) << full << " px";
  set.add ("", label.str(), [&flow, full] { return io::flowPicture (flow, full); });
}

/** Both frames over each other, and as a pair to be shown in turn. */
void
addOverlays (PictureSet& set, const std::string& pair, const Scene& s)
{
  const cv::Mat& before = s.reference.color;
  const cv::Mat& after = s.current.color;
  set.add ("", "both frames before", [&] { return io::tintedOverlay (before, after); });
  set.add (
      "overlay" + pair + ".png", "both frames after", [&] { return overlayAfter (s); });
  const auto flicker = std::async (std::launch::deferred, [&] {
                         return io::flickerPair (before, after, s.flow.flow);
                       }).share();
  set.add ("flicker" + pair + "_before.png", "", [=] { return flicker.get().before; });
  set.add ("flicker" + pair + "_after.png", "", [=] { return flicker.get().after; });
}

/** What the solve found about the segments. */
void
addSegments (PictureSet& set, const std::string& reference, const Scene& s)
{
  const cv::Mat& color = s.reference.color;
  set.add ("segments" + reference + ".png",
           std::to_string (s.flow.segments.size()) + " segments",
           [&] { return io::segmentOverlay (color, s.flow.labels); });
  set.add ("motions" + reference + ".png",
           std::to_string (s.flow.groups) + " motion groups",
           [&] { return io::motionOverlay (color, s.flow); });
  set.add ("weights" + reference + ".png", "connections of segments", [&] {
    return io::weightsPicture (color, s.flow);
  });
}

} // namespace

void
writePictures (const Outcome& o, int frame, const Options& options)
{
  const Scene s{o.result.frames[frame], o.images[o.result.reference], o.images[frame]};
  const std::string reference = "_" + std::to_string (o.reference());
  const std::string pair = pairName (o, frame);
  PictureSet set (options.output, threadCount (options.solver.threads));
  set.add ("", "reference", [&] { return s.reference.color; });
  set.add ("", "current", [&] { return s.current.color; });
  set.add ("range" + reference + ".png", // "depth" would name a recording's
           "depth of the reference",
           [&] { return io::depthPicture (s.reference.depth); });
  addFlow (set, "flow" + pair + ".png", s.flow.flow, options.flow_maximum);
  addSegments (set, reference, s);
  set.add ("occlusion" + pair + ".png", "visibility", [&] {
    return io::visibilityPicture (s.reference.color, s.flow.visibility);
  });
  set.add ("residual" + pair + ".png", "residual", [&] { return residualPicture (s); });
  set.add ("deviation" + pair + ".png", "standard deviation of the flow", [&] {
    return io::scalarPicture (s.flow.flow_deviation, 0.0, "px");
  });
  if (!s.reference.color.empty())
    addOverlays (set, pair, s);
  set.add ("convergence" + reference + ".png", "convergence", [&] {
    return io::convergencePlot (s.flow.report, {kPlotWidth, kPlotHeight});
  });
  set.make();
  if (frame == o.lastTarget())
    set.addOverview ("overview" + reference + ".png");
  set.write();
}

} // namespace pcl_msf::tool
