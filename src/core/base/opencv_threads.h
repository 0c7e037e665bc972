// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include <pcl_msf/export.h>

#include <functional>

namespace pcl_msf {

/** \brief Calls f, which calls OpenCV, and keeps OpenCV's own loops in this thread.
 *
 * cv::setNumThreads is a setting of the whole process, so a library that sets it and
 * sets it back breaks what other threads do meanwhile. But OpenCV does not split a loop
 * while another runs: f is called from within a loop of one step. Calls from several
 * threads go on side by side. Nothing stays changed; OpenCV's loops of other threads
 * are not split either as long as f takes. Limit: where another thread of the
 * application is within a loop of OpenCV when f begins, OpenCV may split loops of f
 * that run on after that one; its threads are there already then.
 *
 * An exception of f comes through. */
PCL_MSF_EXPORT void
inThisThread (const std::function<void()>& f);

/** \brief The same with one thread, in a forked process (OpenCV's threads stayed
 * behind), and when this thread's helpers are held up by other programs; otherwise
 * calls f, and OpenCV uses its threads. */
PCL_MSF_EXPORT void
withThreads (int threads, const std::function<void()>& f);

} // namespace pcl_msf
