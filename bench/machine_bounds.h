// The best performance of this machine, with which the phases of a step are compared.
#pragma once

#include <cstddef>
#include <span>

#include "solver/linear/cholesky.h"

namespace ease {

/// Measures the bandwidth, bytes per second, at which all threads together read the same `bytes` repeatedly; this is
/// the bandwidth of a cache if they fit into one.  Each thread reads one stream or four streams at once, whichever is
/// faster, because one stream does not saturate the memory bus.
double readBandwidth(size_t bytes);

/// Measures the floating-point operations per second of one thread that multiplies dense matrices.
double peakFlops();

/// Counts the floating-point operations of a sparse Cholesky factorisation: the sum over the columns of L of the
/// squared number of their entries.  Each entry of the symmetric pattern `lower` stands for a block of `block` x
/// `block` numbers.
double factorFlops(const SparseMatrix& lower, std::span<const int> ordering, int block);

}  // namespace ease
