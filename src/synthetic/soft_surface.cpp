// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/soft_surface.h>

#include <cmath>

namespace pcl_msf::synthetic {
namespace {

/** (sin x) / x and (1 - cos x) / x, smooth at 0: a circular arc of angle x. */
void
arc (double x, double& along, double& across)
{
  if (std::abs (x) < 1e-4) {
    along = 1.0 - x * x / 6.0;
    across = 0.5 * x - x * x * x / 24.0;
  }
  else {
    along = std::sin (x) / x;
    across = (1.0 - std::cos (x)) / x;
  }
}

class SheetForm : public SoftForm {
public:
  SheetForm (const Eigen::Vector2d& half, double phase, double start)
  : bend_ (1.1 * std::sin (0.08 * phase + start) / half.x())
  , twist_ (0.9 * std::sin (0.07 * phase + 0.4 - start) / half.x())
  , ripple_ (start - 0.12 * phase)
  {}

  Eigen::Vector3d
  place (double u, double v) const override
  {
    // An arc of constant length in u: isometric.
    double along, across;
    arc (bend_ * u, along, across);
    const double ripple = 0.035 * std::sin (7.0 * u + 3.0 * v + ripple_);
    const double z = u * across + ripple;
    // The turn around the u axis grows with u.
    const double c = std::cos (twist_ * u), s = std::sin (twist_ * u);
    return {u * along, c * v - s * z, s * v + c * z};
  }

private:
  double bend_, twist_; ///< radians per metre
  double ripple_;       ///< radians
};

double
bump (double u, double v, double u0, double v0, double width)
{
  return std::exp (-((u - u0) * (u - u0) + (v - v0) * (v - v0)) / (width * width));
}

class TorsoForm : public SoftForm {
public:
  TorsoForm (const Eigen::Vector2d& half, double phase, double start)
  : half_ (half)
  , breath_ (std::sin (0.08 * phase + start))
  , belly_ (std::sin (0.09 * phase + start + 1.1))
  , wave_ (start - 0.15 * phase)
  , sway_ (0.07 * phase)
  {}

  Eigen::Vector3d
  place (double u, double v) const override
  {
    constexpr double opening = 2.2; // radians to each side
    const double angle = opening * u / half_.x();
    double r = half_.x() / opening * (1.0 + 0.12 * std::cos (1.5 * v / half_.y()));
    const double chest = 0.045 + 0.04 * breath_;
    r += chest * (bump (u, v, -0.13, -0.18, 0.14) + bump (u, v, 0.13, -0.18, 0.14));
    r += (0.04 + 0.055 * belly_) * bump (u, v, 0.02, 0.16, 0.2);
    r += 0.01 * std::sin (9.0 * v + 6.0 * u + wave_);
    const double sway = 0.06 * std::sin (sway_ + 2.0 * v);
    // Towards the viewer is -z; wider than deep.
    return {1.25 * r * std::sin (angle) + sway,
            (1.0 + 0.08 * breath_) * v,
            -r * std::cos (angle)};
  }

private:
  Eigen::Vector2d half_;
  double breath_, belly_; ///< -1 .. 1
  double wave_, sway_;    ///< radians
};

/** The surface whose shape at a phase is Form (half, phase, start). */
template <typename Form>
class SurfaceOf : public SoftSurface {
public:
  SurfaceOf (const Eigen::Vector2d& half, double start) : half_ (half), start_ (start)
  {}

  std::unique_ptr<SoftForm>
  formAt (double phase) const override
  {
    return std::make_unique<Form> (half_, phase, start_);
  }

  Eigen::Vector2d
  halfSize () const override
  {
    return half_;
  }

private:
  Eigen::Vector2d half_;
  double start_;
};

} // namespace

SoftSurfacePtr
makeBendingSheet (const Eigen::Vector2d& half, double start)
{
  return std::make_shared<SurfaceOf<SheetForm>> (half, start);
}

SoftSurfacePtr
makeBreathingTorso (const Eigen::Vector2d& half, double start)
{
  return std::make_shared<SurfaceOf<TorsoForm>> (half, start);
}

} // namespace pcl_msf::synthetic
