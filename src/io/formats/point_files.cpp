// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/output_file.h"
#include "io/formats/cloud_colors.h"
#include "io/formats/cloud_fields.h"
#include "io/formats/pcd_blob.h"
#include "io/formats/ply_reader.h"
#include <pcl_msf/errors.h>
#include <pcl_msf/io/point_files.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace pcl_msf::io {

namespace {

constexpr std::uint32_t kWhite = 0xFFFFFF;

/** 0xRRGGBB; nothing without colours. */
std::vector<std::uint32_t>
packedColors (const RgbdImages& images)
{
  std::vector<std::uint32_t> colors;
  if (!images.color.empty())
    for (const auto& bgr : cv::Mat_<cv::Vec3b> (images.color))
      colors.push_back (std::uint32_t{bgr[2]} << 16U | std::uint32_t{bgr[1]} << 8U |
                        bgr[0]);
  return colors;
}

PointFile
readPcdPoints (const std::string& path)
{
  const pcl::PCLPointCloud2 blob = readPcd (path, nullptr, PcdShape::Points);
  const CloudFields fields (blob, path);
  PointFile result;
  const std::size_t count = std::size_t{blob.width} * blob.height;
  const unsigned char* bytes = blob.data.data();
  for (std::size_t i = 0; i < count; ++i, bytes += blob.point_step) {
    Eigen::Vector3f p;
    fields.position (bytes, p.x(), p.y(), p.z());
    result.points.push_back (p);
  }
  RgbdImages images;
  takeColors (blob, fields, images);
  result.colors = packedColors (images);
  return result;
}

/** A line "v x y z", with a weight or a colour behind it: "w", "r g b", "r g b a". */
struct ObjVertex {
  std::vector<float> numbers;

  Eigen::Vector3f
  point () const
  {
    return {numbers[0], numbers[1], numbers[2]};
  }
  const float*
  color () const
  {
    return numbers.size() < 6 ? nullptr : &numbers[3];
  }
};

/** \param words of the line behind its "v" */
ObjVertex
parseVertex (const InputFile& file, std::istringstream& words)
{
  ObjVertex vertex;
  std::string word;
  while (words >> word && word.front() != '#')
    if (!parseNumber (word, vertex.numbers.emplace_back()))
      file.fail ("v", "'" + word + "' is no number");
  if (vertex.numbers.size() < 3)
    file.fail ("v",
               "a vertex has " + std::to_string (vertex.numbers.size()) +
                   " numbers where x y z are expected");
  return vertex;
}

/** The same unit as for colours of clouds; white where a vertex has none. */
std::vector<std::uint32_t>
colorsOf (const std::vector<ObjVertex>& vertices)
{
  const auto count = static_cast<int> (vertices.size());
  RgbdImages images;
  for (int i = 0; i < count; ++i)
    if (const float* rgb = vertices[i].color()) {
      if (images.raw_color.empty())
        images.raw_color = cv::Mat::zeros (1, count, CV_32FC3);
      for (int k = 0; k < 3; ++k)
        if (std::isfinite (rgb[k]))
          images.raw_color.at<cv::Vec3f> (0, i)[2 - k] = rgb[k];
    }
  unifyColors ({&images});
  std::vector<std::uint32_t> colors = packedColors (images);
  for (int i = 0; i < count && !colors.empty(); ++i)
    if (vertices[i].color() == nullptr)
      colors[i] = kWhite;
  return colors;
}

/** The vertices; many programs write colours behind them. */
PointFile
readObj (const std::string& path)
{
  InputFile file (path);
  std::istringstream lines (file.text (std::uint64_t{1} << 32));
  std::vector<ObjVertex> vertices;
  std::string line;
  while (std::getline (lines, line)) {
    std::istringstream words (line);
    std::string word;
    if (words >> word && word == "v")
      vertices.push_back (parseVertex (file, words));
  }
  if (vertices.empty())
    file.fail ("v", "the file has no vertices");
  PointFile result;
  for (const ObjVertex& vertex : vertices)
    result.points.push_back (vertex.point());
  result.colors = colorsOf (vertices);
  return result;
}

template <typename T>
void
append (std::string& bytes, const T& value)
{
  bytes.append (reinterpret_cast<const char*> (&value), sizeof (value));
}

} // namespace

