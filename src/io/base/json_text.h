// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <string>

namespace pcl_msf::io {

/** \brief Builds JSON text, two blanks of indent a level. Keys come in call order. */
class JsonText {
public:
  void
  openObject (const std::string& key = {});
  void
  closeObject ();
  void
  openArray (const std::string& key);
  void
  closeArray ();

  /** \brief A number that reads back exactly; null when it is not finite. An empty key
   * makes an array's element. */
  void
  number (const std::string& key, double value);
  void
  integer (const std::string& key, long value);
  void
  boolean (const std::string& key, bool value);
  void
  string (const std::string& key, const std::string& value);

  const std::string&
  text () const
  {
    return text_;
  }

private:
  void
  begin (const std::string& key);
  void
  close (char bracket);

  std::string text_;
  int depth_{0};
  bool first_{true};
};

} // namespace pcl_msf::io
