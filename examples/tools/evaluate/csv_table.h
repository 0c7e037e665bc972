// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/number_text.h"
#include "csv_file.h"
#include <pcl_msf/errors.h>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_msf::tool {

/** \brief Decimals of a double: as many as it takes, none when it is not finite. */
constexpr int kShortest = -1;

/** \brief A value as a field. */
template <typename Value>
std::string
fieldText (const Value& value, int decimals)
{
  if constexpr (std::is_same_v<Value, std::string>)
    return value;
  else if constexpr (std::is_integral_v<Value>)
    return std::to_string (value);
  else if (decimals != kShortest)
    return fixedText (value, decimals);
  else
    return std::isfinite (value) ? shortestText (value) : std::string();
}

/** \brief The reverse. \return was it such a value? */
template <typename Value>
bool
readField (const std::string& text, int decimals, Value& value)
{
  if constexpr (std::is_same_v<Value, std::string>)
    value = text;
  else if constexpr (std::is_same_v<Value, bool>)
    value = text == "1";
  else if (std::is_floating_point_v<Value> && decimals == kShortest && text.empty())
    value = std::numeric_limits<Value>::quiet_NaN();
  else
    return parseNumber (text, value);
  return true;
}

/** \brief A kind of results file. \tparam Fields calls, for a row, a function for each
 * column: with its name, the row's value, and the decimals of a double (kShortest) */
template <typename Row, typename Fields>
class CsvTable {
public:
  explicit CsvTable (CsvLayout layout) : layout_ (std::move (layout))
  {
    Row row{};
    Fields() (row, [this] (const std::string& name, const auto&, int = 0) {
      layout_.columns.push_back (name);
    });
  }

  const CsvLayout&
  layout () const
  {
    return layout_;
  }

  /** \brief With its end. */
  std::string
  rowText (const Row& row) const
  {
    std::vector<std::string> fields;
    Fields() (row,
              [&] (const std::string&, const auto& value, int decimals = kShortest) {
                fields.push_back (fieldText (value, decimals));
              });
    return lineText (layout_, fields);
  }

  /** \throws InvalidInput naming the field */
  Row
  parseRow (const std::string& line) const
  {
    const std::vector<std::string> fields = splitLine (layout_, line);
    std::size_t at = 0;
    Row row{};
    Fields() (row,
              [&] (const std::string& name, auto& value, int decimals = kShortest) {
                if (!readField (fields[at], decimals, value))
                  throw InvalidInput (name + ": '" + fields[at] +
                                      "' is no number; the file is damaged");
                ++at;
              });
    return row;
  }

  /** \brief All rows that follow. \throws IoError naming file, line and field */
  std::vector<Row>
  readRows (CsvReader& reader) const
  {
    std::vector<Row> rows;
    for (std::string line; reader.next (line);)
      try {
        rows.push_back (parseRow (line));
      }
      catch (const InvalidInput& error) {
        reader.fail (error.what());
      }
    return rows;
  }

private:
  CsvLayout layout_;
};

} // namespace pcl_msf::tool
