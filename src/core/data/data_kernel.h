// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <cstdint>
#include <vector>

// The per-pixel arithmetic of Eq. 6 to 8, on plain arrays: no Eigen types here, so that
// this file's functions can be compiled for several instruction sets.

namespace pcl_msf {
namespace kernel {

/** \brief The current frame's level: intensity and inverse depth, interleaved. */
struct Image {
  const float* texels; ///< (I, W) per pixel; W = 0: no depth
  int width;
  int height;
  float fx, fy, cx, cy; ///< pixels
};

constexpr int kLanes =
    16; ///< points that go side by side, whatever the registers' width

/** \brief A range of reference points, see SegmentPixels. Each array can be read up to
 * the next multiple of kLanes points: what lies there is finite and does not count. */
struct Points {
  const float *x, *y, *z;
  const float* intensity;
  const float *nx, *ny, *nz;
  const float *brightness_scale, *icp_scale;
  const float* depth_tolerance;
  int count;
};

/** \brief What is frozen between linearizations, per point. */
struct Correspondences {
  float* plane_offset;  ///< n . p_corr, metres
  std::uint8_t* active; ///< sums of the bits below
};

constexpr std::uint8_t kBrightness = 1;
constexpr std::uint8_t kIcp = 2;
constexpr std::uint8_t kOccluded = 4;
constexpr std::uint8_t kOutside = 8;
constexpr std::uint8_t kUnknown = 16; ///< the frame has no depth there

/** \brief A segment's motion: q = R p + t, and o = R c + t for its centroid c. */
struct Motion {
  double rotation[9]; ///< row major
  double translation[3];
  double origin[3];
  double normal_rotation[9]; ///< carries the reference's normals; frozen, row major
};

/** \brief The loss and the rules for visibility. */
struct Rules {
  float huber;             ///< epsilon of Eq. 7, standard deviations; huge: L2
  float conflict_cost;     ///< of an ICP residual before or far off the frame's surface
  float occluded_cost;     ///< of a residual behind the frame's surface
  float outside_cost;      ///< of a residual that leaves the image
  float unknown_cost;      ///< of an ICP residual where the frame has no depth
  float brightness_weight; ///< alpha / number of residuals
  float icp_weight;        ///< beta / number of residuals
  float truncation;        ///< cost limit per residual of probe ()
};

/** \brief Sums over points: A = sum w J' J (upper triangle, row by row), b = sum w J'
 * r, with J by a left perturbation (rotation about the origin o, translation), and the
 * robust costs of both terms. */
struct Sums {
  double a[21];
  double b[6];
  double brightness_cost;
  double icp_cost;
  double hidden; ///< weight of the residuals of points occluded or out of view
};

/** \brief What linearizing functions take. */
using Sweep = void (const Points& points,
                    const Image& image,
                    const Motion& motion,
                    const Rules& rules,
                    const Correspondences& state,
                    Sums& sums);

/** \brief The functions, compiled for one instruction set. Between sets, results differ
 * by rounding only. */
struct Kernel {
  const char* name; ///< of the instruction set
  /** \brief Renews the correspondences and linearizes: adds to sums. */
  Sweep* linearize;
  /** \brief Truncated costs with fresh correspondences and visibility, for comparing
   * poses far from each other; keeps nothing. */
  void (*probe) (const Points& points,
                 const Image& image,
                 const Motion& motion,
                 const Rules& rules,
                 Sums& sums);
};

/** \brief The kernels that this processor runs, the fastest first; the last one, named
 * "default", always is. */
const std::vector<Kernel>&
usableKernels ();

/** \brief The kernel of chosenInstructionSet (). */
const Kernel&
chosenKernel ();

/** \brief Linearizes at the correspondences of the last time, in double precision: for
 * checking the above. */
Sweep linearizeKeptInDouble;

} // namespace kernel
} // namespace pcl_msf
