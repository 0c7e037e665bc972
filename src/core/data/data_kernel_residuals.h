// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

// Warped points, residuals and visibility of a block of points. Everything here is
// inlined into the functions of data_kernel.cpp, once per instruction set; each loop
// vectorizes.

#define PCL_MSF_INLINE __attribute__ ((always_inline)) inline

namespace pcl_msf {
namespace kernel {

constexpr int kBlock = 64; // points worked on at a time: stays in the first cache

enum class Mode { Renew, Keep, Probe };

/** Intermediate values of a block. Loops go over whole groups of lanes: the lanes
 * beyond the block's points hold numbers that nothing counts. */
template <typename S>
struct alignas (64) Block {
  S qx[kBlock], qy[kBlock], qz[kBlock], iz[kBlock];
  S nx[kBlock], ny[kBlock], nz[kBlock]; // normals, carried to the current frame
  S u[kBlock], v[kBlock];
  S a[kBlock], b[kBlock];  // shares of the right and the lower texels
  float texels[8][kBlock]; // I and W: upper left, upper right, lower left, lower right
  int at[kBlock];          // of the upper left texel
  S brightness[kBlock], gu[kBlock], gv[kBlock];
  S icp[kBlock];
  S brightness_on[kBlock], icp_on[kBlock]; // 0 or 1
  S hidden[kBlock];                        // cost of a residual that is off
  S wb[kBlock], wi[kBlock];                // robust weights times term weights
  S jb[6][kBlock], ji[6][kBlock];
};

/** 1 where a condition holds, else 0: keeps the loops free of branches. */
template <typename S>
PCL_MSF_INLINE S
mask (bool condition)
{
  return condition ? S (1) : S (0);
}

template <typename S>
PCL_MSF_INLINE S
smaller (S a, S b)
{
  return a < b ? a : b;
}

template <typename S>
PCL_MSF_INLINE S
larger (S a, S b)
{
  return a > b ? a : b;
}

template <typename S>
PCL_MSF_INLINE void
warp (const Points& p, int n, const Image& image, const Motion& m, Block<S>& k)
{
  const S r0 = m.rotation[0], r1 = m.rotation[1], r2 = m.rotation[2];
  const S r3 = m.rotation[3], r4 = m.rotation[4], r5 = m.rotation[5];
  const S r6 = m.rotation[6], r7 = m.rotation[7], r8 = m.rotation[8];
  const S t0 = m.translation[0], t1 = m.translation[1], t2 = m.translation[2];
  const S fx = image.fx, fy = image.fy, cx = image.cx, cy = image.cy;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S x = p.x[i];
      const S y = p.y[i];
      const S z = p.z[i];
      const S qx = r0 * x + r1 * y + r2 * z + t0;
      const S qy = r3 * x + r4 * y + r5 * z + t1;
      const S qz = r6 * x + r7 * y + r8 * z + t2;
      const S iz = S (1) / larger (qz, S (1e-3));
      k.qx[i] = qx;
      k.qy[i] = qy;
      k.qz[i] = qz;
      k.iz[i] = iz;
      k.u[i] = fx * qx * iz + cx;
      k.v[i] = fy * qy * iz + cy;
    }
}

/** Turns the normals with the frozen rotation. */
template <typename S>
PCL_MSF_INLINE void
turnNormals (const Points& p, int n, const Motion& m, Block<S>& k)
{
  const double* r = m.normal_rotation;
  const S r0 = r[0], r1 = r[1], r2 = r[2], r3 = r[3], r4 = r[4], r5 = r[5];
  const S r6 = r[6], r7 = r[7], r8 = r[8];
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S x = p.nx[i];
      const S y = p.ny[i];
      const S z = p.nz[i];
      k.nx[i] = r0 * x + r1 * y + r2 * z;
      k.ny[i] = r3 * x + r4 * y + r5 * z;
      k.nz[i] = r6 * x + r7 * y + r8 * z;
    }
}

