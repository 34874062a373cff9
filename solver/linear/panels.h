// Triangular solves with a Cholesky factor kept as dense panels in single precision, in parallel.
//
//   panel    adjacent columns of L with the same rows below them (a supernode), stored densely
//
// A solve reads the factor twice and does little else: it is bound by memory.  Panels need no index for each entry and
// single precision halves what is left, so that an entry takes 4 bytes instead of 12.  That precision is enough for a
// preconditioner, the only use of panels: the next iteration corrects the error of a solve.
//
// Nested dissection makes the elimination tree wide.  Its subtrees are solved side by side; what each does to the rows
// of its ancestors waits in a buffer of its own, and the buffers are added in a fixed order, so that the result is the
// same for any number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ease {

/// Positions of a supernodal factor's entries.
struct PanelShape {
  std::vector<int> first_column;    // of panel s; the last entry is the number of columns
  std::vector<int> row_start;       // panel s has rows[row_start[s]] to rows[row_start[s + 1] - 1], diagonal first
  std::vector<int> rows;            // ascending within a panel
  std::vector<size_t> value_start;  // a panel's values lie column by column
  std::vector<int> ordering;        // its k-th entry is the row of A that comes k-th
  friend bool operator==(const PanelShape&, const PanelShape&) = default;

  int panelCount() const { return static_cast<int>(first_column.size()) - 1; }
  int columnCount(int s) const { return first_column[s + 1] - first_column[s]; }
  int rowCount(int s) const { return row_start[s + 1] - row_start[s]; }
};

class Panels {
 public:
  /// Takes the values of a factor of this shape, rounded.  Panels must be in postorder.
  void set(const PanelShape& shape, std::span<const double> values);

  /// Solves A x = b for `columns` right-hand sides, 1 or 3, given row by row: b[row * columns + column].  b and x may
  /// be the same.  Single precision.
  void solve(const double* b, double* x, int columns);

  size_t memoryBytes() const { return values_.size() * sizeof(float); }

 private:
  struct Subtree {
    int begin, end;              // panels
    std::span<const int> above;  // rows of ancestors that the subtree updates
    std::vector<float> updates;  // for the rows `above`
    std::vector<float> work;
  };
  void findSubtrees();
  template <int Columns>
  void solveColumns(const double* b, double* x);
  template <int Columns>
  void forward(int panel, int last_column, float* updates, float* work);
  template <int Columns>
  void backward(int panel, float* work);

  PanelShape shape_;
  std::vector<float> values_;
  std::vector<Subtree> subtrees_;
  std::vector<int> top_;  // panels in no subtree, ascending
  std::vector<float> x_, work_;
};

}  // namespace ease
