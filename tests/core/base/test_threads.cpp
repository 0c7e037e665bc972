// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <pcl/features/normal_3d_omp.h>

#include <gtest/gtest.h>

#include "core/base/parallel_for.h"
#include "support/box_chain.h"
#include "support/rigid_pair.h"
#include <dlfcn.h>
#include <pcl_msf/piecewise_rigid_registration.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <set>
#include <thread>

namespace {

std::atomic<int> regions_of_openmp{0};

} // namespace

/** In place of OpenMP's own: GCC turns each parallel region into a call of it. */
extern "C" [[gnu::visibility ("default")]] void
GOMP_parallel (void (*f) (void*), void* data, unsigned threads, unsigned flags)
{
  ++regions_of_openmp;
  using Own = void (*) (void (*) (void*), void*, unsigned, unsigned);
  reinterpret_cast<Own> (dlsym (RTLD_NEXT, "GOMP_parallel")) (f, data, threads, flags);
}

namespace {

using namespace pcl_msf;

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;
using Registration = PiecewiseRigidRegistration<pcl::PointXYZRGB>;

/** How many threads this process has. */
int
threadsNow ()
{
  const std::filesystem::directory_iterator tasks ("/proc/self/task");
  return static_cast<int> (std::distance (begin (tasks), end (tasks)));
}

#if defined(__SANITIZE_THREAD__)
constexpr bool kMayFork = false;
#else
constexpr bool kMayFork = true;
#endif
constexpr const char* kWhyNot =
    "ThreadSanitizer has a thread of its own, which counts, and lets no threads start "
    "in a process that was forked from one with threads";

/** What a forked process returns from f; -1 when a signal ends it. */
template <typename F>
int
inChild (const F& f)
{
  const pid_t child = fork();
  if (child == 0)
    _exit (f());
  int status = 0;
  waitpid (child, &status, 0);
  return WIFEXITED (status) ? WEXITSTATUS (status) : -1;
}

TEST (ParallelFor, CallsEachIndexOnce)
{
  for (const int threads : {1, 2, 5, 40})
    for (const int n : {0, 1, 7, 1000})
      for (const int chunk : {1, 8, 5000}) {
        std::vector<std::atomic<int>> calls (n);
        parallelFor (threads, n, chunk, [&] (int i) { ++calls[i]; });
        for (const auto& count : calls)
          ASSERT_EQ (count, 1) << threads << " threads, " << n << " by " << chunk;
        EXPECT_EQ (parallelSum (threads, n, chunk, [] (int i) { return i; }),
                   n * (n - 1) / 2);
      }
}

/** Loops that up to n threads share. */
void
loop (int n)
{
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ (parallelSum (n, 1000, 1, [] (int) { return 1; }), 1000);
}

/** In forked processes, as there no thread of another test is about to end. */
TEST (ParallelFor, HelpersStayAndAreAsManyAsAskedFor)
{
  if (!kMayFork)
    GTEST_SKIP() << kWhyNot;
  EXPECT_EQ (inChild ([] {
               loop (3);
               return threadsNow();
             }),
             3);
}

TEST (ParallelFor, HelpersEndWithTheirThread)
{
  if (!kMayFork)
    GTEST_SKIP() << kWhyNot;
  EXPECT_EQ (inChild ([] {
               std::thread ([] { loop (4); }).join();
               while (threadsNow() > 1) // they are joined, the kernel may need a moment
                 std::this_thread::yield();
               return 0;
             }),
             0);
}

TEST (ParallelFor, LoopsWithinLoopsArePlain)
{
  parallelFor (2, 4, 1, [] (int) {
    std::set<std::thread::id> ids;
    parallelFor (2, 100, 1, [&] (int) { ids.insert (std::this_thread::get_id()); });
    EXPECT_EQ (ids, std::set<std::thread::id>{std::this_thread::get_id()});
  });
}

TEST (ParallelFor, HandsOnTheFirstExceptionAndGoesOnWorking)
{
  for (const int threads : {1, 3}) {
    EXPECT_THROW (parallelFor (threads,
                               100,
                               1,
                               [] (int i) {
                                 if (i % 10 == 5)
                                   throw std::runtime_error ("as wanted");
                               }),
                  std::runtime_error);
    EXPECT_EQ (parallelSum (threads, 100, 1, [] (int) { return 1; }), 100);
  }
}

TEST (ParallelFor, WorksInAForkedProcess)
{
  if (!kMayFork)
    GTEST_SKIP() << kWhyNot;
  loop (3);
  EXPECT_EQ (inChild ([] {
               loop (3);
               return threadsNow();
             }),
             3);
  EXPECT_EQ (inChild ([] () -> int { std::exit (7); }), 7) << "ends without a loop";
  loop (3);
}

/** Two boxes without a grid. */
Cloud::Ptr
boxes (bool moved)
{
  pcl_msf::testing::BoxChain chain;
  chain.boxes = 2;
  const auto cloud = pcl::make_shared<Cloud>();
  for (const auto& p :
       pcl_msf::testing::drawChain (chain, 1500, moved, moved ? 2 : 1).points) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = p;
  }
  return cloud;
}

