// Data-parallel loops whose results do not depend on the number of threads.
//
// Elements are independent in parallelFor; parallelSum adds partial sums of 64 fixed blocks in a fixed order.
//
// ThreadSanitizer cannot see the synchronisation inside a libtbb built without it and would report every loop; in
// builds with it, loops therefore run on two threads and tasks on std::async.
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>
#include <array>
#include <future>
#ifdef __SANITIZE_THREAD__
#include "solver/base/helper_thread.h"
#endif

namespace ease {

#ifdef __SANITIZE_THREAD__

/// Calls range(begin, end) for blocks of [0, count) in parallel.
template <class Range>
void parallelBlocks(int count, int grain, const Range& range) {
  HelperThread& helper = helperThread();
  if (helper.isBusy()) {  // a loop within the owner's half of another
    range(0, count);
    return;
  }
  const auto every_second = [&](int first) {
    for (int b = first * grain; b < count; b += 2 * grain) range(b, std::min(count, b + grain));
  };
  const std::function<void()> others = [&] { every_second(1); };
  helper.start(others);
  try {
    every_second(0);
  } catch (...) {
    helper.wait();
    throw;
  }
  helper.wait();
}

/// A task that runs beside the code that follows.
class TaskBeside {
 public:
  template <class Task>
  void run(const Task& task) {
    done_ = std::async(std::launch::async, task);
  }
  void wait() {
    if (done_.valid()) done_.get();
  }

 private:
  std::future<void> done_;
};

#else

/// Calls range(begin, end) for blocks of [0, count) in parallel.
template <class Range>
void parallelBlocks(int count, int grain, const Range& range) {
  tbb::parallel_for(tbb::blocked_range<int>(0, count, grain),
                    [&](const tbb::blocked_range<int>& r) { range(r.begin(), r.end()); });
}

/// A task that runs beside the code that follows.  wait() rethrows its exception; the destructor only waits.
class TaskBeside {
 public:
  TaskBeside() = default;
  TaskBeside(const TaskBeside&) = delete;
  TaskBeside& operator=(const TaskBeside&) = delete;
  ~TaskBeside() {
    try {
      group_.wait();
    } catch (...) {  // another exception is already being reported
    }
  }
  template <class Task>
  void run(const Task& task) {
    group_.run(task);
  }
  void wait() { group_.wait(); }

 private:
  tbb::task_group group_;
};

#endif

/// Calls body(i) for i in [0, count), in parallel over blocks of `grain`; serial below one block.
template <class Body>
void parallelFor(int count, int grain, const Body& body) {
  if (count <= grain) {
    for (int i = 0; i < count; ++i) body(i);
    return;
  }
  parallelBlocks(count, grain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) body(i);
  });
}

/// Sums term(i) over [0, count); the result is the same to the last bit for any number of threads.
template <class Term>
double parallelSum(int count, const Term& term) {
  constexpr int kBlocks = 64;
  const int block = (count + kBlocks - 1) / kBlocks;
  std::array<double, kBlocks> partial;
  const auto sumBlock = [&](int b) {
    double sum = 0.0;
    for (int i = b * block; i < std::min(count, (b + 1) * block); ++i) sum += term(i);
    partial[b] = sum;
  };
  parallelFor(kBlocks, count < 4096 ? kBlocks : 4, sumBlock);
  double sum = 0.0;
  for (double p : partial) sum += p;
  return sum;
}

}  // namespace ease
