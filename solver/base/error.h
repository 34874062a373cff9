// The two kinds of failure of a run, each with a one-line message, and the interruption of a long computation.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

namespace ease {

/// The user's input cannot be used; the message names the file, the key or index, the value found and the expected one.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation could not continue (not positive definite, NaN, disk full); the message says where.
struct ComputationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user stopped the run.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Called between the parts of a long computation, which it stops by throwing; may be empty.
using Pause = std::function<void()>;

inline void pauseIn(const Pause& pause) {
  if (pause) pause();
}

}  // namespace ease
