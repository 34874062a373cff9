// The two ways in which a run fails, each with one line for the user.
#pragma once

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

}  // namespace ease
