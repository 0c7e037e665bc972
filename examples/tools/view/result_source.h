// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/visualization/result_scenes.h>

#include <memory>
#include <string>

namespace pcl_msf::tool {

/** \brief Results that another thread makes, one after the other, to be looked at
 * meanwhile. Thread-safe. */
class ResultSource {
public:
  using Result = std::shared_ptr<const visualization::ResultClouds>;

  virtual ~ResultSource() = default;

  /** \brief How many results there were so far. */
  virtual int
  solved () const = 0;

  /** \brief The result of a number below solved (); null when it is not there. */
  virtual Result
  result (int number) const = 0;

  /** \brief What a result is, in a few words. */
  virtual std::string
  title (int number) const = 0;

  /** \brief Why solving ended before the end; empty when it did not. */
  virtual std::string
  problem () const = 0;

  /** \brief Is the newest result the one to look at? */
  virtual bool
  isLive () const
  {
    return false;
  }
};

} // namespace pcl_msf::tool
