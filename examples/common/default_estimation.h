// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>
#include <pcl_msf/visualization/result_scenes.h>

#include <functional>

namespace pcl_msf::tool {

/** \brief The method with its default parameters, from one reference to other frames.
 */
class DefaultEstimation {
public:
  explicit DefaultEstimation (const io::RgbdImages& reference);

  /** \brief Scene flow to another frame. \param go_on asked after every iteration;
   * false gives up \throws Interrupted then */
  SceneFlow
  to (const io::RgbdImages& images, const std::function<bool()>& go_on) const;

private:
  RgbdFrame reference_;
  Oversegmentation segments_;
};

/** \brief Gives a result the points and colours of the current frame.
 * \throws UsageError when it has another size */
void
takeCurrent (const io::RgbdImages& current, visualization::ResultClouds& result);

/** \brief Scene flow between two frames, with the default parameters.
 * \param go_on asked after every iteration; false gives up with Interrupted */
visualization::ResultClouds
estimatePair (io::RgbdImages reference,
              io::RgbdImages current,
              const std::function<bool()>& go_on);

} // namespace pcl_msf::tool
