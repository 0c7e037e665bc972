// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/points/point_clouds.h"
#include <pcl_msf/cloud_flow_estimator.h>

namespace pcl_msf {

/** \brief Adds the textures that both clouds have: with values where one is, and a
 * slope where that varies in both, by more than noise. \param brightness per point of
 * both clouds, or none \throws InvalidInput naming the remedy when sizes differ */
void
addTextures (const CloudBrightness& brightness,
             std::size_t source_size,
             std::size_t target_size,
             const PointBrightnessTuning& tuning,
             int threads,
             PointClouds& clouds);

/** \brief Brightness takes no part any more. */
void
dropTextures (PointClouds& clouds);

} // namespace pcl_msf
