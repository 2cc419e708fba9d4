#include "points/laplacian.h"

#include <cmath>
#include <utility>

namespace capcon {

namespace {

constexpr std::size_t kCoarsest = 24;    // nodes that are solved for directly
constexpr double kOvercorrection = 1.8;  // of coarse corrections: piecewise constant ones are twice too stiff
constexpr std::uint32_t kNone = ~0u;

/// Each node's coarse node: pairs along the heaviest edge to a node still free.
std::vector<std::uint32_t> paired(const Laplacian& matrix, std::uint32_t& count) {
  std::vector<std::uint32_t> parent(matrix.size(), kNone);
  count = 0;
  for (std::uint32_t i = 0; i < matrix.size(); ++i) {
    if (parent[i] != kNone) continue;
    std::uint32_t best = kNone;
    double heaviest = 0;
    for (std::uint32_t e = matrix.start[i]; e < matrix.start[i + 1]; ++e) {
      if (parent[matrix.column[e]] == kNone && matrix.weight[e] > heaviest) {
        heaviest = matrix.weight[e];
        best = matrix.column[e];
      }
    }
    parent[i] = count;
    if (best != kNone) parent[best] = count;
    ++count;
  }
  return parent;
}

/// Sums the weights between coarse nodes.
Laplacian merged(const Laplacian& fine, const std::vector<std::uint32_t>& parent, std::uint32_t count) {
  std::vector<std::uint32_t> member(fine.size()), begin(count + 1, 0), place(count, kNone);
  for (const std::uint32_t p : parent) ++begin[p + 1];
  for (std::uint32_t c = 0; c < count; ++c) begin[c + 1] += begin[c];
  {
    std::vector<std::uint32_t> at(begin.begin(), begin.end() - 1);
    for (std::uint32_t i = 0; i < fine.size(); ++i) member[at[parent[i]]++] = i;
  }
  Laplacian coarse;
  for (std::uint32_t c = 0; c < count; ++c) {
    const auto row = static_cast<std::uint32_t>(coarse.column.size());
    for (std::uint32_t m = begin[c]; m < begin[c + 1]; ++m) {
      for (std::uint32_t e = fine.start[member[m]]; e < fine.start[member[m] + 1]; ++e) {
        const std::uint32_t to = parent[fine.column[e]];
        if (to == c) continue;
        if (place[to] == kNone || place[to] < row || coarse.column[place[to]] != to) {
          place[to] = static_cast<std::uint32_t>(coarse.column.size());
          coarse.add(to, 0);
        }
        coarse.weight[place[to]] += fine.weight[e];
      }
    }
    for (std::uint32_t e = row; e < coarse.column.size(); ++e) place[coarse.column[e]] = kNone;
    coarse.end_row();
  }
  return coarse;
}

/// One Gauss-Seidel step at node i.
void relax(const Laplacian& matrix, const std::vector<double>& right, std::vector<double>& v,
           std::uint32_t i) {
  double sum = right[i];
  for (std::uint32_t e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
    sum += matrix.weight[e] * v[matrix.column[e]];
  if (matrix.diagonal[i] > 0) v[i] = sum / matrix.diagonal[i];
}

void remove_mean(std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  for (double& x : v) x -= sum / static_cast<double>(v.size());
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void Laplacian::end_row() {
  double sum = 0;
  for (std::size_t e = start.back(); e < weight.size(); ++e) sum += weight[e];
  diagonal.push_back(sum);
  start.push_back(static_cast<std::uint32_t>(column.size()));
}

void Laplacian::clear() {
  start.assign(1, 0);
  column.clear();
  weight.clear();
  diagonal.clear();
}

void LaplacianSolver::set(Laplacian matrix) {
  levels_.clear();
  levels_.push_back({std::move(matrix), {}, {}, {}});
  while (levels_.back().matrix.size() > kCoarsest) {
    const Laplacian& fine = levels_.back().matrix;
    std::uint32_t pairs = 0, quads = 0;
    std::vector<std::uint32_t> parent = paired(fine, pairs);
    const Laplacian half = merged(fine, parent, pairs);
    const std::vector<std::uint32_t> second = paired(half, quads);
    if (2 * quads > fine.size()) break;  // hardly any edges left
    for (std::uint32_t& p : parent) p = second[p];
    Laplacian coarse = merged(half, second, quads);
    levels_.back().parent = std::move(parent);
    levels_.push_back({std::move(coarse), {}, {}, {}});
  }
  for (Level& level : levels_) {
    level.right.assign(level.matrix.size(), 0);
    level.solution.assign(level.matrix.size(), 0);
  }
  factorise();
}

void LaplacianSolver::factorise() {
  const Laplacian& matrix = levels_.back().matrix;
  const std::size_t n = matrix.size();
  factor_.clear();
  if (n > 4 * kCoarsest) return;
  double mean = 0;
  for (const double d : matrix.diagonal) mean += d / static_cast<double>(n);
  // A multiple of the all-ones matrix makes it regular and leaves solutions of sum 0 as they are.
  factor_.assign(n * n, mean > 0 ? mean / static_cast<double>(n) : 1);
  for (std::size_t i = 0; i < n; ++i) {
    factor_[i * n + i] += matrix.diagonal[i];
    for (std::uint32_t e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
      factor_[i * n + matrix.column[e]] -= matrix.weight[e];
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = factor_[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= factor_[i * n + k] * factor_[j * n + k];
      factor_[i * n + j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / factor_[j * n + j];
    }
  }
}

void LaplacianSolver::solve_coarsest() {
  Level& level = levels_.back();
  const std::size_t n = level.matrix.size();
  std::vector<double>& v = level.solution;
  if (factor_.empty()) {
    for (std::size_t i = 0; i < n; ++i)
      v[i] = level.matrix.diagonal[i] > 0 ? level.right[i] / level.matrix.diagonal[i] : 0;
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = level.right[i];
    for (std::size_t k = 0; k < i; ++k) sum -= factor_[i * n + k] * v[k];
    v[i] = sum / factor_[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    double sum = v[i];
    for (std::size_t k = i + 1; k < n; ++k) sum -= factor_[k * n + i] * v[k];
    v[i] = sum / factor_[i * n + i];
  }
}

void LaplacianSolver::cycle(std::size_t at, bool from_zero) {
  Level& level = levels_[at];
  if (level.parent.empty()) return solve_coarsest();
  const Laplacian& matrix = level.matrix;
  const auto n = static_cast<std::uint32_t>(matrix.size());
  Level& coarse = levels_[at + 1];
  std::vector<double>& v = level.solution;
  if (from_zero) std::fill(v.begin(), v.end(), 0.0);
  for (std::uint32_t i = 0; i < n; ++i) relax(matrix, level.right, v, i);
  std::fill(coarse.right.begin(), coarse.right.end(), 0.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    double sum = level.right[i] - matrix.diagonal[i] * v[i];
    for (std::uint32_t e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
      sum += matrix.weight[e] * v[matrix.column[e]];
    coarse.right[level.parent[i]] += sum;
  }
  cycle(at + 1, true);
  // Twice: what one cycle over coarser graphs leaves grows with their number. A level has a quarter of the
  // nodes, so this costs at most a half more in all.
  if (!coarse.parent.empty()) cycle(at + 1, false);
  for (std::uint32_t i = 0; i < n; ++i) v[i] += kOvercorrection * coarse.solution[level.parent[i]];
  for (std::uint32_t i = n; i-- > 0;) relax(matrix, level.right, v, i);
}

int LaplacianSolver::solve(std::span<const double> b, double tolerance, int most, std::vector<double>& v) {
  const Laplacian& matrix = levels_.front().matrix;
  const auto n = static_cast<std::uint32_t>(matrix.size());
  v.assign(n, 0);
  residual_.assign(b.begin(), b.end());
  remove_mean(residual_);
  direction_.assign(n, 0);
  image_.assign(n, 0);
  const double goal2 = tolerance * tolerance * dot(residual_, residual_);
  double rho = 0;
  int step = 0;
  for (; step < most; ++step) {
    if (dot(residual_, residual_) <= goal2) break;
    levels_.front().right = residual_;
    cycle(0, true);
    const std::vector<double>& z = levels_.front().solution;
    const double next = dot(residual_, z);
    const double beta = step > 0 ? next / rho : 0;
    rho = next;
    double curvature = 0;
    for (std::uint32_t i = 0; i < n; ++i) direction_[i] = z[i] + beta * direction_[i];
    for (std::uint32_t i = 0; i < n; ++i) {
      double sum = matrix.diagonal[i] * direction_[i];
      for (std::uint32_t e = matrix.start[i]; e < matrix.start[i + 1]; ++e)
        sum -= matrix.weight[e] * direction_[matrix.column[e]];
      image_[i] = sum;
      curvature += sum * direction_[i];
    }
    if (!(curvature > 0) || !(rho > 0)) break;
    const double alpha = rho / curvature;
    for (std::uint32_t i = 0; i < n; ++i) {
      v[i] += alpha * direction_[i];
      residual_[i] -= alpha * image_[i];
    }
  }
  remove_mean(v);  // the cycles add constants, which the matrix does not see
  return step;
}

}  // namespace capcon
