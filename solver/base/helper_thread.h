// A thread that waits for tasks of the thread that owns it; for builds under ThreadSanitizer (parallel.h), where a
// thread made anew for every loop takes most of the time.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace ease {

class HelperThread {
 public:
  HelperThread() : thread_([this] { serve(); }) {}
  ~HelperThread() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  HelperThread(const HelperThread&) = delete;
  HelperThread& operator=(const HelperThread&) = delete;

  // Only the owner calls these three.
  /// Whether it works on a task that was not waited for.
  bool isBusy() const { return is_busy_; }
  /// Begins a task, which must live until wait() has returned.
  void start(const std::function<void()>& task) {
    is_busy_ = true;
    {
      const std::lock_guard lock(mutex_);
      task_ = &task;
    }
    changed_.notify_all();
  }
  /// Waits for the end of the task and rethrows its exception.
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !task_; });
    is_busy_ = false;
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }

 private:
  void serve() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return task_ || ends_; });
      if (!task_) return;
      lock.unlock();
      std::exception_ptr error;
      try {
        (*task_)();
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      error_ = error;
      task_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* task_ = nullptr;
  std::exception_ptr error_;
  bool ends_ = false;
  bool is_busy_ = false;
  std::thread thread_;  // last: it uses the others
};

/// The helper of the thread that asks.
inline HelperThread& helperThread() {
  thread_local HelperThread helper;
  return helper;
}

}  // namespace ease
