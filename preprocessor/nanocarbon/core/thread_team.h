// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace nanocarbon {

//! A fixed number of threads that work through batches of tasks. The caller works too; idle threads look for
//! work for some microseconds before they sleep.
class ThreadTeam {
 public:
  //! \param threads including the caller's; at least 1
  explicit ThreadTeam(unsigned threads);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  unsigned size() const { return static_cast<unsigned>(workers_.size()) + 1; }

  //! Calls task(index, thread) for every index below count, each once, in any order; thread is below size().
  //! \pre task does not throw
  void run(std::size_t count, const std::function<void(std::size_t index, unsigned thread)>& task);

 private:
  void work(unsigned thread);
  void take_tasks(unsigned thread);

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable begin_, end_;
  const std::function<void(std::size_t, unsigned)>* task_ = nullptr;
  std::atomic<std::size_t> next_ = 0;
  std::size_t count_ = 0;
  std::atomic<std::size_t> round_ = 0;
  std::atomic<unsigned> busy_ = 0;
  std::atomic<bool> stop_ = false;
};

}  // namespace nanocarbon
