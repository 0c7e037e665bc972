// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <opencv2/imgcodecs.hpp>

#include <pcl_msf/errors.h>
#include <synthetic/truth_files.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <vector>

namespace pcl_msf {
namespace synthetic {
namespace {

static_assert (sizeof (float) == 4 && sizeof (double) == 8, "IEEE 754 formats");

constexpr float tag = 202021.25f; ///< first four bytes of .flo, .dpt and .cam

/** Bytes that reach the disk or an IoError. All these formats are little endian, as
 * every platform is that PCL supports. */
class Output {
public:
  explicit Output (const std::string& file)
  : file_ (file), stream_ (file, std::ios::binary | std::ios::trunc)
  {}

  template <typename T>
  void
  put (const T* values, std::size_t count)
  {
    stream_.write (reinterpret_cast<const char*> (values),
                   static_cast<std::streamsize> (count * sizeof (T)));
  }

  void
  finish ()
  {
    stream_.close();
    if (!stream_)
      throw IoError ("cannot write " + file_ +
                     ": is the folder writable, and the disk not full?");
  }

private:
  std::string file_;
  std::ofstream stream_;
};

void
putHeader (Output& output, const cv::Mat& image)
{
  output.put (&tag, 1);
  const std::int32_t size[] = {image.cols, image.rows};
  output.put (size, 2);
}

} // namespace

void
writeText (const std::string& file, const std::string& text)
{
  Output output (file);
  output.put (text.data(), text.size());
  output.finish();
}

void
writeImage (const std::string& file, const cv::Mat& image)
{
  bool ok = false;
  try {
    ok = cv::imwrite (file, image);
  }
  catch (const cv::Exception&) {
  }
  if (!ok)
    throw IoError ("cannot write " + file +
                   ": is the folder writable, and the disk not full?");
}

void
writeFlo (const std::string& file, const cv::Mat& flow)
{
  Output output (file);
  putHeader (output, flow);
  std::vector<float> row (2 * static_cast<std::size_t> (flow.cols));
  for (int v = 0; v < flow.rows; ++v) {
    const float* values = flow.ptr<float> (v);
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = std::isfinite (values[i]) ? values[i] : 1e10f;
    output.put (row.data(), row.size());
  }
  output.finish();
}

void
writePfm (const std::string& file, const cv::Mat& vectors)
{
  Output output (file);
  const std::string header = "PF\n" + std::to_string (vectors.cols) + " " +
                             std::to_string (vectors.rows) + "\n-1\n";
  output.put (header.data(), header.size());
  for (int v = vectors.rows - 1; v >= 0; --v)
    output.put (vectors.ptr<float> (v), 3 * static_cast<std::size_t> (vectors.cols));
  output.finish();
}

void
writeDpt (const std::string& file, const cv::Mat& depth)
{
  Output output (file);
  putHeader (output, depth);
  std::vector<float> row (depth.cols);
  for (int v = 0; v < depth.rows; ++v) {
    const float* values = depth.ptr<float> (v);
    for (int u = 0; u < depth.cols; ++u)
      row[u] = values[u] > 0.0f ? values[u] : 0.0f;
    output.put (row.data(), row.size());
  }
  output.finish();
}

void
writeCam (const std::string& file,
          const PinholeCamera& camera,
          const RigidPose& camera_from_world)
{
  Output output (file);
  output.put (&tag, 1);
  const double intrinsic[] = {
      camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0};
  output.put (intrinsic, 9);
  const Eigen::Matrix3d r = camera_from_world.rotation();
  const Eigen::Vector3d t = camera_from_world.translation();
  for (int i = 0; i < 3; ++i) {
    const double row[] = {r (i, 0), r (i, 1), r (i, 2), t[i]};
    output.put (row, 4);
  }
  output.finish();
}

} // namespace synthetic
} // namespace pcl_msf
