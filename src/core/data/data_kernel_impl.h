// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/data/data_kernel_residuals.h"

// Robust costs and normal equations of a block of points, and the loop over the blocks.

namespace pcl_msf {
namespace kernel {

/** Eq. 7 with rho (r) = r^2 / 2 inside: q (|r| - q / 2) with q = min (|r|, epsilon). */
template <typename S>
PCL_MSF_INLINE S
robustCost (S r, S huber)
{
  const S magnitude = std::abs (r);
  const S q = smaller (magnitude, huber);
  return q * (magnitude - S (0.5) * q);
}

/** rho' (r) / r. */
template <typename S>
PCL_MSF_INLINE S
robustWeight (S r, S huber)
{
  const S magnitude = larger (S (std::abs (r)), S (1e-6));
  return smaller (magnitude, huber) / magnitude;
}

constexpr int kSingleSums = 1024; // points that are summed up in the kernel's precision

/** kLanes numbers that go through arithmetic side by side. */
template <typename S>
using Lanes __attribute__ ((vector_size (kLanes * sizeof (S)), may_alias)) = S;

/** Sums of kLanes points side by side, carried on over the blocks. */
template <typename S>
struct alignas (64) LaneSums {
  S a[21][kLanes];
  S b[6][kLanes];
  S brightness[kLanes], icp[kLanes];
  S hidden_brightness[kLanes], hidden_icp[kLanes];
};

/** By halves. */
template <typename S>
PCL_MSF_INLINE double
total (const S* lanes)
{
  S eight[8];
  S four[4];
#pragma omp simd
  for (int i = 0; i < 8; ++i)
    eight[i] = lanes[i] + lanes[i + 8];
#pragma omp simd
  for (int i = 0; i < 4; ++i)
    four[i] = eight[i] + eight[i + 4];
  return static_cast<double> ((four[0] + four[2]) + (four[1] + four[3]));
}

/** Adds the block's costs. Points whose residual is switched off do not count. */
template <typename S, Mode mode>
PCL_MSF_INLINE void
addCosts (
    const Points& p, int n, const Rules& rules, const Block<S>& k, LaneSums<S>& sums)
{
  const S huber = rules.huber;
  const S limit = mode == Mode::Probe ? S (rules.truncation) : S (1e30);
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int lane = 0; lane < kLanes; ++lane) {
      const int i = group + lane;
      const S cb = smaller (robustCost (k.brightness[i], huber), limit);
      const S ci = smaller (robustCost (k.icp[i], huber), limit);
      const S has_b = mask<S> (p.brightness_scale[i] > 0.0f) * mask<S> (i < n);
      const S has_i = mask<S> (p.icp_scale[i] > 0.0f) * mask<S> (i < n);
      const S on_b = k.brightness_on[i];
      const S on_i = k.icp_on[i];
      sums.brightness[lane] += has_b * (on_b * cb + (S (1) - on_b) * k.hidden[i]);
      sums.icp[lane] += has_i * (on_i * ci + (S (1) - on_i) * k.hidden[i]);
      sums.hidden_brightness[lane] += has_b * (S (1) - on_b);
      sums.hidden_icp[lane] += has_i * (S (1) - on_b);
    }
}

/** Jacobians by a left perturbation about the motion's origin, and weights. */
template <typename S>
PCL_MSF_INLINE void
differentiate (const Points& p,
               int n,
               const Image& image,
               const Motion& m,
               const Rules& rules,
               Block<S>& k)
{
  const S fx = image.fx, fy = image.fy;
  const S ox = m.origin[0], oy = m.origin[1], oz = m.origin[2];
  const S huber = rules.huber;
  for (int group = 0; group < n; group += kLanes)
#pragma omp simd
    for (int i = group; i < group + kLanes; ++i) {
      const S mx = k.qx[i] - ox;
      const S my = k.qy[i] - oy;
      const S mz = k.qz[i] - oz;
      const S bx = k.gu[i] * fx * k.iz[i];
      const S by = k.gv[i] * fy * k.iz[i];
      const S bz = -(bx * k.qx[i] + by * k.qy[i]) * k.iz[i];
      k.jb[0][i] = my * bz - mz * by;
      k.jb[1][i] = mz * bx - mx * bz;
      k.jb[2][i] = mx * by - my * bx;
      k.jb[3][i] = bx;
      k.jb[4][i] = by;
      k.jb[5][i] = bz;
      const S s = p.icp_scale[i];
      const S nx = k.nx[i] * s;
      const S ny = k.ny[i] * s;
      const S nz = k.nz[i] * s;
      k.ji[0][i] = my * nz - mz * ny;
      k.ji[1][i] = mz * nx - mx * nz;
      k.ji[2][i] = mx * ny - my * nx;
      k.ji[3][i] = nx;
      k.ji[4][i] = ny;
      k.ji[5][i] = nz;
      k.wb[i] = mask<S> (i < n) * k.brightness_on[i] *
                robustWeight (k.brightness[i], huber) * S (rules.brightness_weight);
      k.wi[i] = mask<S> (i < n) * k.icp_on[i] * robustWeight (k.icp[i], huber) *
                S (rules.icp_weight);
    }
}

template <typename S>
PCL_MSF_INLINE const Lanes<S>&
lanesAt (const S* first)
{
  return *reinterpret_cast<const Lanes<S>*> (first);
}

template <typename S>
PCL_MSF_INLINE Lanes<S>&
lanesAt (S* first)
{
  return *reinterpret_cast<Lanes<S>*> (first);
}

/** Row r of the normal equations, from the diagonal on: its sums stay in registers. */
template <typename S, int r>
PCL_MSF_INLINE void
addRow (int n, const Block<S>& k, LaneSums<S>& sums)
{
  constexpr int columns = 6 - r;
  S (*const row)[kLanes] = sums.a + r * 6 - r * (r - 1) / 2;
  Lanes<S> b = lanesAt (sums.b[r]);
  Lanes<S> a[columns];
  for (int c = 0; c < columns; ++c)
    a[c] = lanesAt (row[c]);
  for (int i = 0; i < n; i += kLanes) {
    const Lanes<S> vb = lanesAt (k.wb + i) * lanesAt (k.jb[r] + i);
    const Lanes<S> vi = lanesAt (k.wi + i) * lanesAt (k.ji[r] + i);
    b += vb * lanesAt (k.brightness + i) + vi * lanesAt (k.icp + i);
    for (int c = 0; c < columns; ++c)
      a[c] += vb * lanesAt (k.jb[r + c] + i) + vi * lanesAt (k.ji[r + c] + i);
  }
  lanesAt (sums.b[r]) = b;
  for (int c = 0; c < columns; ++c)
    lanesAt (row[c]) = a[c];
}

template <typename S>
PCL_MSF_INLINE void
addNormalEquations (int n, const Block<S>& k, LaneSums<S>& sums)
{
  addRow<S, 0> (n, k, sums);
  addRow<S, 1> (n, k, sums);
  addRow<S, 2> (n, k, sums);
  addRow<S, 3> (n, k, sums);
  addRow<S, 4> (n, k, sums);
  addRow<S, 5> (n, k, sums);
}

template <typename S, Mode mode>
PCL_MSF_INLINE void
clear (LaneSums<S>& sums)
{
  const auto zero = [] (auto& values) {
    std::fill (std::begin (values), std::end (values), S (0));
  };
  if (mode != Mode::Probe) {
    for (auto& values : sums.a)
      zero (values);
    for (auto& values : sums.b)
      zero (values);
  }
  for (auto* values :
       {&sums.brightness, &sums.icp, &sums.hidden_brightness, &sums.hidden_icp})
    zero (*values);
}

template <typename S, Mode mode>
PCL_MSF_INLINE void
finish (const LaneSums<S>& lanes, const Rules& rules, Sums& sums)
{
  sums.brightness_cost += total (lanes.brightness) * rules.brightness_weight;
  sums.icp_cost += total (lanes.icp) * rules.icp_weight;
  sums.hidden += total (lanes.hidden_brightness) * rules.brightness_weight +
                 total (lanes.hidden_icp) * rules.icp_weight;
  if (mode != Mode::Probe) {
    for (int i = 0; i < 21; ++i)
      sums.a[i] += total (lanes.a[i]);
    for (int i = 0; i < 6; ++i)
      sums.b[i] += total (lanes.b[i]);
  }
}

/** The points from the first on. */
PCL_MSF_INLINE Points
pointsFrom (const Points& p, int first, int n)
{
  return {p.x + first,
          p.y + first,
          p.z + first,
          p.intensity + first,
          p.nx + first,
          p.ny + first,
          p.nz + first,
          p.brightness_scale + first,
          p.icp_scale + first,
          p.depth_tolerance + first,
          n};
}

/** Notes a block's correspondences, of its own points alone. */
PCL_MSF_INLINE void
keep (int n, const float* offset, const int* bits, const Correspondences& to)
{
#pragma omp simd
  for (int i = 0; i < n; ++i)
    to.plane_offset[i] = offset[i];
#pragma omp simd
  for (int i = 0; i < n; ++i)
    to.active[i] = static_cast<std::uint8_t> (bits[i]);
}

PCL_MSF_INLINE void
recall (int n, const Correspondences& from, float* offset, int* bits)
{
#pragma omp simd
  for (int i = 0; i < n; ++i)
    offset[i] = from.plane_offset[i];
#pragma omp simd
  for (int i = 0; i < n; ++i)
    bits[i] = from.active[i];
  for (int i = n; i % kLanes != 0; ++i) {
    offset[i] = 0.0f;
    bits[i] = 0;
  }
}

/** \param state from the first point on */
template <typename S, Mode mode>
PCL_MSF_INLINE void
runBlock (const Points& p,
          const Image& image,
          const Motion& motion,
          const Rules& rules,
          const Correspondences& state,
          LaneSums<S>& sums)
{
  Block<S> k;
  float offset[kBlock];
  int bits[kBlock];
  const int n = p.count;
  warp (p, n, image, motion, k);
  turnNormals (p, n, motion, k);
  locate (n, image, k);
  fetch (n, image, k);
  compareIntensity (p, n, image, k);
  if (mode != Mode::Keep)
    correspond (p, n, image, k, offset, bits);
  if (mode == Mode::Renew)
    keep (n, offset, bits, state);
  if (mode == Mode::Keep)
    recall (n, state, offset, bits);
  planeDistance (p, n, offset, bits, rules, k);
  addCosts<S, mode> (p, n, rules, k, sums);
  if (mode != Mode::Probe) {
    differentiate (p, n, image, motion, rules, k);
    addNormalEquations (n, k, sums);
  }
}

template <typename S, Mode mode>
PCL_MSF_INLINE void
run (const Points& points,
     const Image& image,
     const Motion& motion,
     const Rules& rules,
     const Correspondences& state,
     Sums& sums)
{
  LaneSums<S> lanes;
  for (int begin = 0; begin < points.count; begin += kSingleSums) {
    clear<S, mode> (lanes);
    const int end = std::min (begin + kSingleSums, points.count);
    for (int first = begin; first < end; first += kBlock)
      runBlock<S, mode> (
          pointsFrom (points, first, std::min (kBlock, end - first)),
          image,
          motion,
          rules,
          mode == Mode::Probe
              ? state
              : Correspondences{state.plane_offset + first, state.active + first},
          lanes);
    finish<S, mode> (lanes, rules, sums);
  }
}

} // namespace kernel
} // namespace pcl_msf
