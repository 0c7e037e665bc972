// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/formats/ply_reader.h"

#include "core/base/number_text.h"
#include "io/base/input_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>

namespace pcl_msf::io {

namespace {

constexpr const char* kBlanks = " \t\r\v\f";

enum class Format { Ascii, Little, Big };

/** A number type of the format, by either of its names. */
struct Type {
  char kind; ///< i, u or f
  int bytes;
};

std::optional<Type>
typeOf (const std::string& name)
{
  static const std::array<std::pair<const char*, Type>, 16> types{
      {{"char", {'i', 1}},
       {"int8", {'i', 1}},
       {"uchar", {'u', 1}},
       {"uint8", {'u', 1}},
       {"short", {'i', 2}},
       {"int16", {'i', 2}},
       {"ushort", {'u', 2}},
       {"uint16", {'u', 2}},
       {"int", {'i', 4}},
       {"int32", {'i', 4}},
       {"uint", {'u', 4}},
       {"uint32", {'u', 4}},
       {"float", {'f', 4}},
       {"float32", {'f', 4}},
       {"double", {'f', 8}},
       {"float64", {'f', 8}}}};
  for (const auto& [text, type] : types)
    if (name == text)
      return type;
  return {};
}

struct Property {
  std::string name;
  Type type{};
};

struct Element {
  std::string name;
  std::uint64_t count{0};
  std::vector<Property> properties;
  bool has_list{false};
};

struct Header {
  Format format{Format::Ascii};
  std::vector<Element> before; ///< elements that come before the vertices
  Element vertices;
  std::uint64_t after{0}; ///< rows of the elements behind the vertices
};

Format
formatOf (InputFile& file, const std::string& name)
{
  if (name == "ascii")
    return Format::Ascii;
  if (name == "binary_little_endian")
    return Format::Little;
  if (name == "binary_big_endian")
    return Format::Big;
  file.fail ("format", "'" + name + "' is none that is known");
}

void
addProperty (InputFile& file, std::istringstream& line, Element& element)
{
  std::string type, name;
  line >> type >> name;
  if (type == "list") {
    element.has_list = true;
    return;
  }
  const auto known = typeOf (type);
  if (!known || name.empty())
    file.fail ("property", "'" + type + " " + name + "' is none that is known");
  element.properties.push_back ({name, *known});
}

std::string
headerLine (InputFile& file)
{
  std::string line = file.line ("header");
  if (!line.empty() && line.back() == '\r')
    line.pop_back();
  return line;
}

Header
readHeader (InputFile& file)
{
  Header header;
  std::vector<Element> elements;
  if (headerLine (file) != "ply")
    file.fail ("header", "does not begin with 'ply'");
  for (std::string line = headerLine (file); line != "end_header";
       line = headerLine (file)) {
    std::istringstream words (line);
    std::string word, name, count;
    words >> word;
    if (word == "format") {
      words >> name;
      header.format = formatOf (file, name);
    }
    else if (word == "element") {
      words >> name >> count;
      elements.push_back ({name, 0, {}, false});
      if (!parseNumber (count, elements.back().count))
        file.fail ("element " + name, "'" + count + "' is no number of elements");
    }
    else if (word == "property") {
      if (elements.empty())
        file.fail ("property", "stands before the first element");
      addProperty (file, words, elements.back());
    }
  }
  for (Element& element : elements) {
    if (!header.vertices.name.empty())
      header.after += element.count;
    else if (element.name == "vertex")
      header.vertices = std::move (element);
    else
      header.before.push_back (std::move (element));
  }
  if (header.vertices.name.empty())
    file.fail ("header", "has no vertices");
  if (header.vertices.has_list)
    file.fail ("vertex", "has a list as a property; such files are not read");
  return header;
}

double
number (const unsigned char* bytes, const Type& type, bool swap)
{
  std::array<unsigned char, 8> b{};
  std::copy (bytes, bytes + type.bytes, b.begin());
  if (swap)
    std::reverse (b.begin(), b.begin() + type.bytes);
  const auto as = [&b] (auto value) {
    std::memcpy (&value, b.data(), sizeof (value));
    return static_cast<double> (value);
  };
  if (type.kind == 'f')
    return type.bytes == 4 ? as (float{}) : as (double{});
  const bool is_signed = type.kind == 'i';
  switch (type.bytes) {
  case 1:
    return is_signed ? as (std::int8_t{}) : as (std::uint8_t{});
  case 2:
    return is_signed ? as (std::int16_t{}) : as (std::uint16_t{});
  default:
    return is_signed ? as (std::int32_t{}) : as (std::uint32_t{});
  }
}

/** Reads one element after the other into a row of numbers. */
class Rows {
public:
  Rows (InputFile& file, Format format) : file_ (file), format_ (format) {}

