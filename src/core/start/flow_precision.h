// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/motion/flow_evidence.h"
#include "core/start/flow_hypotheses.h"

namespace pcl_msf {

/** \brief A few matches of every segment, as precise as the reference's texture makes
 * them: the inverse of the structure tensor over a patch of the flow, of which pixels
 * near each other err alike, and what the segment's rigid fit leaves of its flow. */
FlowEvidence
evidenceOfFlow (const FlowHypotheses& flow,
                const RgbdFrame& reference,
                const PinholeCamera& current,
                const NoiseModel& noise,
                const FlowEvidenceTuning& tuning,
                int threads);

} // namespace pcl_msf
