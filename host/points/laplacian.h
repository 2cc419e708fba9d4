#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace capcon {

/// A graph with positive weights on its edges, as the matrix L of (L v)_i = sum_j c_ij (v_i - v_j): each edge
/// twice, row by row. Edges of a node with itself do not matter and are left out.
struct Laplacian {
  std::vector<std::uint32_t> start{0};
  std::vector<std::uint32_t> column;
  std::vector<double> weight;
  std::vector<double> diagonal;

  std::size_t size() const { return diagonal.size(); }
  void add(std::uint32_t to, double w) {
    column.push_back(to);
    weight.push_back(w);
  }
  /// Ends the row that `add` filled.
  void end_row();
  void clear();
};

/// Solves L v = b by conjugate gradients, preconditioned by one W-cycle over ever coarser graphs: nodes are
/// paired along their heaviest edges, twice a level (aggregation multigrid after Vanek; Notay 2010), with
/// Gauss-Seidel steps.
class LaplacianSolver {
 public:
  /// Takes the matrix; call again when it has changed.
  void set(Laplacian matrix);

  /// v with sum 0 and |L v - b| <= tolerance |b|, for a connected graph; the mean of b is taken off first.
  /// Starts from zero. Returns the number of steps, at most `most`.
  int solve(std::span<const double> b, double tolerance, int most, std::vector<double>& v);

 private:
  struct Level {
    Laplacian matrix;
    std::vector<std::uint32_t> parent;  ///< the coarse node of each node; empty at the coarsest level
    std::vector<double> right, solution;
  };
  void cycle(std::size_t level, bool from_zero);
  void factorise();
  void solve_coarsest();

  std::vector<Level> levels_;
  std::size_t used_ = 0;
  std::vector<double> factor_;  ///< Cholesky factor of the coarsest matrix plus a constant
  std::vector<double> residual_, direction_, image_;
};

}  // namespace capcon
