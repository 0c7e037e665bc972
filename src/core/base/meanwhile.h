// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#pragma once

#include "core/base/thread_team.h"

#include <chrono>
#include <future>
#include <memory>
#include <utility>

namespace pcl_msf {

/** \brief The result of what another thread does; it ends when that is done. */
template <typename T>
class Meanwhile {
public:
  Meanwhile() = default;
  explicit Meanwhile (std::future<T> result) : result_ (std::move (result)) {}
  Meanwhile (Meanwhile&&) noexcept = default;
  Meanwhile&
  operator= (Meanwhile&& other) noexcept
  {
    std::swap (result_, other.result_);
    return *this;
  }
  ~Meanwhile()
  {
    if (result_.valid() && !isLeftToCaller())
      result_.wait();
  }

  /** \brief Is there a result that nobody has asked for? */
  bool
  valid () const
  {
    return result_.valid();
  }
  /** \brief Will the caller do it itself when it asks for the result? */
  bool
  isLeftToCaller () const
  {
    return result_.wait_for (std::chrono::seconds (0)) == std::future_status::deferred;
  }
  /** \brief Waits for it; once. Throws what was thrown. */
  T
  get ()
  {
    return result_.get();
  }

private:
  std::future<T> result_;
};

/** \brief Has a helper of the calling thread's team call f while the caller goes on;
 * where the caller may not have one, or gets none, it calls f itself when it asks for
 * the result. Exceptions of f come with the result. \param threads that the caller may
 * use, itself included */
template <typename F>
auto
meanwhile (int threads, F f) -> Meanwhile<decltype (f())>
{
  using Result = decltype (f());
  if (threads > 1 && !ThreadTeam::busyHere()) {
    const auto task = std::make_shared<std::packaged_task<Result()>> (f);
    if (ThreadTeam::ofThisThread().doAside ([task] { (*task)(); }))
      return Meanwhile<Result> (task->get_future());
  }
  return Meanwhile<Result> (std::async (std::launch::deferred, std::move (f)));
}

} // namespace pcl_msf
