// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/pcd_header.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"
#include "io/base/pcl_io.h"

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace pcl_msf::io {

namespace {

using Words = std::vector<std::string>;

const std::set<std::string> kTypes{
    "F4", "F8", "I1", "I2", "I4", "I8", "U1", "U2", "U4", "U8"};
const std::set<std::string> kKeywords{"VERSION",
                                      "FIELDS",
                                      "SIZE",
                                      "TYPE",
                                      "COUNT",
                                      "WIDTH",
                                      "HEIGHT",
                                      "VIEWPOINT",
                                      "POINTS",
                                      "DATA"};
constexpr std::int64_t kLargest = std::int64_t{1} << 40;

/** The header's lines by keyword; PCL's own reader trusts them and crashes where they
 * disagree. */
using PcdHeader = std::map<std::string, Words>;

Words
nextLine (InputFile& file)
{
  std::istringstream line (file.line ("header"));
  Words words;
  for (std::string word; line >> word;)
    words.push_back (word);
  return words;
}

PcdHeader
readHeader (InputFile& file)
{
  PcdHeader header;
  while (header.count ("DATA") == 0) {
    Words words = nextLine (file);
    if (words.empty() || words[0][0] == '#')
      continue;
    const std::string key = words[0] == "COLUMNS" ? "FIELDS" : words[0];
    if (kKeywords.count (key) == 0)
      file.fail ("header", "'" + key.substr (0, 32) + "' is no keyword of a .pcd file");
    words.erase (words.begin());
    if (key == "VIEWPOINT" && words.size() != 7)
      file.fail (key, "seven numbers are needed; the header is damaged");
    if (words.empty() || !header.emplace (key, words).second)
      file.fail (key.substr (0, 32), "empty or given twice; the header is damaged");
  }
  for (const char* key : {"FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT", "POINTS"})
    if (header.count (key) == 0)
      file.fail (key, "missing; the header is damaged");
  return header;
}

std::int64_t
number (const InputFile& file, const char* key, const std::string& word)
{
  std::int64_t value = 0;
  if (!parseNumber (word, value) || value < 0 || value > kLargest)
    file.fail (key, "'" + word.substr (0, 32) + "' is no size; the header is damaged");
  return value;
}

/** What a point takes in the file. */
struct PointSize {
  std::int64_t bytes{0};
  std::int64_t fields{0}; ///< that have a value
};

/** Of fields whose types PCL has. */
PointSize
pointSize (const InputFile& file, const PcdHeader& header)
{
  const Words& types = header.at ("TYPE");
  const Words& sizes = header.at ("SIZE");
  const std::size_t fields = header.at ("FIELDS").size();
  const Words counts =
      header.count ("COUNT") ? header.at ("COUNT") : Words (fields, "1");
  if (types.size() != fields || sizes.size() != fields || counts.size() != fields)
    file.fail ("SIZE, TYPE, COUNT",
               "not one for each of FIELDS; the header is damaged");
  PointSize point;
  for (std::size_t i = 0; i < fields; ++i) {
    const std::string type = types[i] + sizes[i];
    if (kTypes.count (type) == 0)
      file.fail ("TYPE, SIZE", "'" + type.substr (0, 32) + "' is no type of PCL's");
    const std::int64_t count = number (file, "COUNT", counts[i]);
    if (count > 4096) // old lidar drivers wrote padding of 0, which PCL drops
      file.fail ("COUNT",
                 std::to_string (count) + ", must be 0 .. 4096; the header is damaged");
    point.bytes += count * number (file, "SIZE", sizes[i]);
    point.fields += count > 0 ? 1 : 0;
  }
  return point;
}

/** PCL's reader trusts a packed cloud's sizes and reads on when unpacking has failed,
 * so it is unpacked here once before. */
void
checkPacked (InputFile& file, std::int64_t bytes)
{
  const auto packed = file.value<std::uint32_t> ("points");
  const auto unpacked = file.value<std::uint32_t> ("points");
  if (static_cast<std::int64_t> (unpacked) != bytes)
    file.fail ("points", "their unpacked size is not that of the header");
  if (packed == 0 || packed > file.remaining())
    file.fail ("points", "fewer bytes than announced; the file is cut short");
  std::vector<char> from (packed), to (unpacked);
  file.read (from.data(), packed, "points");
  if (!unpackByPcl (from, to))
    file.fail ("points", "cannot be unpacked; the file is damaged");
}

void
checkSize (const InputFile& file,
           const std::string& path,
           PcdShape shape,
           std::int64_t width,
           std::int64_t height)
{
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  if (shape == PcdShape::Image)
    checkImageSize (path, width, height);
  else if (width < 0 || height < 0 || width > most || height > most ||
           width * height > most)
    file.fail ("WIDTH, HEIGHT",
               std::to_string (width) + " x " + std::to_string (height) +
                   " is no number of points; the header is damaged");
}

Viewpoint
viewpointOf (const InputFile& file, const PcdHeader& header)
{
  Viewpoint viewpoint;
  if (header.count ("VIEWPOINT") == 0)
    return viewpoint;
  const Words& words = header.at ("VIEWPOINT");
  for (int i = 0; i < 7; ++i) {
    float& value = i < 3 ? viewpoint.origin[i] : viewpoint.orientation[i - 3];
    if (!parseNumber (words[i], value))
      file.fail ("VIEWPOINT",
                 "'" + words[i].substr (0, 32) +
                     "' is no number; the header is damaged");
  }
  return viewpoint;
}

} // namespace

PcdHead
checkPcdHeader (const std::string& path, PcdShape shape)
{
  InputFile file (path);
  const std::uint64_t whole = file.remaining();
  file.skipByteOrderMark();
  PcdHead head;
  head.begin = static_cast<int> (whole - file.remaining());
  const PcdHeader header = readHeader (file);
  head.viewpoint = viewpointOf (file, header);
  const std::int64_t width = number (file, "WIDTH", header.at ("WIDTH")[0]);
  const std::int64_t height = number (file, "HEIGHT", header.at ("HEIGHT")[0]);
  const std::int64_t points = number (file, "POINTS", header.at ("POINTS")[0]);
  if (shape == PcdShape::Image && height <= 1)
    file.fail ("HEIGHT",
               "the cloud is not organized (height 1); save it as an image of width x "
               "height points, or give it to pcl_msf_register, which needs no grid");
  checkSize (file, path, shape, width, height);
  if (points != width * height)
    file.fail ("POINTS",
               std::to_string (points) + ", not WIDTH x HEIGHT, " +
                   std::to_string (width * height) + "; the header is damaged");
  const PointSize point = pointSize (file, header);
  const std::string& data = header.at ("DATA")[0];
  if (head.begin > 0 && data != "ascii")
    file.fail ("encoding",
               "a byte order mark stands before binary data; give the file as it was "
               "before a text editor saved it");
  if (data == "binary_compressed") {
    checkPacked (file, points * point.bytes);
    return head;
  }
  if (data != "binary" && data != "ascii")
    file.fail ("DATA",
               "'" + data.substr (0, 32) +
                   "' is neither ascii, binary nor binary_compressed");
  // Text takes a digit and a blank a value at least.
  const std::int64_t least =
      data == "binary" ? points * point.bytes : 2 * points * point.fields - 1;
  if (static_cast<std::int64_t> (file.remaining()) < least)
    file.fail ("points",
               "fewer bytes than the header announces; the file is cut short");
  return head;
}

} // namespace pcl_msf::io
