// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/player/frame_maker.h"
#include "common/player/frame_player.h"
#include "common/player/stream_tracker.h"
#include "view/result_source.h"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace pcl_msf::tool {

/** \brief Plays a stream into the tracker; the newest result can be looked at. */
class StreamSolver : public ResultSource {
public:
  /** \brief Begins. \param warn takes what is not right with frames; called by other
   * threads. The settings must outlive the solver */
  StreamSolver (std::unique_ptr<FrameSource> source,
                const PlayerSettings& settings,
                Warn warn);

  /** \brief Ends the stream and waits for its threads. */
  ~StreamSolver() override;

  int
  solved () const override;
  /** \brief Null but for the newest. */
  Result
  result (int number) const override;
  std::string
  title (int number) const override;
  std::string
  problem () const override;
  bool
  isLive () const override
  {
    return true;
  }

private:
  void
  run ();
  void
  play ();
  void
  take (const StreamFrame& frame, StreamTracker& tracker);
  void
  publish (const StreamFrame& frame, const StreamResult& result, const SceneFlow& flow);

  const std::unique_ptr<FrameSource> source_;
  const PlayerSettings& settings_;
  const Warn warn_;
  std::map<int, cv::Mat> colors_; ///< of the reference and frames after it, by index
  mutable std::mutex mutex_;      ///< of the next three
  Result newest_;
  std::string title_;
  std::string problem_;
  std::atomic<int> solved_{0};
  std::atomic<bool> stop_{false};
  FramePlayer::Queue queue_;
  std::thread thread_;
};

} // namespace pcl_msf::tool
