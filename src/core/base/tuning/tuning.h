// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/tuning/body_tuning.h"
#include "core/base/tuning/data_tuning.h"
#include "core/base/tuning/frame_tuning.h"
#include "core/base/tuning/point_tuning.h"
#include "core/base/tuning/result_tuning.h"
#include "core/base/tuning/segment_tuning.h"
#include "core/base/tuning/solve_tuning.h"
#include "core/base/tuning/start_tuning.h"
#include "core/base/tuning/surface_tuning.h"
#include "core/base/tuning/window_tuning.h"
#include <pcl_msf/export.h>

#include <string>
#include <utility>
#include <vector>

namespace pcl_msf {

/** \brief All values that were chosen by trial, a struct per stage of the method. What
 * follows from mathematics or only guards a division stays where it is used, as do
 * limits of the checks of input, which decide what is refused, and the settings of
 * other libraries' methods.
 *
 * Each struct says where it was chosen; BENCHMARK.md says what else was looked at, and
 * tests/benchmarks/results/sensitivity.csv what half and twice of a value change.
 * Ranges stand beside the names, in listValues. They are what makes sense to try, not
 * what works well. An estimate takes a copy of currentTuning() when it begins and hands
 * each stage its own struct. */
struct Tuning {
  FrameTuning frame;
  SurfaceTuning surface;
  SegmentTuning segments;
  WindowTuning window;
  DataTuning data;
  StartTuning start;
  BodyTuning bodies;
  ResultTuning result;
  SolveTuning solve;
  PointTuning points;
};

/** \brief All values of a tuning by name, in the order of the data's way. */
PCL_MSF_EXPORT TunedValues
tunedValues (Tuning& tuning);

/** \brief The values that estimates from now on work with. */
PCL_MSF_EXPORT const Tuning&
currentTuning ();

/** \brief Changes one of the current values, for experiments. To be called before
 * anything is estimated: not safe beside an estimate in another thread.
 * \param text a number, whole where the value is
 * \throws InvalidInput when there is no such name or the value is outside its range */
PCL_MSF_EXPORT void
setTuning (const std::string& name, const std::string& text);

/** \brief The number as text that reads back as the same. */
PCL_MSF_EXPORT std::string
valueText (const TunedValue& value);

/** \brief 16 hexadecimal digits that differ when a name or a value does. */
PCL_MSF_EXPORT std::string
tuningHash (Tuning tuning);

/** \brief Names and texts of the current values that are not the defaults. */
PCL_MSF_EXPORT std::vector<std::pair<std::string, std::string>>
changedTuning ();

} // namespace pcl_msf
