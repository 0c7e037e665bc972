// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "view/result_source.h"

#include <memory>

namespace pcl_msf::tool {

/** \brief The live window: PCLVisualizer with its keys, and some more. Needs a display,
 * see visualization::displayProblem. */
class ViewWindow {
public:
  explicit ViewWindow (const ResultSource& source);
  ~ViewWindow();
  ViewWindow (const ViewWindow&) = delete;
  ViewWindow&
  operator= (const ViewWindow&) = delete;

  /** \brief Handles events for a moment and shows what is new. \return false once the
   * user has closed the window */
  bool
  spin ();

  /** \brief The keys that PCLVisualizer does not have, a line each. */
  static const char*
  keys ();

private:
  class Content;
  std::unique_ptr<Content> content_;
};

} // namespace pcl_msf::tool