cv::Mat
alignBoxes (unsigned threads)
{
  Registration registration;
  registration.setNumberOfThreads (threads);
  registration.setInputSource (boxes (false));
  registration.setInputTarget (boxes (true));
  Cloud warped;
  registration.align (warped);
  EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
  return registration.getSceneFlow().displacement;
}

/** Aligns with everything that has threads. */
std::vector<cv::Mat>
alignAll (unsigned threads)
{
  std::vector<cv::Mat> flows{alignBoxes (threads)};
  for (const SegmentationMethod method : {SegmentationMethod::TangentPlane,
                                          SegmentationMethod::Felzenszwalb,
                                          SegmentationMethod::Slic})
    for (const bool window : {false, true}) {
      Registration registration;
      registration.setNumberOfThreads (threads);
      registration.setSegmentationMethod (method);
      SolverParameters solver = registration.getSolverParameters();
      solver.linear_solver = window ? LinearSolver::SparseCholesky : LinearSolver::Cgnr;
      registration.setSolverParameters (solver);
      registration.setInputSource (RigidPair::reference());
      registration.addInputTarget (RigidPair::current());
      if (window)
        registration.addInputTarget (RigidPair::reference());
      Cloud warped;
      registration.align (warped);
      EXPECT_TRUE (registration.hasConverged()) << registration.getReport().message;
      flows.push_back (registration.getSceneFlow (1).flow);
    }
  return flows;
}

bool
sameBits (const std::vector<cv::Mat>& a, const std::vector<cv::Mat>& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp (a[i].data, b[i].data, a[i].total() * a[i].elemSize()) != 0)
      return false;
  return a.size() == b.size();
}

/** In a process of its own: in this one, tests before have started threads. */
TEST (RegistrationThreads, OneStartsNone)
{
  if (!kMayFork)
    GTEST_SKIP() << kWhyNot;
  EXPECT_EQ (inChild ([] {
               alignAll (1);
               return threadsNow();
             }),
             1);
}

TEST (RegistrationThreads, OneEntersNoRegionOfOpenMp)
{
  pcl::NormalEstimationOMP<pcl::PointXYZRGB, pcl::Normal> normals (1);
  normals.setInputCloud (RigidPair::reference());
  normals.setKSearch (5);
  pcl::PointCloud<pcl::Normal> output;
  normals.compute (output);
  ASSERT_GT (regions_of_openmp, 0) << "they are counted";
  regions_of_openmp = 0;
  alignAll (1);
  Registration registration;
  registration.setNumberOfThreads (1);
  registration.setInputSource (RigidPair::reference());
  registration.setInputTarget (RigidPair::current());
  Cloud warped;
  registration.align (warped);
  pcl::Registration<pcl::PointXYZRGB, pcl::PointXYZRGB>& base = registration;
  EXPECT_LT (registration.getFitnessScore(), 1.0);
  EXPECT_LT (base.getFitnessScore(), 1.0);
  EXPECT_EQ (regions_of_openmp, 0);
}

TEST (RegistrationThreads, ForkedProcessesAlignAsTheirParentDid)
{
  if (!kMayFork)
    GTEST_SKIP() << kWhyNot;
  const std::vector<cv::Mat> before = alignAll (2);
  for (const unsigned threads : {1U, 2U})
    EXPECT_EQ (inChild ([&] { return sameBits (alignAll (threads), before) ? 0 : 1; }),
               0)
        << threads;
}

TEST (RegistrationThreads, TwoSideBySideDoAsEachAlone)
{
  const std::vector<cv::Mat> alone = alignAll (1);
  for (const unsigned threads : {1U, 3U}) {
    std::vector<cv::Mat> other;
    std::thread beside ([&] { other = alignAll (threads); });
    const std::vector<cv::Mat> own = alignAll (1);
    beside.join();
    EXPECT_TRUE (sameBits (own, alone) && sameBits (other, alone)) << threads;
  }
}

} // namespace