PointFile
readPoints (const std::string& path)
{
  const std::string extension = lowerExtension (path);
  if (extension == ".pcd")
    return readPcdPoints (path);
  if (extension == ".ply")
    return readPly (path);
  if (extension == ".obj")
    return readObj (path);
  throw IoError (path + ": name: must end in .pcd, .ply or .obj");
}

std::vector<float>
brightnessOf (const PointFile& file)
{
  std::vector<float> brightness;
  for (const std::uint32_t rgb : file.colors)
    brightness.push_back ((0.299f * static_cast<float> (rgb >> 16U & 0xFFU) +
                           0.587f * static_cast<float> (rgb >> 8U & 0xFFU) +
                           0.114f * static_cast<float> (rgb & 0xFFU)) /
                          255.0f);
  return brightness;
}

void
writePointsPly (const std::string& path, const std::vector<Eigen::Vector3f>& points)
{
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                      std::to_string (points.size()) +
                      "\nproperty float x\nproperty float y\nproperty float z\n"
                      "end_header\n";
  for (const auto& p : points)
    bytes.append (reinterpret_cast<const char*> (p.data()), 3 * sizeof (float));
  writeBytes (path, bytes.data(), bytes.size());
}

void
writeRegisteredCloud (const std::string& path,
                      const CloudFlow& flow,
                      const PointFile& source)
{
  const std::string count = std::to_string (flow.warped.size());
  std::string bytes =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
      "FIELDS x y z rgb dx dy dz part confidence\nSIZE 4 4 4 4 4 4 4 4 4\n"
      "TYPE F F F U F F F I F\nCOUNT 1 1 1 1 1 1 1 1 1\nWIDTH " +
      count + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + count +
      "\nDATA binary\n";
  for (std::size_t i = 0; i < flow.warped.size(); ++i) {
    const Eigen::Vector3f& x = flow.warped[i];
    const Eigen::Vector3f d = x - source.points[i];
    bytes.append (reinterpret_cast<const char*> (x.data()), 3 * sizeof (float));
    append (bytes, source.colors.empty() ? kWhite : source.colors[i]);
    bytes.append (reinterpret_cast<const char*> (d.data()), 3 * sizeof (float));
    append (bytes, static_cast<std::int32_t> (flow.part[i]));
    append (bytes, flow.confidence[i]);
  }
  writeBytes (path, bytes.data(), bytes.size());
}

RegisteredCloud
readRegisteredCloud (const std::string& path)
{
  const pcl::PCLPointCloud2 blob = readPcd (path, nullptr, PcdShape::Points);
  std::vector<CloudChannel> channels;
  for (const char* name : {"x", "y", "z", "dx", "dy", "dz", "part"})
    for (const pcl::PCLPointField& field : blob.fields)
      if (field.name == name)
        channels.push_back ({field.offset, field.datatype});
  if (channels.size() != 7)
    throw IoError (path + ": fields: x y z dx dy dz part are not all there; give what "
                          "pcl_msf_register wrote");
  RegisteredCloud cloud;
  const std::size_t count = std::size_t{blob.width} * blob.height;
  const unsigned char* bytes = blob.data.data();
  for (std::size_t i = 0; i < count; ++i, bytes += blob.point_step) {
    Eigen::Vector3f x;
    Eigen::Vector3f d;
    for (int c = 0; c < 3; ++c) {
      x[c] = static_cast<float> (channels[c].value (bytes));
      d[c] = static_cast<float> (channels[3 + c].value (bytes));
    }
    cloud.warped.push_back (x);
    cloud.source.push_back (x - d);
    cloud.part.push_back (static_cast<int> (channels[6].value (bytes)));
  }
  return cloud;
}

} // namespace pcl_msf::io
