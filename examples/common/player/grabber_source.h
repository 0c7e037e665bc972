// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl/io/grabber.h>

#include <boost/signals2/connection.hpp>

#include "common/player/cloud_images.h"
#include "common/player/frame_maker.h"
#include "common/player/frame_source.h"

#include <exception>
#include <memory>
#include <mutex>

namespace pcl_msf::tool {

/** \brief Streams from any `pcl::Grabber` that gives organized clouds, at its own rate.
 *
 * Its thread calls back, makes the frame and puts it into the queue, which drops the
 * oldest one when the tracker is slower. The stream ends when the grabber no longer
 * runs, or has been silent for long. */
class GrabberSource : public FrameSource {
public:
  /** \param name of the camera, for messages. The settings must outlive the source. */
  GrabberSource (std::unique_ptr<pcl::Grabber> grabber,
                 std::string name,
                 const PlayerSettings& settings,
                 Warn warn);

  void
  deliver (Queue& queue, const std::function<bool()>& ended) override;
  long
  skipped () const override
  {
    return 0; // whatever a driver leaves out it does not tell
  }

private:
  template <typename PointT>
  bool
  listen ();
  template <typename PointT>
  void
  take (const pcl::PointCloud<PointT>& cloud);
  template <typename PointT>
  io::RgbdImages
  imagesOf (const pcl::PointCloud<PointT>& cloud);
  void
  start ();
  void
  waitForEnd (const std::function<bool()>& ended);
  void
  warnOfSilence () const;
  bool
  hasFailed () const;
  std::chrono::duration<double>
  silent () const;
  double
  secondsOf (const pcl::PCLHeader& header) const;

  std::unique_ptr<pcl::Grabber> grabber_;
  const std::string name_;
  CloudImages images_;
  FrameMaker maker_;
  Warn warn_;
  boost::signals2::connection connection_;
  mutable std::mutex mutex_; ///< of all below, between the grabber's thread and ours
  Queue* queue_{nullptr};    ///< null: nobody wants frames
  int taken_{0};
  StreamClock::time_point start_;  ///< arrival of the first frame
  StreamClock::time_point newest_; ///< and of the last, or when the grabber began
  std::exception_ptr error_;       ///< of the first frame
};

} // namespace pcl_msf::tool
