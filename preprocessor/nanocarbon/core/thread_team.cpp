// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/thread_team.h"

namespace nanocarbon {

namespace {

// How often a thread looks for what it waits for before it goes to sleep: about as long as waking up takes.
constexpr int looks = 4000;

template <typename Ready>
bool look_for(const Ready& ready) {
  for (int look = 0; look < looks; ++look) {
    if (ready()) return true;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  return ready();
}

}  // namespace

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
  for (;;) {
    if (!look_for([&] { return stop_ || round_ != seen; })) {
      std::unique_lock lock(mutex_);
      begin_.wait(lock, [&] { return stop_ || round_ != seen; });
    }
    if (stop_) return;
    seen = round_;
    take_tasks(thread);
    if (--busy_ == 0) {
      const std::lock_guard lock(mutex_);
      end_.notify_one();
    }
  }
}

void ThreadTeam::run(std::size_t count, const std::function<void(std::size_t, unsigned)>& task) {
  if (workers_.empty()) {
    for (std::size_t index = 0; index < count; ++index) task(index, 0);
    return;
  }
  task_ = &task;
  count_ = count;
  next_ = 0;
  busy_ = static_cast<unsigned>(workers_.size());
  {
    const std::lock_guard lock(mutex_);
    ++round_;
  }
  begin_.notify_all();
  take_tasks(0);
  if (look_for([&] { return busy_ == 0; })) return;
  std::unique_lock lock(mutex_);
  end_.wait(lock, [&] { return busy_ == 0; });
}

}  // namespace nanocarbon
