// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/random.h>
#include <synthetic/scene_model.h>

namespace pcl_msf::synthetic {

// Camera at phase 0 in the origin; y down, z forward. Speeds are per unit of phase and
// chosen for about four pixels of motion; the sequence's rate is fitted to the picture.

SceneModel
buildStaticRoom (Random& random);

/** \param plain faint marks instead of textures */
SceneModel
buildMultiBody (Random& random, bool plain);

SceneModel
buildArticulated (Random& random);

SceneModel
buildHand (Random& random);

SceneModel
buildBending (Random& random);

SceneModel
buildBreathing (Random& random);

SceneModel
buildStreet (Random& random);

SceneModel
buildThinStructures (Random& random);

} // namespace pcl_msf::synthetic
