// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/output_file.h"
#include "io/results/pcd_bytes.h"
#include "io/results/sensor_pose.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/result_files.h>
#include <pcl_msf/point_types.h>

#include <cmath>
#include <limits>

namespace pcl_msf::io {

namespace {

const float kNan = std::numeric_limits<float>::quiet_NaN();

/** The reference's colours, whatever kind of image they come in. */
class Colors {
public:
  explicit Colors (const cv::Mat& color) : color_ (color) {}

  template <typename PointT>
  void
  apply (int row, int col, PointT& point) const
  {
    cv::Vec3b bgr (255, 255, 255);
    if (color_.type() == CV_8UC3 && !color_.empty())
      bgr = color_.at<cv::Vec3b> (row, col);
    else if (color_.type() == CV_8UC1 && !color_.empty())
      bgr = cv::Vec3b::all (color_.at<unsigned char> (row, col));
    point.b = bgr[0];
    point.g = bgr[1];
    point.r = bgr[2];
    point.a = 255;
  }

private:
  const cv::Mat& color_;
};

void
checkResult (const std::string& path, const SceneFlow& flow, const cv::Mat& color)
{
  const cv::Size size = flow.points.size();
  const auto fits = [size] (const cv::Mat& image) {
    return image.empty() || image.size() == size;
  };
  const bool whole = !flow.points.empty() && flow.displacement.size() == size &&
                     flow.labels.size() == size && flow.visibility.size() == size &&
                     fits (color) && fits (flow.flow_deviation) &&
                     fits (flow.displacement_deviation);
  if (!whole)
    throw IoError (path + ": scene flow: " + std::to_string (flow.points.cols) + "x" +
                   std::to_string (flow.points.rows) +
                   " points and a colour image of " + std::to_string (color.cols) +
                   "x" + std::to_string (color.rows) +
                   "; give a result that was estimated, and its reference's colour");
}

template <typename PointT, typename Fill>
void
writeCloud (const std::string& path,
            const SceneFlow& flow,
            const cv::Mat& color,
            const Viewpoint& viewpoint,
            const Fill& fill)
{
  checkResult (path, flow, color);
  pcl::PointCloud<PointT> cloud (flow.points.cols, flow.points.rows);
  cloud.is_dense = false;
  setViewpoint (viewpoint, cloud);
  const Colors colors (color);
  for (int row = 0; row < flow.points.rows; ++row)
    for (int col = 0; col < flow.points.cols; ++col) {
      PointT& point = cloud (col, row);
      colors.apply (row, col, point);
      fill (row, col, point);
    }
  const std::string bytes = pcdBytes (cloud);
  writeBytes (path, bytes.data(), bytes.size());
}

bool
isFinite (const cv::Vec3f& v)
{
  return std::isfinite (v[0]) && std::isfinite (v[1]) && std::isfinite (v[2]);
}

/** NaN where there is no image. */
float
valueAt (const cv::Mat& image, int row, int col)
{
  return image.empty() ? kNan : image.at<float> (row, col);
}

template <typename PointT>
void
setPosition (PointT& point, const cv::Vec3f& position)
{
  const bool known = isFinite (position);
  point.x = known ? position[0] : kNan;
  point.y = known ? position[1] : kNan;
  point.z = known ? position[2] : kNan;
}

} // namespace

void
writeSceneFlowCloud (const std::string& path,
                     const SceneFlow& flow,
                     const cv::Mat& color,
                     const Viewpoint& viewpoint)
{
  writeCloud<PointXYZRGBFlow> (
      path, flow, color, viewpoint, [&flow] (int row, int col, PointXYZRGBFlow& point) {
        setPosition (point, flow.points.at<cv::Vec3f> (row, col));
        const auto& d = flow.displacement.at<cv::Vec3f> (row, col);
        const bool known = isFinite (d) && std::isfinite (point.z);
        point.dx = known ? d[0] : kNan;
        point.dy = known ? d[1] : kNan;
        point.dz = known ? d[2] : kNan;
        const int label = flow.labels.at<int> (row, col);
        point.label =
            label >= 0 ? static_cast<std::uint32_t> (label) : PointXYZRGBFlow::kNoLabel;
        const auto seen = flow.visibility.at<unsigned char> (row, col);
        point.visible = seen == Visibility::Visible ? 255 : 0;
        point.flow_deviation = valueAt (flow.flow_deviation, row, col);
        point.displacement_deviation = valueAt (flow.displacement_deviation, row, col);
      });
}

void
writeWarpedCloud (const std::string& path,
                  const SceneFlow& flow,
                  const cv::Mat& color,
                  const Viewpoint& viewpoint)
{
  writeCloud<pcl::PointXYZRGB> (path,
                                flow,
                                color,
                                viewpoint,
                                [&flow] (int row, int col, pcl::PointXYZRGB& point) {
                                  setPosition (
                                      point,
                                      flow.points.at<cv::Vec3f> (row, col) +
                                          flow.displacement.at<cv::Vec3f> (row, col));
                                });
}

cv::Mat
visibilityMask (const cv::Mat& visibility)
{
  return visibility == pixelValue (Visibility::Visible);
}

} // namespace pcl_msf::io