/** Where each warped point lies among the frame's texels; at the border if outside. */
template <typename S>
PCL_MSF_INLINE void
locate (int n, const Image& image, Block<S>& k)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  const int row = 2 * image.width;
  const int end_u = image.width - 2;
  const int end_v = image.height - 2;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S u = smaller (larger (k.u[i], S (0)), last_u);
      const S v = smaller (larger (k.v[i], S (0)), last_v);
      const int u0 = smaller (static_cast<int> (u), end_u);
      const int v0 = smaller (static_cast<int> (v), end_v);
      k.a[i] = u - static_cast<S> (u0);
      k.b[i] = v - static_cast<S> (v0);
      k.at[i] = v0 * row + 2 * u0;
    }
}

#if defined(__clang__) || __GNUC__ >= 12
#define PCL_MSF_SHUFFLE __builtin_shufflevector
#else
using QuadIndices __attribute__ ((vector_size (16))) = int;
#define PCL_MSF_SHUFFLE(a, b, ...) __builtin_shuffle (a, b, QuadIndices{__VA_ARGS__})
#endif

using Quad __attribute__ ((vector_size (16))) = float;

/** Transposes four rows of four numbers; the results lie kBlock apart. */
PCL_MSF_INLINE void
transpose (
    const float* r0, const float* r1, const float* r2, const float* r3, float* out)
{
  // By memcpy: Clang takes what a reference to a vector refers to as aligned.
  const auto at = [](const float* p) __attribute__ ((always_inline))->Quad
  {
    Quad quad;
    std::memcpy (&quad, p, sizeof (quad));
    return quad;
  };
  const Quad left01 = PCL_MSF_SHUFFLE (at (r0), at (r1), 0, 4, 1, 5);
  const Quad left23 = PCL_MSF_SHUFFLE (at (r2), at (r3), 0, 4, 1, 5);
  const Quad right01 = PCL_MSF_SHUFFLE (at (r0), at (r1), 2, 6, 3, 7);
  const Quad right23 = PCL_MSF_SHUFFLE (at (r2), at (r3), 2, 6, 3, 7);
  const auto put = [out](int j, const Quad& quad) __attribute__ ((always_inline))
  {
    std::memcpy (out + j * kBlock, &quad, sizeof (quad));
  };
  put (0, PCL_MSF_SHUFFLE (left01, left23, 0, 1, 4, 5));
  put (1, PCL_MSF_SHUFFLE (left01, left23, 2, 3, 6, 7));
  put (2, PCL_MSF_SHUFFLE (right01, right23, 0, 1, 4, 5));
  put (3, PCL_MSF_SHUFFLE (right01, right23, 2, 3, 6, 7));
}

/** Fetches the four texels of each point: intensity and inverse depth lie together. */
template <typename S>
PCL_MSF_INLINE void
fetch (int n, const Image& image, Block<S>& k)
{
  const float* const upper = image.texels;
  const float* const lower = upper + 2 * image.width;
  for (int i = 0; i < n || i % kLanes != 0; i += 4) {
    const int* at = k.at + i;
    transpose (
        upper + at[0], upper + at[1], upper + at[2], upper + at[3], k.texels[0] + i);
    transpose (
        lower + at[0], lower + at[1], lower + at[2], lower + at[3], k.texels[4] + i);
  }
}

/** Bilinear intensity, its derivatives, and the brightness residual. */
template <typename S>
PCL_MSF_INLINE void
compareIntensity (const Points& p, int n, const Image& image, Block<S>& k)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S i00 = k.texels[0][i];
      const S i10 = k.texels[2][i];
      const S i01 = k.texels[4][i];
      const S i11 = k.texels[6][i];
      const S top = i00 + k.a[i] * (i10 - i00);
      const S low = i01 + k.a[i] * (i11 - i01);
      const S scale = p.brightness_scale[i];
      // The clamped border is flat.
      const S in_u = mask<S> (k.u[i] >= S (0)) * mask<S> (k.u[i] <= last_u) * scale;
      const S in_v = mask<S> (k.v[i] >= S (0)) * mask<S> (k.v[i] <= last_v) * scale;
      k.brightness[i] = (top + k.b[i] * (low - top) - S (p.intensity[i])) * scale;
      k.gu[i] = ((i10 - i00) + k.b[i] * ((i11 - i01) - (i10 - i00))) * in_u;
      k.gv[i] = (low - top) * in_v;
    }
}

