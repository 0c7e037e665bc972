// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl_msf/parameters.h>

#include <cmath>

namespace pcl_msf {

namespace {

/** Remembers the first requirement that does not hold. */
class Requirements {
public:
  void
  need (bool holds, const char* what)
  {
    if (!holds && failed_.empty())
      failed_ = what;
  }
  bool
  met (std::string* why) const
  {
    if (why && !failed_.empty())
      *why = failed_;
    return failed_.empty();
  }

private:
  std::string failed_;
};

bool
between (double value, double low, double high)
{
  return std::isfinite (value) && value >= low && value <= high;
}

/** Is a value one of those that its enumeration names, from 0 to the last? */
template <typename Enum>
bool
named (Enum value, Enum last)
{
  return static_cast<int> (value) >= 0 &&
         static_cast<int> (value) <= static_cast<int> (last);
}

constexpr double kHuge = 1e12; // "1e12" in the messages

} // namespace

bool
FrameParameters::isValid (std::string* why) const
{
  Requirements r;
  r.need (between (smoothing_sigma, 0.0, 10.0),
          "smoothing_sigma must be in [0, 10] px");
  r.need (between (min_depth, 0.0, kHuge), "min_depth must be in [0, 1e12] m");
  r.need (between (max_depth, 0.0, kHuge) && max_depth > min_depth,
          "max_depth must be greater than min_depth and at most 1e12 m");
  r.need (max_levels >= 1 && max_levels <= 10, "max_levels must be in [1, 10]");
  r.need (finest_level >= 0 && finest_level <= 4, "finest_level must be in [0, 4]");
  r.need (named (normals, NormalMethod::Skip), "normals is not a NormalMethod");
  return r.met (why);
}

bool
SegmentationParameters::isValid (std::string* why) const
{
  Requirements r;
  r.need (between (threshold, 1e-9, kHuge), "threshold must be in [1e-9, 1e12]");
  r.need (min_points >= 1, "min_points must be >= 1");
  r.need (segment_size >= 4 && segment_size <= 512,
          "segment_size must be in [4, 512] px");
  r.need (named (method, SegmentationMethod::Single),
          "method is not a SegmentationMethod");
  return r.met (why);
}

bool
EnergyParameters::isValid (std::string* why) const
{
  Requirements r;
  r.need (between (brightness_weight, 0.0, kHuge),
          "brightness_weight must be in [0, 1e12]");
  r.need (between (icp_weight, 0.0, kHuge), "icp_weight must be in [0, 1e12]");
  r.need (brightness_weight + icp_weight > 0.0,
          "brightness_weight and icp_weight are both 0: one must be more");
  r.need (between (regularizer_weight, 0.0, kHuge),
          "regularizer_weight must be in [0, 1e12]");
  r.need (between (prior_weight, 1e-12, kHuge),
          "prior_weight must be in [1e-12, 1e12]");
  r.need (between (huber_threshold, 0.0, kHuge),
          "huber_threshold must be in [0, 1e12]");
  r.need (neighbors >= 0 && neighbors <= 64, "neighbors must be in [0, 64]");
  r.need (named (loss, LossType::L2), "loss is not a LossType");
  r.need (named (pose_difference, PoseDifference::Parameters),
          "pose_difference is not a PoseDifference");
  return r.met (why);
}

bool
SolverParameters::isValid (std::string* why) const
{
  Requirements r;
  r.need (max_iterations >= 0, "max_iterations must be >= 0");
  r.need (between (function_tolerance, 0.0, 1.0),
          "function_tolerance must be in [0, 1]");
  r.need (between (parameter_tolerance, 0.0, 1.0),
          "parameter_tolerance must be in [0, 1]");
  r.need (between (max_seconds, 0.0, kHuge),
          "max_seconds must be in [0, 1e12] s; 0 = no limit");
  r.need (levels >= 1 && levels <= 10, "levels must be in [1, 10]");
  constexpr unsigned most = 1024; // more is a negative number in disguise
  r.need (threads <= most, "threads must be in [0, 1024]; 0 = all");
  r.need (named (linear_solver, LinearSolver::SparseCholesky),
          "linear_solver is not a LinearSolver");
  return r.met (why);
}

} // namespace pcl_msf
