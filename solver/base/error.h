// The two ways in which a run fails, each with one line for the user; and how a long computation is stopped.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

namespace ease {

/// What the user gave cannot be used; names the file, the key or index, the value found and what was expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The computation could not go on (not positive definite, NaN, disk full); says where.
struct ComputationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user does not want to wait any longer.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Called between the parts of a long computation, which stops where it throws; may be empty.
using Pause = std::function<void()>;

inline void pauseIn(const Pause& pause) {
  if (pause) pause();
}

}  // namespace ease
