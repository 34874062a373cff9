// What this machine can do at best: the bounds that the phases of a step are held against.
#pragma once

#include <cstddef>
#include <span>

#include "solver/linear/cholesky.h"

namespace ease {

/// Bytes per second at which all threads together read `bytes` over and over; within a cache where they fit.  Each
/// thread reads from one place or from four at once, whichever is faster: one place alone does not saturate the memory
/// bus.
double readBandwidth(size_t bytes);

/// Floating-point operations per second of one thread, multiplying dense matrices.
double peakFlops();

/// Floating-point operations of a Cholesky factorisation of a symmetric pattern, each of whose rows stands for
/// `block` x `block` scalar ones: the sum over columns of the squares of their entries in L.
double factorFlops(const SparseMatrix& lower, std::span<const int> ordering, int block);

}  // namespace ease
