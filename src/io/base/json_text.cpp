// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/base/json_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace pcl_msf::io {

namespace {

std::string
quoted (const std::string& text)
{
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    }
    else if (static_cast<unsigned char> (c) < 0x20) {
      std::array<char, 8> code{};
      std::snprintf (code.data(), code.size(), "\\u%04x", static_cast<unsigned> (c));
      result += code.data();
    }
    else
      result += c;
  }
  return result + '"';
}

} // namespace

void
JsonText::begin (const std::string& key)
{
  if (!first_)
    text_ += ',';
  if (depth_ > 0)
    text_ += '\n' + std::string (2 * depth_, ' ');
  if (!key.empty())
    text_ += quoted (key) + ": ";
  first_ = false;
}

void
JsonText::close (char bracket)
{
  --depth_;
  text_ += first_ ? "" : '\n' + std::string (2 * depth_, ' ');
  text_ += bracket;
  first_ = false;
  if (depth_ == 0)
    text_ += '\n';
}

void
JsonText::openObject (const std::string& key)
{
  begin (key);
  text_ += '{';
  ++depth_;
  first_ = true;
}

void
JsonText::closeObject()
{
  close ('}');
}

void
JsonText::openArray (const std::string& key)
{
  begin (key);
  text_ += '[';
  ++depth_;
  first_ = true;
}

void
JsonText::closeArray()
{
  close (']');
}

void
JsonText::number (const std::string& key, double value)
{
  begin (key);
  if (!std::isfinite (value)) {
    text_ += "null";
    return;
  }
  std::array<char, 32> digits{};
  const auto end = std::to_chars (digits.data(), digits.data() + digits.size(), value);
  text_.append (digits.data(), end.ptr);
}

void
JsonText::integer (const std::string& key, long value)
{
  begin (key);
  text_ += std::to_string (value);
}

void
JsonText::boolean (const std::string& key, bool value)
{
  begin (key);
  text_ += value ? "true" : "false";
}

void
JsonText::string (const std::string& key, const std::string& value)
{
  begin (key);
  text_ += quoted (value);
}

} // namespace pcl_msf::io
