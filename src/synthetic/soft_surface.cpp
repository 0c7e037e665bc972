// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <synthetic/soft_surface.h>

#include <cmath>

namespace pcl_msf {
namespace synthetic {
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

class BendingSheet : public SoftSurface {
public:
  BendingSheet (const Eigen::Vector2d& half, double start)
  : half_ (half), start_ (start)
  {}

  Eigen::Vector3d
  place (double u, double v, double phase) const override
  {
    const double bend = 1.1 * std::sin (0.08 * phase + start_);
    const double twist = 0.9 * std::sin (0.07 * phase + 0.4 - start_);
    const double slide = 0.12 * phase;
    // An arc of constant length in u: isometric.
    double along, across;
    arc (bend * u / half_.x(), along, across);
    const double ripple = 0.035 * std::sin (7.0 * u + 3.0 * v - slide + start_);
    const Eigen::Vector3d flat (u * along, v, u * across + ripple);
    // The turn around the u axis grows with u.
    const double c = std::cos (twist * u / half_.x());
    const double s = std::sin (twist * u / half_.x());
    return {flat.x(), c * flat.y() - s * flat.z(), s * flat.y() + c * flat.z()};
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

double
bump (double u, double v, double u0, double v0, double width)
{
  return std::exp (-((u - u0) * (u - u0) + (v - v0) * (v - v0)) / (width * width));
}

class BreathingTorso : public SoftSurface {
public:
  BreathingTorso (const Eigen::Vector2d& half, double start)
  : half_ (half), start_ (start)
  {}

  Eigen::Vector3d
  place (double u, double v, double phase) const override
  {
    const double breath = std::sin (0.08 * phase + start_);
    const double belly = std::sin (0.09 * phase + start_ + 1.1);
    const double wave = std::sin (5.0 * v + 4.0 * u - 0.15 * phase + start_);
    const double angle = 2.2 * u / half_.x();
    double r = half_.x() / 2.2 * (1.0 + 0.12 * std::cos (1.5 * v / half_.y()));
    r += (0.03 + 0.035 * breath) * bump (u, v, -0.13, -0.18, 0.17);
    r += (0.03 + 0.035 * breath) * bump (u, v, 0.13, -0.18, 0.17);
    r += (0.03 + 0.05 * belly) * bump (u, v, 0.02, 0.16, 0.2);
    r += 0.008 * wave;
    const double stretch = 1.0 + 0.08 * breath;
    const double sway = 0.06 * std::sin (0.07 * phase + 2.0 * v);
    // Towards the viewer is -z; wider than deep.
    return {1.25 * r * std::sin (angle) + sway, stretch * v, -r * std::cos (angle)};
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
  return std::make_shared<BendingSheet> (half, start);
}

SoftSurfacePtr
makeBreathingTorso (const Eigen::Vector2d& half, double start)
{
  return std::make_shared<BreathingTorso> (half, start);
}

} // namespace synthetic
} // namespace pcl_msf
