// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/parameters.h>

namespace pcl_msf::tool {

/** \brief One line on a terminal that tells how far the work is; erased at the end.
 * Nothing is printed when stderr is no terminal or it is switched off. */
class ProgressLine {
public:
  explicit ProgressLine (bool wanted);
  ~ProgressLine();
  ProgressLine (const ProgressLine&) = delete;
  ProgressLine&
  operator= (const ProgressLine&) = delete;

  void
  stage (const char* name);

  void
  update (const Progress& progress);

private:
  bool shown_;
};

} // namespace pcl_msf::tool
