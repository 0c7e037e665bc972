// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "core/base/tuning/tuning.h"

#include "core/base/number_text.h"
#include <pcl_msf/errors.h>

#include <cmath>
#include <cstdint>

namespace pcl_msf {

namespace {

Tuning&
current ()
{
  static Tuning tuning;
  return tuning;
}

void
set (const TunedValue& value, double number)
{
  std::visit (
      [number] (auto* place) {
        *place = static_cast<std::decay_t<decltype (*place)>> (number);
      },
      value.place);
}

std::string
rangeText (const TunedValue& value)
{
  const bool whole = std::holds_alternative<int*> (value.place);
  return std::string (whole ? "a whole number" : "a number") + " from " +
         generalText (value.least) + " to " + generalText (value.most);
}

} // namespace

TunedValues
tunedValues (Tuning& tuning)
{
  TunedValues values;
  listValues (tuning.frame, values);
  listValues (tuning.surface, values);
  listValues (tuning.segments, values);
  listValues (tuning.window, values);
  listValues (tuning.data, values);
  listValues (tuning.start, values);
  listValues (tuning.bodies, values);
  listValues (tuning.result, values);
  listValues (tuning.solve, values);
  listValues (tuning.points, values);
  return values;
}

const Tuning&
currentTuning ()
{
  return current();
}

void
setTuning (const std::string& name, const std::string& text)
{
  for (const TunedValue& value : tunedValues (current()))
    if (value.name == name) {
      double number = 0.0;
      const bool whole = std::holds_alternative<int*> (value.place);
      if (!parseNumber (text, number) ||
          !(number >= value.least && number <= value.most) ||
          (whole && number != std::floor (number)))
        throw InvalidInput (name + " is '" + text + "': give " + rangeText (value));
      set (value, number);
      return;
    }
  throw InvalidInput ("there is no tuned value '" + name +
                      "': see the list of all, by --list-tuning");
}

std::string
valueText (const TunedValue& value)
{
  return std::visit (
      [] (const auto* place) {
        std::array<char, 64> text{};
        const auto end = std::to_chars (text.data(), text.data() + text.size(), *place);
        return std::string (text.data(), end.ptr);
      },
      value.place);
}

std::string
tuningHash (Tuning tuning)
{
  std::uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
  for (const TunedValue& value : tunedValues (tuning))
    for (const char letter : value.name + "=" + valueText (value) + "\n")
      hash = (hash ^ static_cast<unsigned char> (letter)) * 0x100000001b3U;
  std::string text (16, '0');
  for (std::size_t i = 0; i < text.size(); ++i)
    text[i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 15U];
  return text;
}

std::vector<std::pair<std::string, std::string>>
changedTuning ()
{
  Tuning defaults;
  Tuning now = current();
  const TunedValues before = tunedValues (defaults);
  const TunedValues values = tunedValues (now);
  std::vector<std::pair<std::string, std::string>> changed;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (valueText (values[i]) != valueText (before[i]))
      changed.emplace_back (values[i].name, valueText (values[i]));
  return changed;
}

} // namespace pcl_msf
