// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "common/player/grabber_source.h"

#include <pcl/point_types.h>

#include "common/command_line.h"
#include <pcl_msf/errors.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace pcl_msf::tool {

namespace {

constexpr std::chrono::milliseconds kNap{20}; // between looks for the end
using Seconds = std::chrono::duration<double>;

constexpr Seconds kLinger{0.5};        // for what was read ahead
constexpr Seconds kPatience{10.0};     // with a camera that gives nothing
constexpr double kMicroseconds = 1e-6; // of PCL's stamps

} // namespace

GrabberSource::GrabberSource (std::unique_ptr<pcl::Grabber> grabber,
                              std::string name,
                              const PlayerSettings& settings,
                              Warn warn)
: grabber_ (std::move (grabber))
, name_ (std::move (name))
, images_ (settings.reading.camera, settings.reading.depth_scale.value_or (1.0))
, maker_ (settings, name_, false, warn)
, warn_ (std::move (warn))
{}

/** \return false when the grabber has no clouds of such points */
template <typename PointT>
bool
GrabberSource::listen()
{
  using Cloud = pcl::PointCloud<PointT>;
  using Signal = void (const typename Cloud::ConstPtr&);
  if (!grabber_->providesCallback<Signal>())
    return false;
  const std::function<Signal> callback =
      [this] (const typename Cloud::ConstPtr& cloud) { take (*cloud); };
  connection_ = grabber_->registerCallback (callback);
  return connection_.connected();
}

template <typename PointT>
void
GrabberSource::take (const pcl::PointCloud<PointT>& cloud)
{
  StreamFrame frame;
  frame.arrival = StreamClock::now();
  const std::lock_guard<std::mutex> lock (mutex_);
  if (queue_ == nullptr || error_)
    return;
  newest_ = frame.arrival;
  if (taken_ == 0)
    start_ = frame.arrival;
  frame.index = taken_;
  frame.seconds = secondsOf (cloud.header);
  try {
    maker_.make (frame, [&] { return imagesOf (cloud); });
    ++taken_;
    queue_->push (std::move (frame));
  }
  catch (...) { // the thread is the driver's
    error_ = std::current_exception();
  }
}

template <typename PointT>
io::RgbdImages
GrabberSource::imagesOf (const pcl::PointCloud<PointT>& cloud)
{
  try {
    return images_.convert (cloud);
  }
  catch (const InvalidInput& e) {
    throw InvalidInput (name_ + ": " + e.what());
  }
}

/** By the driver's clock, or when it has none by ours, from the first frame. */
double
GrabberSource::secondsOf (const pcl::PCLHeader& header) const
{
  if (header.stamp != 0)
    return kMicroseconds * static_cast<double> (header.stamp);
  return std::chrono::duration<double> (newest_ - start_).count();
}

void
GrabberSource::deliver (Queue& queue, const std::function<bool()>& ended)
{
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    queue_ = &queue;
    newest_ = StreamClock::now();
  }
  start();
  waitForEnd (ended);
  grabber_->stop();
  connection_.disconnect();
  const std::lock_guard<std::mutex> lock (mutex_);
  queue_ = nullptr;
  if (error_)
    std::rethrow_exception (error_);
  if (taken_ == 0 && !ended())
    throw UsageError (name_ + ": gives no clouds; see that it is connected, and that "
                              "no other program uses it");
}

void
GrabberSource::start()
{
  const bool listening = listen<pcl::PointXYZRGBA>() || listen<pcl::PointXYZRGB>() ||
                         listen<pcl::PointXYZI>() || listen<pcl::PointXYZ>();
  if (!listening)
    throw UsageError (name_ + ": gives no clouds of points; take a camera of depth");
  try {
    grabber_->start();
  }
  catch (const std::exception& e) {
    throw UsageError (name_ + ": cannot be started: " + e.what());
  }
}

void
GrabberSource::waitForEnd (const std::function<bool()>& ended)
{
  const double rate = grabber_->getFramesPerSecond();
  const Seconds two_frames{rate > 0.0 ? 2.0 / rate : 0.0};
  while (!ended() && !hasFailed()) {
    const auto silence = silent();
    // Grabbers that read ahead give their last cloud when they no longer run.
    if (!grabber_->isRunning() && silence > std::max (kLinger, two_frames))
      return;
    if (silence > std::max<Seconds> (kPatience, two_frames)) {
      warnOfSilence();
      return;
    }
    std::this_thread::sleep_for (kNap);
  }
}

void
GrabberSource::warnOfSilence() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  if (taken_ > 0) // else it is an error
    warn_ (name_ + ": gives no clouds any more; the stream ends");
}

bool
GrabberSource::hasFailed() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return error_ != nullptr;
}

std::chrono::duration<double>
GrabberSource::silent() const
{
  const std::lock_guard<std::mutex> lock (mutex_);
  return StreamClock::now() - newest_;
}

} // namespace pcl_msf::tool
