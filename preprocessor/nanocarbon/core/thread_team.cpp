// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/thread_team.h"

namespace nanocarbon {

ThreadTeam::ThreadTeam(unsigned threads) {
  for (unsigned t = 1; t < threads; ++t) workers_.emplace_back([this, t] { work(t); });
}

ThreadTeam::~ThreadTeam() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  begin_.notify_all();
  for (std::thread& worker : workers_) worker.join();
}

void ThreadTeam::take_tasks(unsigned thread) {
  for (std::size_t index = next_++; index < count_; index = next_++) (*task_)(index, thread);
}

void ThreadTeam::work(unsigned thread) {
  std::size_t seen = 0;
  std::unique_lock lock(mutex_);
  for (;;) {
    begin_.wait(lock, [&] { return stop_ || round_ != seen; });
    if (stop_) return;
    seen = round_;
    lock.unlock();
    take_tasks(thread);
    lock.lock();
    if (--busy_ == 0) end_.notify_one();
  }
}

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t, unsigned)>& task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = &task;
    count_ = count;
    next_ = 0;
    busy_ = static_cast<unsigned>(workers_.size());
    ++round_;
  }
  begin_.notify_all();
  take_tasks(0);
  std::unique_lock lock(mutex_);
  end_.wait(lock, [&] { return busy_ == 0; });
}

}  // namespace nanocarbon
