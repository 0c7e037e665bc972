// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "machine_speed.h"

#include "common/stop_watch.h"

#include <algorithm>
#include <fstream>
#include <vector>

namespace pcl_msf::benchmarks {

namespace {

constexpr int kRuns = 5;
constexpr int kChains = 10; // more than a unit's latency times its number
constexpr int kRounds = 2'000'000;

/** Numbers that go through a register side by side. */
template <int bytes>
using Wide __attribute__ ((vector_size (bytes))) = float;

template <int bytes>
constexpr double kOperations = 2.0 * kChains*(bytes / 4);

/** Chains of products and sums that do not wait for each other. */
template <int bytes>
__attribute__ ((always_inline)) inline float
runChains ()
{
  Wide<bytes> a[kChains];
  for (int i = 0; i < kChains; ++i)
    a[i] = Wide<bytes>{} + static_cast<float> (i);
  const Wide<bytes> m = Wide<bytes>{} + 0.999f;
  const Wide<bytes> c = Wide<bytes>{} + 0.001f;
  for (int round = 0; round < kRounds; ++round)
#pragma GCC unroll 10
    for (int i = 0; i < kChains; ++i)
      a[i] = a[i] * m + c;
  float sum = 0.0f;
  for (int i = 0; i < kChains; ++i)
    sum += a[i][0];
  return sum;
}

float
runDefault ()
{
  return runChains<16>();
}

#if defined(__x86_64__) && defined(__GNUC__)
__attribute__ ((target ("arch=x86-64-v3"))) float
runV3 ()
{
  return runChains<32>();
}

__attribute__ ((target ("arch=x86-64-v4"))) float
runV4 ()
{
  return runChains<64>();
}
#endif

volatile float sink; // what is computed is wanted

double
best (float (*run)(), double operations)
{
  double fastest = 0.0;
  for (int i = 0; i < kRuns; ++i) {
    tool::StopWatch watch;
    sink = run();
    fastest = std::max (fastest, operations * kRounds / watch.lap());
  }
  return fastest;
}

} // namespace

double
memorySpeed ()
{
  constexpr std::size_t kNumbers = 16'000'000; // 64 MB each
  std::vector<float> a (kNumbers), b (kNumbers, 1.0f), c (kNumbers, 2.0f);
  double fastest = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    tool::StopWatch watch;
    const float s = 0.5f + static_cast<float> (run);
    for (std::size_t i = 0; i < kNumbers; ++i)
      a[i] = b[i] + s * c[i];
    fastest = std::max (fastest, 12.0 * kNumbers / watch.lap());
    sink = a[kNumbers / 2];
  }
  return fastest;
}

double
arithmeticSpeed (const std::string& instruction_set)
{
#if defined(__x86_64__) && defined(__GNUC__)
  if (instruction_set == "x86-64-v4")
    return best (runV4, kOperations<64>);
  if (instruction_set == "x86-64-v3")
    return best (runV3, kOperations<32>);
#endif
  return best (runDefault, kOperations<16>);
}

std::string
processorName ()
{
  std::ifstream file ("/proc/cpuinfo");
  for (std::string line; std::getline (file, line);)
    if (line.rfind ("model name", 0) == 0 && line.find (':') + 2 < line.size())
      return line.substr (line.find (':') + 2);
  return "unknown processor";
}

} // namespace pcl_msf::benchmarks
