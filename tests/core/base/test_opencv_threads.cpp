// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include <gtest/gtest.h>

#include <opencv2/core/utility.hpp>

#include "core/base/opencv_threads.h"

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace {

using namespace pcl_msf;

/** The threads that a loop of OpenCV runs on. */
std::set<std::thread::id>
threadsOfOpenCv ()
{
  std::mutex mutex;
  std::set<std::thread::id> ids;
  cv::parallel_for_ ({0, 64}, [&] (const cv::Range&) {
    std::this_thread::sleep_for (std::chrono::milliseconds (1));
    const std::lock_guard<std::mutex> lock (mutex);
    ids.insert (std::this_thread::get_id());
  });
  return ids;
}

TEST (OpenCvThreads, StayInThisThreadAlsoSideBySide)
{
  const int setting = cv::getNumThreads();
  cv::setNumThreads (2);
  std::atomic<int> others{0};
  std::vector<std::thread> users;
  for (int t = 0; t < 4; ++t)
    users.emplace_back ([&, t] {
      for (int i = 0; i < 20; ++i)
        withThreads (1, [&] {
          for (int k = 0; k < 1 + (i + t) % 3; ++k)
            others += threadsOfOpenCv() !=
                              std::set<std::thread::id>{std::this_thread::get_id()}
                          ? 1
                          : 0;
        });
    });
  for (std::thread& user : users)
    user.join();
  EXPECT_EQ (others, 0);
  EXPECT_EQ (cv::getNumThreads(), 2) << "nothing is set";
  cv::setNumThreads (setting);
}

TEST (OpenCvThreads, ExceptionsComeThrough)
{
  EXPECT_THROW (inThisThread ([] { throw std::runtime_error ("as wanted"); }),
                std::runtime_error);
  bool called = false;
  inThisThread ([&] { inThisThread ([&] { called = true; }); });
  EXPECT_TRUE (called);
}

TEST (OpenCvThreads, TheLastToLeaveLetsThoseInWhomOthersWaitFor)
{
  std::promise<void> first_is_in;
  std::promise<void> second_is_in;
  std::thread first ([&] {
    inThisThread ([&] {
      first_is_in.set_value();
      second_is_in.get_future().wait();
    }); // stays until the second has left
  });
  first_is_in.get_future().wait();
  bool helped = false;
  inThisThread ([&] {
    second_is_in.set_value();
    std::this_thread::sleep_for (std::chrono::milliseconds (50));
    std::thread helper ([&] { inThisThread ([&] { helped = true; }); });
    helper.join();
  });
  first.join();
  EXPECT_TRUE (helped);
}

} // namespace
