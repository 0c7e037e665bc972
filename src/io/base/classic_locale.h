// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

// newlocale and uselocale are POSIX, not in <clocale>
#include <locale.h> // NOLINT(modernize-deprecated-headers)

namespace pcl_msf::io {

/** \brief While it lives, this thread has the C locale, and others keep theirs: for
 * PCL's and OpenCV's readers and writers, which use atof, strtod and printf. */
class ClassicLocale {
public:
  ClassicLocale()
  : classic_ (newlocale (LC_ALL_MASK, "C", nullptr)), before_ (uselocale (classic_))
  {}
  ~ClassicLocale()
  {
    uselocale (before_);
    if (classic_ != nullptr)
      freelocale (classic_);
  }
  ClassicLocale (const ClassicLocale&) = delete;
  ClassicLocale&
  operator= (const ClassicLocale&) = delete;

private:
  locale_t classic_;
  locale_t before_;
};

} // namespace pcl_msf::io
