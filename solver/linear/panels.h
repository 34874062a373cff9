// Triangular solves with a Cholesky factor kept as dense panels in single precision, in parallel.
//
//   panel    adjacent columns of L with the same rows below them (a supernode), stored densely
//
// A solve reads the factor twice and computes little, so memory bandwidth limits it. Panels need no index per entry,
// and single precision halves the size of a value, so an entry takes 4 bytes instead of 12. Single precision is enough
// for a preconditioner, the only use of panels, because the next iteration corrects the error of a solve.
//
// Nested dissection makes the elimination tree wide, and its subtrees are solved in parallel. Each subtree writes its
// updates for the rows of its ancestors to a buffer of its own. The buffers are added in a fixed order, so that the
// result is equal for any number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ease {

/// Positions of a supernodal factor's entries.
struct PanelShape {
  std::vector<int> first_column;    // first column of each panel; one more entry holds the number of columns
  std::vector<int> row_start;       // panel s has rows[row_start[s]] to rows[row_start[s + 1] - 1], diagonal first
  std::vector<int> rows;            // ascending within a panel
  std::vector<size_t> value_start;  // index of each panel's first value; the values lie column by column
  std::vector<int> ordering;        // its k-th entry is the row of A that is eliminated k-th
  friend bool operator==(const PanelShape&, const PanelShape&) = default;

  int panelCount() const { return static_cast<int>(first_column.size()) - 1; }
  int columnCount(int s) const { return first_column[s + 1] - first_column[s]; }
  int rowCount(int s) const { return row_start[s + 1] - row_start[s]; }
};

class Panels {
 public:
  /// Copies the values of a factor of this shape, rounded to single precision. The panels must be in postorder.
  void set(const PanelShape& shape, std::span<const double> values);

  /// Solves A x = b in single precision for `columns` right-hand sides, 1 or 3, stored row by row:
  /// b[row * columns + column]. b and x may be the same array.
  void solve(const double* b, double* x, int columns);

  size_t memoryBytes() const { return values_.size() * sizeof(float); }

 private:
  /// A subtree of the elimination tree, and the buffers of its solve.
  struct Subtree {
    int begin, end;              // range of its panels, without `end`
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
  std::vector<int> top_;  // panels that are in no subtree, in ascending order
  std::vector<float> x_, work_;
};

}  // namespace ease
