// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>
#include <pcl_msf/io/rgbd_images.h>
#include <pcl_msf/lens_distortion.h>

namespace pcl_msf::io {

/** \brief Frees a frame's images from a lens's distortion: afterwards its pixels are
 * those of its pinhole camera, which stays the same.
 *
 * Colours are mixed bilinearly, outside of what was seen the border's go on. Depth is
 * mixed, as inverse depth, where the four pixels around differ by less than 1 %; it is
 * the nearest pixel's elsewhere, so that no point hangs between two surfaces, and NaN
 * outside. `frame.distortion` remembers the lens. Nothing happens for a lens without
 * distortion.
 * \throws InvalidInput when camera or lens are none for the images, or when the frame
 * was freed from a distortion before */
PCL_MSF_EXPORT void
undistort (RgbdImages& frame, const LensDistortion& lens);

} // namespace pcl_msf::io
