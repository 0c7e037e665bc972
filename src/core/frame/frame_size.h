// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <opencv2/core.hpp>

#include <string>

namespace pcl_msf {

/** \brief "160x120" */
inline std::string
sizeText (cv::Size size)
{
  return std::to_string (size.width) + "x" + std::to_string (size.height);
}

/** \brief Why a frame of this size cannot be aligned; empty when it can: optical flow
 * and normals need some pixels to look at. */
inline std::string
whyTooSmall (cv::Size size)
{
  constexpr int least = 12;
  if (size.width >= least && size.height >= least)
    return {};
  return "is " + sizeText (size) + ", and must be at least " +
         sizeText ({least, least}) + " pixels";
}

} // namespace pcl_msf
