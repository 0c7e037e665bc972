// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/pcd_header.h"

#include "io/input_file.h"
#include "io/number_text.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace pcl_msf::io {

namespace {

using Words = std::vector<std::string>;

/** What of the header decides about memory. */
struct PcdHeader {
  std::vector<std::int64_t> size, count;
  std::int64_t width{-1}, height{-1}, points{-1};
  std::string data;
};

Words
nextLine (InputFile& file)
{
  std::istringstream line (file.line ("header"));
  Words words;
  for (std::string word; line >> word;)
    words.push_back (word);
  return words;
}

std::vector<std::int64_t>
numbers (const InputFile& file, const Words& words)
{
  constexpr std::int64_t kLargest = std::int64_t{1} << 40;
  std::vector<std::int64_t> result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::int64_t number = 0;
    if (!parseNumber (words[i], number) || number < 0 || number > kLargest)
      file.fail (words[0], "'" + words[i] + "' is no size; the header is damaged");
    result.push_back (number);
  }
  if (result.empty())
    file.fail (words[0], "has no value; the header is damaged");
  return result;
}

PcdHeader
readHeader (InputFile& file)
{
  PcdHeader header;
  while (header.data.empty()) {
    const Words words = nextLine (file);
    if (words.empty() || words[0][0] == '#')
      continue;
    if (words[0] == "SIZE")
      header.size = numbers (file, words);
    else if (words[0] == "COUNT")
      header.count = numbers (file, words);
    else if (words[0] == "WIDTH")
      header.width = numbers (file, words)[0];
    else if (words[0] == "HEIGHT")
      header.height = numbers (file, words)[0];
    else if (words[0] == "POINTS")
      header.points = numbers (file, words)[0];
    else if (words[0] == "DATA")
      header.data = words.size() > 1 ? words[1] : "missing";
  }
  return header;
}

std::int64_t
pointStep (const InputFile& file, const PcdHeader& header)
{
  std::int64_t step = 0;
  for (std::size_t i = 0; i < header.size.size(); ++i) {
    const std::int64_t count = i < header.count.size() ? header.count[i] : 1;
    if (header.size[i] > 8 || count > 4096)
      file.fail ("SIZE, COUNT", "absurd field sizes; the header is damaged");
    step += header.size[i] * count;
  }
  if (step < 12 || step > 65536)
    file.fail ("SIZE", "no room for x y z in a point; the header is damaged");
  return step;
}

} // namespace

void
checkPcdHeader (const std::string& path)
{
  InputFile file (path);
  const PcdHeader header = readHeader (file);
  if (header.width < 0 || header.height < 0)
    file.fail ("WIDTH, HEIGHT", "missing; the cloud must be organized");
  if (header.height <= 1)
    file.fail ("HEIGHT",
               "the cloud is not organized (height 1); save it as an image of "
               "width x height points");
  checkImageSize (path, header.width, header.height);
  if (header.points >= 0 && header.points != header.width * header.height)
    file.fail ("POINTS", "not WIDTH x HEIGHT; the header is damaged");
  const std::int64_t values =
      header.width * header.height * static_cast<std::int64_t> (header.size.size());
  const std::int64_t bytes = header.width * header.height * pointStep (file, header);
  // The best ratios of text and of LZF: one digit and a blank a value; 264 bytes in 3.
  const std::int64_t least = header.data == "binary"              ? bytes
                             : header.data == "binary_compressed" ? bytes / 88
                                                                  : 2 * values - 1;
  if (static_cast<std::int64_t> (file.remaining()) < least)
    file.fail ("points",
               "fewer bytes than the header announces; the file is cut short");
}

} // namespace pcl_msf::io
