#include "solver/linear/cholesky.h"

#include <cholmod.h>

#include <cassert>
#include <cstring>
#include <new>

extern "C" {
void openblas_set_num_threads(int threads);
void omp_set_max_active_levels(int levels);
}

namespace ease {

struct Cholesky::Data {
  cholmod_common common;
  cholmod_factor* factor = nullptr;
  bool factored = false;
  // Work arrays of cholmod_solve2, kept between solves.
  cholmod_dense* x = nullptr;
  cholmod_dense* y = nullptr;
  cholmod_dense* e = nullptr;

  explicit Data(Kind kind) {
    openblas_set_num_threads(1);  // a garment's supernodes are too small to gain from a second thread
    cholmod_start(&common);
    common.print = 0;
    common.supernodal = kind == Kind::kSupernodal ? CHOLMOD_SUPERNODAL : CHOLMOD_SIMPLICIAL;
    common.final_ll = 1;
    common.quick_return_if_not_posdef = 1;
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
  ~Data() {
    cholmod_free_factor(&factor, &common);
    cholmod_free_dense(&x, &common);
    cholmod_free_dense(&y, &common);
    cholmod_free_dense(&e, &common);
    cholmod_finish(&common);
  }
};

namespace {

/// CHOLMOD's description of the matrix, without a copy of its entries.
cholmod_sparse view(const SparseMatrix& lower) {
  assert(lower.isCompressed() && lower.rows() == lower.cols());
  cholmod_sparse a{};
  a.nrow = a.ncol = lower.cols();
  a.nzmax = lower.nonZeros();
  a.p = const_cast<int*>(lower.outerIndexPtr());
  a.i = const_cast<int*>(lower.innerIndexPtr());
  a.x = const_cast<double*>(lower.valuePtr());
  a.stype = -1;
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

}  // namespace

Cholesky::Cholesky(Kind kind) : data_(std::make_unique<Data>(kind)) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyse(const SparseMatrix& lower, std::span<const int> ordering) {
  cholmod_common& common = data_->common;
  cholmod_free_factor(&data_->factor, &common);
  data_->factored = false;
  common.nmethods = 1;
  common.method[0].ordering = ordering.empty() ? CHOLMOD_METIS : CHOLMOD_GIVEN;
  cholmod_sparse a = view(lower);
  int* given = ordering.empty() ? nullptr : const_cast<int*>(ordering.data());
  data_->factor = cholmod_analyze_p(&a, given, nullptr, 0, &common);
  if (!data_->factor) throw std::bad_alloc();
}

bool Cholesky::factor(const SparseMatrix& lower) {
  assert(data_->factor);
  // CHOLMOD starts four OpenMP threads per supernode and ignores its own setting for their number. These threads wait
  // actively and take time from the program's own threads.
  omp_set_max_active_levels(0);
  cholmod_sparse a = view(lower);
  cholmod_factorize(&a, data_->factor, &data_->common);
  if (data_->common.status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  data_->factored = data_->common.status == CHOLMOD_OK && data_->factor->minor == data_->factor->n;
  return data_->factored;
}

void Cholesky::solve(const double* b, double* x, int columns) const {
  assert(data_->factored);
  const size_t n = data_->factor->n;
  cholmod_dense right{};
  right.nrow = right.d = n;
  right.ncol = columns;
  right.nzmax = n * columns;
  right.x = const_cast<double*>(b);
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  const int ok = cholmod_solve2(CHOLMOD_A, data_->factor, &right, nullptr, &data_->x, nullptr, &data_->y, &data_->e,
                                &data_->common);
  if (!ok) throw std::bad_alloc();
  std::memcpy(x, data_->x->x, n * columns * sizeof(double));
}

void Cholesky::copyTo(Panels& panels) const {
  assert(data_->factored && data_->factor->is_super);
  const cholmod_factor& factor = *data_->factor;
  const auto copy = [](const void* from, size_t count) {
    const int* begin = static_cast<const int*>(from);
    return std::vector<int>(begin, begin + count);
  };
  PanelShape shape;
  shape.first_column = copy(factor.super, factor.nsuper + 1);
  shape.row_start = copy(factor.pi, factor.nsuper + 1);
  shape.rows = copy(factor.s, shape.row_start.back());
  const std::vector<int> value_start = copy(factor.px, factor.nsuper + 1);
  shape.value_start.assign(value_start.begin(), value_start.end());
  shape.ordering = ordering();
  panels.set(shape, {static_cast<const double*>(factor.x), shape.value_start.back()});
}

std::vector<int> Cholesky::ordering() const {
  assert(data_->factor);
  const int* permutation = static_cast<const int*>(data_->factor->Perm);
  return {permutation, permutation + data_->factor->n};
}

std::vector<int> liftOrdering(std::span<const int> ordering) {
  std::vector<int> lifted;
  lifted.reserve(3 * ordering.size());
  for (int vertex : ordering)
    for (int axis = 0; axis < 3; ++axis) lifted.push_back(3 * vertex + axis);
  return lifted;
}

}  // namespace ease
