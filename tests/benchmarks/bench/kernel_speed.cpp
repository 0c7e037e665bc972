// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "kernel_speed.h"

#include "common/stop_watch.h"
#include "kernel_scene.h"
#include "machine_speed.h"

#include <algorithm>

namespace pcl_msf::benchmarks {

namespace {

constexpr int kRuns = 15;

using Function = kernel::Sums (KernelScene::*) (const kernel::Kernel&);

KernelSpeed
speedOf (KernelScene& scene,
         const kernel::Kernel& kernel,
         const char* name,
         Function function,
         const KernelWork& work)
{
  double seconds = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    tool::StopWatch watch;
    (scene.*function) (kernel);
    seconds = std::min (seconds, watch.lap());
  }
  const double points = scene.points() / seconds;
  return {std::string (name) + " " + kernel.name,
          points,
          points * work.bytes,
          points * work.operations,
          0.0,
          0.0};
}

} // namespace

std::vector<KernelSpeed>
kernelSpeeds (int width, int height)
{
  KernelScene scene (width, height);
  const double memory = memorySpeed();
  std::vector<KernelSpeed> speeds;
  for (const kernel::Kernel& kernel : kernel::usableKernels()) {
    const double units = arithmeticSpeed (kernel.name);
    const auto enter = [&] (const char* name, Function f, const KernelWork& work) {
      KernelSpeed speed = speedOf (scene, kernel, name, f, work);
      speed.memory_share = speed.bytes_per_second / memory;
      speed.units_share = speed.operations_per_second / units;
      speeds.push_back (speed);
    };
    enter ("linearize", &KernelScene::linearize, kLinearizeWork);
    enter ("probe", &KernelScene::probe, kProbeWork);
  }
  return speeds;
}

} // namespace pcl_msf::benchmarks
