// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/chance.h>
#include <synthetic/scene_model.h>

namespace pcl_msf::synthetic {

// Camera at phase 0 in the origin; y down, z forward. Speeds are per unit of phase and
// chosen for about four pixels of motion; the sequence's rate is fitted to the picture.

SceneModel
buildStaticRoom (Chance& chance);

/** \param plain faint marks instead of textures */
SceneModel
buildMultiBody (Chance& chance, bool plain);

SceneModel
buildArticulated (Chance& chance);

SceneModel
buildHand (Chance& chance);

SceneModel
buildBending (Chance& chance);

SceneModel
buildBreathing (Chance& chance);

SceneModel
buildStreet (Chance& chance);

SceneModel
buildThinStructures (Chance& chance);

} // namespace pcl_msf::synthetic
