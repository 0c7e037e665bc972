// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <synthetic/random.h>
#include <synthetic/scene_model.h>

namespace pcl_msf::synthetic {

/** \brief Translation, then a turn by rotation-vector degrees. */
Isometry
placed (double x,
        double y,
        double z,
        const Eigen::Vector3d& turn_degrees = Eigen::Vector3d::Zero());

/** \brief A motion that starts at a pose with the given speeds and swings back later:
 * it stays bounded for any number of frames.
 * \param speed metres per phase, world \param turn radians per phase, world axes
 * through the body's origin \param start where in the swing phase 0 is, radians, (-1,
 * 1) */
Motion
swing (const Isometry& at_rest,
       const Eigen::Vector3d& speed,
       const Eigen::Vector3d& turn,
       double start);

/** \brief The swing's progress: derivative 1 at phase 0, bounded. */
double
swingAt (double phase, double start);

/** \brief No motion. */
Motion
atRest ();

/** \brief A camera in somebody's hand: all six freedoms. \param strength 1 = about 3
 * pixels per phase at 3 m */
Motion
handHeld (Random& random, double strength);

/** \brief A texture of random hue, offset and pattern. */
Texture
anyTexture (Random& random);

/** \brief A texture of given colours. */
Texture
texture (Random& random,
         const Eigen::Vector3f& bgr,
         Pattern pattern = Pattern::Plain,
         const Eigen::Vector3f& second = {90.0f, 90.0f, 90.0f},
         float pattern_size = 0.2f);

/** \brief Floor, walls, ceiling of a room around the camera as body 0, "static": 5.6 m
 * wide, floor at y = 1.2, back wall at z = back. */
void
addRoom (SceneModel& scene, Random& random, double back = 4.6);

/** \brief Table, shelf, boxes, ball, lamp: parts of body 0. */
void
addFurniture (SceneModel& scene, Random& random);

} // namespace pcl_msf::synthetic