  /** \param index of the row in its element */
  void
  read (const Element& element, std::uint64_t index, std::vector<double>& row)
  {
    row.clear();
    if (format_ == Format::Ascii)
      readLine (element, "row " + std::to_string (index + 1), row);
    else
      readBytes (element, row);
  }

  /** Refuses lines of a text that the header does not count. */
  void
  finish (const Header& header)
  {
    if (format_ != Format::Ascii)
      return;
    const std::uint64_t counted = header.vertices.count + header.after;
    for (std::uint64_t i = 0; i < header.after; ++i)
      if (!file_.filledLine())
        return; // nothing that is read
    if (file_.filledLine())
      file_.fail ("row " + std::to_string (counted + 1),
                  "the header counts " + std::to_string (counted) +
                      " rows, and more follow; mend its counts or remove them");
  }

private:
  void
  readLine (const Element& element, const std::string& name, std::vector<double>& row)
  {
    if (element.properties.empty())
      return;
    const std::string line = file_.filledLine().value_or ("");
    for (std::size_t at = line.find_first_not_of (kBlanks); at != line.npos;) {
      const std::size_t end = line.find_first_of (kBlanks, at);
      row.push_back (numberOf (line.substr (at, end - at), name));
      at = line.find_first_not_of (kBlanks, end);
    }
    const std::size_t wanted = element.properties.size();
    if (row.size() < wanted && !file_.filledLine())
      file_.fail (name,
                  "the file ends too early; it is cut short or of another format");
    if (row.size() != wanted)
      file_.fail (name,
                  "has " + std::to_string (row.size()) +
                      " numbers, the header counts " + std::to_string (wanted) +
                      "; write each row into a line of its own");
  }

  double
  numberOf (const std::string& word, const std::string& name) const
  {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (!parseNumber (word, value) && lowerCase (word).find ("nan") == word.npos &&
        lowerCase (word).find ("inf") == word.npos)
      file_.fail (name, "'" + word + "' is no number");
    return value;
  }

  void
  readBytes (const Element& element, std::vector<double>& row)
  {
    std::size_t size = 0;
    for (const Property& property : element.properties)
      size += property.type.bytes;
    bytes_.resize (size);
    file_.read (bytes_.data(), size, element.name);
    const unsigned char* at = bytes_.data();
    for (const Property& property : element.properties) {
      row.push_back (number (at, property.type, format_ == Format::Big));
      at += property.type.bytes;
    }
  }

  InputFile& file_;
  Format format_;
  std::vector<unsigned char> bytes_;
};

int
columnOf (const Element& element, const std::vector<std::string>& names)
{
  for (const std::string& name : names)
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (element.properties[i].name == name)
        return static_cast<int> (i);
  return -1;
}

std::uint32_t
byteOf (double value, const Type& type)
{
  const double scaled = type.kind == 'f' ? 255.0 * value : value;
  return static_cast<std::uint32_t> (std::clamp (scaled, 0.0, 255.0) + 0.5);
}

} // namespace

PointFile
readPly (const std::string& path)
{
  InputFile file (path);
  const Header header = readHeader (file);
  const Element& vertices = header.vertices;
  const int xyz[3] = {columnOf (vertices, {"x"}),
                      columnOf (vertices, {"y"}),
                      columnOf (vertices, {"z"})};
  const int rgb[3] = {columnOf (vertices, {"red", "r", "diffuse_red"}),
                      columnOf (vertices, {"green", "g", "diffuse_green"}),
                      columnOf (vertices, {"blue", "b", "diffuse_blue"})};
  if (std::min ({xyz[0], xyz[1], xyz[2]}) < 0)
    file.fail ("vertex", "has no x, y and z");
  if (vertices.count > file.remaining()) // a byte each at the least
    file.fail ("vertex", "the file is shorter than its header says");
  Rows rows (file, header.format);
  std::vector<double> row;
  for (const Element& element : header.before) {
    if (element.has_list)
      file.fail (element.name, "stands before the vertices and has a list");
    for (std::uint64_t i = 0; i < element.count; ++i)
      rows.read (element, i, row);
  }
  const bool colored = std::min ({rgb[0], rgb[1], rgb[2]}) >= 0;
  PointFile result;
  for (std::uint64_t i = 0; i < vertices.count; ++i) {
    rows.read (vertices, i, row);
    result.points.push_back (
        Eigen::Vector3d (row[xyz[0]], row[xyz[1]], row[xyz[2]]).cast<float>());
    std::uint32_t color = 0;
    for (const int column : rgb)
      if (colored)
        color = color << 8U | byteOf (row[column], vertices.properties[column].type);
    if (colored)
      result.colors.push_back (color);
  }
  rows.finish (header);
  return result;
}

} // namespace pcl_msf::io