/** Finds p_corr on the ray of each warped point and decides what is visible. */
template <typename S>
PCL_MSF_INLINE void
correspond (const Points& p,
            int n,
            const Image& image,
            Block<S>& k,
            float* plane_offset,
            int* bits)
{
  const S last_u = image.width - 1;
  const S last_v = image.height - 1;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S w00 = k.texels[1][i];
      const S w10 = k.texels[3][i];
      const S w01 = k.texels[5][i];
      const S w11 = k.texels[7][i];
      const S high = larger (larger (w00, w10), larger (w01, w11));
      const S low = smaller (smaller (w00, w10), smaller (w01, w11));
      const S tolerance = p.depth_tolerance[i];
      const S top = w00 + k.a[i] * (w10 - w00);
      const S bottom = w01 + k.a[i] * (w11 - w01);
      // Bilinear on one surface, the nearest texel where surfaces meet.
      const S right = mask<S> (k.a[i] >= S (0.5));
      const S lower = mask<S> (k.b[i] >= S (0.5));
      const S left_value = w00 + lower * (w01 - w00);
      const S right_value = w10 + lower * (w11 - w10);
      const S nearest = left_value + right * (right_value - left_value);
      const S smooth = mask<S> (low > S (0)) * mask<S> (high - low < tolerance);
      const S w = nearest + smooth * (top + k.b[i] * (bottom - top) - nearest);
      const S inside = mask<S> (k.u[i] >= S (-0.5)) * mask<S> (k.v[i] >= S (-0.5)) *
                       mask<S> (k.u[i] <= last_u + S (0.5)) *
                       mask<S> (k.v[i] <= last_v + S (0.5)) *
                       mask<S> (k.qz[i] > S (1e-3));
      const S behind = w - k.iz[i]; // > 0: the frame shows something nearer
      const S known = mask<S> (w > S (1e-6));
      const S occluded = known * mask<S> (behind > tolerance);
      const S fits = known * mask<S> (behind > S (-3) * tolerance) * (S (1) - occluded);
      const S ray = k.nx[i] * k.qx[i] + k.ny[i] * k.qy[i] + k.nz[i] * k.qz[i];
      plane_offset[i] = static_cast<float> (ray * k.iz[i] / larger (w, S (1e-6)));
      bits[i] = static_cast<int> (inside * (S (kBrightness) * (S (1) - occluded) +
                                            S (kIcp) * fits + S (kOccluded) * occluded +
                                            S (kUnknown) * (S (1) - known)) +
                                  S (kOutside) * (S (1) - inside));
    }
}

template <typename S>
PCL_MSF_INLINE void
planeDistance (const Points& p,
               int n,
               const float* plane_offset,
               const int* bits,
               const Rules& rules,
               Block<S>& k)
{
  const S conflict = rules.conflict_cost;
  const S occluded = S (rules.occluded_cost) - conflict;
  const S outside = S (rules.outside_cost) - conflict;
  const S unknown = S (rules.unknown_cost) - conflict;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S along = k.nx[i] * k.qx[i] + k.ny[i] * k.qy[i] + k.nz[i] * k.qz[i];
      k.icp[i] = (along - S (plane_offset[i])) * S (p.icp_scale[i]);
      k.brightness_on[i] = static_cast<S> (bits[i] & 1);
      k.icp_on[i] = static_cast<S> ((bits[i] >> 1) & 1);
      k.hidden[i] = conflict + occluded * static_cast<S> ((bits[i] >> 2) & 1) +
                    outside * static_cast<S> ((bits[i] >> 3) & 1) +
                    unknown * static_cast<S> ((bits[i] >> 4) & 1);
    }
}

} // namespace kernel
} // namespace pcl_msf
