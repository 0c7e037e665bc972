// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/segments/library_segmentations.h"
#include <pcl_msf/errors.h>

#include <string>

/* In place of library_segmentations.cpp where OpenCV comes without ximgproc. */
namespace pcl_msf {

namespace {

[[noreturn]] void
refuse (const std::string& method)
{
  throw InvalidInput (
      "the segmentation " + method +
      " needs OpenCV's module ximgproc, which this pcl_msf was built without: choose "
      "TangentPlane, or build pcl_msf again where OpenCV has its contrib modules "
      "(Debian: libopencv-contrib-dev)");
}

} // namespace

cv::Mat
segmentByFelzenszwalb (const FrameLevel&, const SegmentationParameters&, int)
{
  refuse ("Felzenszwalb");
}

cv::Mat
segmentBySlic (const FrameLevel&, int, int)
{
  refuse ("Slic");
}

} // namespace pcl_msf
