// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <pcl_msf/parameters.h>

#include <optional>
#include <string>

namespace pcl_msf::tool {

/** \brief What is known of the unit of depth images. */
struct DepthUnit {
  std::optional<double> scale; ///< what --depth-scale gave; none = a default
  bool defined{false};         ///< by the data, see RgbdSequence::definesDepthUnit
  bool optional{true}; ///< has the tool --depth-scale, --min-depth and --max-depth?
};

/** \brief Looks whether a depth image can be in metres.
 * \param depth CV_32FC1, metres \param name of its file or frame, for the message
 * \return a warning when most of it is unlikely far or near, or much is dropped by the
 * limits; empty when all is well
 * \throws UsageError when nothing is between --min-depth and --max-depth */
std::string
checkDepth (const cv::Mat& depth,
            const FrameParameters& limits,
            const std::string& name,
            const DepthUnit& unit);

} // namespace pcl_msf::tool
