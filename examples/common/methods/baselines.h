// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/methods/method.h"

namespace pcl_msf::tool {

/** \brief No motion. */
class ZeroFlow : public Method {
public:
  bool
  needsColor () const override
  {
    return false;
  }
  Estimate
  run (const PairData& pair) const override;
};

/** \brief One rigid motion by pcl::GeneralizedIterativeClosestPoint (Segal, Haehnel and
 * Thrun, RSS 2009) on at most 12000 points of each frame, PCL's defaults otherwise. */
class Gicp : public Method {
public:
  bool
  needsColor () const override
  {
    return false;
  }
  Estimate
  run (const PairData& pair) const override;
};

/** \brief OpenCV's DIS optical flow (Kroeger et al., ECCV 2016), lifted by depth. */
class DisFlow : public Method {
public:
  /** \param preset of cv::DISOpticalFlow */
  explicit DisFlow (int preset) : preset_ (preset) {}
  bool
  needsColor () const override
  {
    return true;
  }
  Estimate
  run (const PairData& pair) const override;

private:
  int preset_;
};

/** \brief OpenCV's dual TV-L1 optical flow (Zach, Pock and Bischof, DAGM 2007), six
 * scales of half the size each and a tolerance of 0.02, lifted by depth: OpenCV's own
 * five scales of 0.8 lose large motions and take three times as long. */
class TvL1Flow : public Method {
public:
  bool
  needsColor () const override
  {
    return true;
  }
  Estimate
  run (const PairData& pair) const override;
};

} // namespace pcl_msf::tool
