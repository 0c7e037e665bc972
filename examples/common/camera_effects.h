// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "common/command_line.h"
#include <pcl_msf/synthetic/sequence_options.h>

#include <string>

namespace pcl_msf::tool {

/** \brief The sensors by their names. */
Words<synthetic::Sensor>
sensorWords ();

/** \brief Adds the options of what a camera does to generated images. */
void
addCameraEffects (CLI::App& app, synthetic::CameraEffects& effects);

/** \brief What differs from no effects, as a part of a line; empty when nothing does.
 */
std::string
effectsText (const synthetic::CameraEffects& effects);

/** \brief "k1,k2,p1,p2,k3". */
std::string
distortionText (const LensDistortion& lens);

} // namespace pcl_msf::tool
