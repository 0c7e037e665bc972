// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgproc.hpp>

#include <pcl_msf/visualization/picture_sheet.h>

#include <algorithm>

namespace pcl_msf::visualization {

cv::Mat
pictureSheet (const std::vector<cv::Mat>& pictures,
              int columns,
              const cv::Vec3b& background)
{
  CV_Assert (!pictures.empty() && columns >= 1);
  const cv::Size size = pictures.front().size();
  const int count = static_cast<int> (pictures.size());
  const int across = std::min (columns, count);
  const int down = (count + across - 1) / across;
  const int gap = std::max (4, size.width / 80);
  cv::Mat sheet (down * (size.height + gap) - gap,
                 across * (size.width + gap) - gap,
                 CV_8UC3,
                 cv::Scalar (background));
  for (int i = 0; i < count; ++i) {
    cv::Mat tile;
    cv::resize (pictures[i], tile, size, 0.0, 0.0, cv::INTER_AREA);
    const cv::Point corner ((i % across) * (size.width + gap),
                            (i / across) * (size.height + gap));
    tile.copyTo (sheet (cv::Rect (corner, size)));
  }
  return sheet;
}

} // namespace pcl_msf::visualization
