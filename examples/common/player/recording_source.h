// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/frame_maker.h"
#include "common/player/frame_source.h"
#include <pcl_msf/io/rgbd_sequence.h>

#include <atomic>
#include <memory>
#include <vector>

namespace pcl_msf::tool {

/** \brief Plays a recording.
 *
 * The first frame comes at once, the others as long after it as their times say. One
 * that is so late, because reading takes long, that the next one is due already is left
 * out. When every frame is wanted, each comes as soon as there is room for it. */
class RecordingSource : public FrameSource {
public:
  /** \brief The settings must outlive the source. */
  RecordingSource (std::shared_ptr<const io::RgbdSequence> sequence,
                   const PlayerSettings& settings,
                   Warn warn);

  void
  deliver (Queue& queue, const std::function<bool()>& ended) override;
  long
  skipped () const override
  {
    return skipped_;
  }

private:
  StreamFrame
  read (int index);
  bool
  waitUntilDue (int frame, const std::function<bool()>& ended) const;
  bool
  isLate (int frame) const;

  std::shared_ptr<const io::RgbdSequence> sequence_;
  bool every_frame_;
  FrameMaker maker_;
  std::vector<double> due_; ///< per frame, seconds after the first; never decreasing
  StreamClock::time_point start_;
  std::atomic<long> skipped_{0};
};

} // namespace pcl_msf::tool
