// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/method_options.h"
#include "common/methods/method.h"
#include <pcl_msf/oversegmentation.h>
#include <pcl_msf/rgbd_frame.h>

#include <string>

namespace pcl_msf::tool {

/** \brief Where segments come from; the truth tells which stage loses a row. */
enum class LabelSource {
  Method, ///< the segmentation, as a user gets it
  Truth,  ///< the true bodies
  Cut     ///< the segmentation, cut along the borders of the true bodies
};

/** \brief Where start poses come from. */
enum class StartSource {
  Method, ///< optical flow and proposals, as a user gets it
  Truth   ///< rigid fits of the segments to the true scene flow
};

/** \brief SceneFlowEstimator with given settings. */
class OwnMethod : public Method {
public:
  /** \param settings pairs "KEY=VALUE" joined by ':', see methodHelp(); may be empty
   * \throws UsageError for one that is unknown or has no such value */
  OwnMethod (const std::string& settings, unsigned threads);

  bool
  needsColor () const override
  {
    return false;
  }
  bool
  canRun (const PairData& pair) const override;

  Estimate
  run (const PairData& pair) const override;

private:
  void
  apply (const std::string& setting);
  Oversegmentation
  segment (const PairData& pair, const RgbdFrame& frame) const;
  SceneFlow
  estimate (const PairData& pair,
            const RgbdFrame& reference,
            const RgbdFrame& current,
            const Oversegmentation& segments) const;

  MethodSettings settings_;
  LabelSource labels_{LabelSource::Method};
  StartSource start_{StartSource::Method};
};

} // namespace pcl_msf::tool
