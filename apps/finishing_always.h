// Work that leaves complete files behind, also where a computation fails.
#pragma once

#include "solver/base/error.h"

namespace ease {

/// Does the work, and then finishes, even if the work throws ComputationError, which goes on then.
template <class Work, class Finish>
void finishingAlways(const Work& work, const Finish& finish) {
  try {
    work();
  } catch (const ComputationError&) {
    finish();
    throw;
  }
  finish();
}

}  // namespace ease
