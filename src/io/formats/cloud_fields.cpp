// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/cloud_fields.h"

#include <pcl/common/io.h>

#include "io/base/input_file.h"
#include <pcl_msf/errors.h>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace pcl_msf::io {

namespace {

using Field = pcl::PCLPointField;

template <typename T>
double
load (const unsigned char* bytes)
{
  T value{};
  std::memcpy (&value, bytes, sizeof (T));
  return static_cast<double> (value);
}

/** The first field of that name in small or large letters that has a value. */
const Field*
find (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  for (const Field& field : cloud.fields)
    if (field.count > 0 && lowerCase (field.name) == name)
      return &field;
  return nullptr;
}

CloudChannel
findFloat (const pcl::PCLPointCloud2& cloud,
           const std::string& name,
           const std::string& path)
{
  const Field* field = find (cloud, name);
  if (!field ||
      (field->datatype != Field::FLOAT32 && field->datatype != Field::FLOAT64))
    throw IoError (path + ": field " + name +
                   (field ? ": it is no float" : ": there is none") +
                   "; a cloud with x y z in metres is needed");
  return {field->offset, field->datatype};
}

/** The field rgb or rgba. */
const Field*
findColor (const pcl::PCLPointCloud2& cloud)
{
  const Field* field = find (cloud, "rgb");
  return field ? field : find (cloud, "rgba");
}

/** Red, green and blue in three fields, as PDAL, CloudCompare and scripts write them.
 */
std::vector<CloudChannel>
findThree (const pcl::PCLPointCloud2& cloud)
{
  using Names = std::array<const char*, 3>;
  for (const Names& names : {Names{"b", "g", "r"}, Names{"blue", "green", "red"}}) {
    std::vector<CloudChannel> channels;
    for (const char* name : names)
      if (const Field* field = find (cloud, name))
        channels.push_back ({field->offset, field->datatype});
    if (channels.size() == names.size())
      return channels;
  }
  return {};
}

std::vector<CloudChannel>
findIntensity (const pcl::PCLPointCloud2& cloud)
{
  for (const char* name : {"intensity", "intensities", "gray", "grey"})
    if (const Field* field = find (cloud, name))
      return {{field->offset, field->datatype}};
  return {};
}

} // namespace

double
CloudChannel::value (const unsigned char* bytes) const
{
  bytes += offset;
  switch (type) {
  case Field::FLOAT32:
    return load<float> (bytes);
  case Field::FLOAT64:
    return load<double> (bytes);
  case Field::UINT8:
    return load<std::uint8_t> (bytes);
  case Field::INT8:
    return load<std::int8_t> (bytes);
  case Field::UINT16:
    return load<std::uint16_t> (bytes);
  case Field::INT16:
    return load<std::int16_t> (bytes);
  case Field::UINT32:
    return load<std::uint32_t> (bytes);
  case Field::INT32:
    return load<std::int32_t> (bytes);
  default:
    return std::numeric_limits<double>::quiet_NaN();
  }
}

CloudFields::CloudFields (const pcl::PCLPointCloud2& cloud, const std::string& path)
: position_{findFloat (cloud, "x", path),
            findFloat (cloud, "y", path),
            findFloat (cloud, "z", path)}
{
  if (const Field* field = findColor (cloud)) {
    const std::size_t size = pcl::getFieldSize (field->datatype);
    if (field->count >= 3) // red comes first
      for (const std::size_t at : {2, 1, 0})
        numbers_.push_back ({field->offset + at * size, field->datatype});
    else if (size == 4)
      packed_ = CloudChannel{field->offset, field->datatype};
    else
      throw IoError (
          path + ": field " + field->name + ": " +
          std::to_string (size * field->count) +
          " bytes; PCL packs a colour into four: use these, or fields r g b");
  }
  else
    numbers_ = findThree (cloud);
  if (!packed_ && numbers_.empty())
    numbers_ = findIntensity (cloud);
}

void
CloudFields::position (const unsigned char* bytes, float& x, float& y, float& z) const
{
  x = static_cast<float> (position_[0].value (bytes));
  y = static_cast<float> (position_[1].value (bytes));
  z = static_cast<float> (position_[2].value (bytes));
  if (!std::isfinite (x) || !std::isfinite (y) || !std::isfinite (z))
    x = y = z = std::numeric_limits<float>::quiet_NaN();
}

} // namespace pcl_msf::io
