// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/cloud_fields.h"

#include <pcl_msf/errors.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_msf::io {

namespace {

template <typename T>
double
load (const unsigned char* bytes)
{
  T value{};
  std::memcpy (&value, bytes, sizeof (T));
  return static_cast<double> (value);
}

/** A field's value in a point; NaN for types that are no numbers. */
double
number (const unsigned char* point, const pcl::PCLPointField& field)
{
  const unsigned char* bytes = point + field.offset;
  switch (field.datatype) {
  case pcl::PCLPointField::FLOAT32:
    return load<float> (bytes);
  case pcl::PCLPointField::FLOAT64:
    return load<double> (bytes);
  case pcl::PCLPointField::UINT8:
    return load<std::uint8_t> (bytes);
  case pcl::PCLPointField::INT8:
    return load<std::int8_t> (bytes);
  case pcl::PCLPointField::UINT16:
    return load<std::uint16_t> (bytes);
  case pcl::PCLPointField::INT16:
    return load<std::int16_t> (bytes);
  case pcl::PCLPointField::UINT32:
    return load<std::uint32_t> (bytes);
  case pcl::PCLPointField::INT32:
    return load<std::int32_t> (bytes);
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}

const pcl::PCLPointField*
find (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  for (const auto& field : cloud.fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

pcl::PCLPointField
findFloat (const pcl::PCLPointCloud2& cloud,
           const std::string& name,
           const std::string& path)
{
  const auto* field = find (cloud, name);
  const bool is_float = field && (field->datatype == pcl::PCLPointField::FLOAT32 ||
                                  field->datatype == pcl::PCLPointField::FLOAT64);
  if (!is_float)
    throw IoError (path + ": field " + name +
                   ": missing or no float; a cloud with x y z in metres is needed");
  return *field;
}

/** The field rgb or rgba, four bytes of whatever type. */
const pcl::PCLPointField*
findPacked (const pcl::PCLPointCloud2& cloud, const std::string& path)
{
  const auto* field = find (cloud, "rgb");
  if (!field)
    field = find (cloud, "rgba");
  if (field && field->datatype != pcl::PCLPointField::FLOAT32 &&
      field->datatype != pcl::PCLPointField::UINT32 &&
      field->datatype != pcl::PCLPointField::INT32)
    throw IoError (path + ": field " + field->name +
                   ": not of four bytes; PCL packs colours into four");
  return field;
}

/** Intensities are 0 .. 1 in some clouds and 0 .. 255 in others. */
double
scaleOf (const pcl::PCLPointCloud2& cloud, const pcl::PCLPointField& intensity)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < cloud.data.size(); i += cloud.point_step) {
    const double value = number (cloud.data.data() + i, intensity);
    if (std::isfinite (value))
      largest = std::max (largest, value);
  }
  return largest <= 1.0 ? 255.0 : 1.0;
}

} // namespace

CloudFields::CloudFields (const pcl::PCLPointCloud2& cloud, const std::string& path)
: x_ (findFloat (cloud, "x", path))
, y_ (findFloat (cloud, "y", path))
, z_ (findFloat (cloud, "z", path))
, packed_ (findPacked (cloud, path))
, intensity_ (find (cloud, "intensity"))
{
  if (!packed_ && intensity_)
    intensity_scale_ = scaleOf (cloud, *intensity_);
}

void
CloudFields::position (const unsigned char* bytes, float& x, float& y, float& z) const
{
  x = static_cast<float> (number (bytes, x_));
  y = static_cast<float> (number (bytes, y_));
  z = static_cast<float> (number (bytes, z_));
  if (!std::isfinite (x) || !std::isfinite (y) || !std::isfinite (z))
    x = y = z = std::numeric_limits<float>::quiet_NaN();
}

std::uint32_t
CloudFields::color (const unsigned char* bytes) const
{
  constexpr std::uint32_t kOpaque = 0xFF000000U;
  if (packed_) {
    std::uint32_t packed = 0;
    std::memcpy (&packed, bytes + packed_->offset, sizeof (packed));
    return packed | kOpaque;
  }
  if (!intensity_)
    return 0;
  const double value = number (bytes, *intensity_) * intensity_scale_;
  const auto gray = static_cast<std::uint32_t> (
      std::isfinite (value) ? std::clamp (std::round (value), 0.0, 255.0) : 0.0);
  return kOpaque | (gray << 16) | (gray << 8) | gray;
}

} // namespace pcl_msf::io
