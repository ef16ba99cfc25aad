#include "sim/reference/factor/cholesky.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace fascia::reference {

using Eigen::MatrixXd;
using Eigen::VectorXd;

Cholesky::Cholesky(const SparseMatrix& pattern, const EliminationTree& tree) {
  const int vertex_count = static_cast<int>(tree.place.size());
  std::vector<std::vector<int>> later(vertex_count);  // neighbors
  for (int j = 0; j < vertex_count; ++j)
    for (SparseMatrix::InnerIterator entry(pattern, 3 * j); entry; ++entry)
      if (const int i = static_cast<int>(entry.row()) / 3; i < j && entry.row() % 3 == 0) later[i].push_back(j);

  fronts_.resize(tree.nodes.size());
  std::vector<int> seen(vertex_count, -1), local(vertex_count);
  for (std::size_t n = 0; n < fronts_.size(); ++n) {
    const EliminationTree::Node& node = tree.nodes[n];
    Front& front = fronts_[n];
    front.begin = 3 * node.begin;
    front.pivots = 3 * (node.end - node.begin);
    const auto pass_on = [&](int v) {
      if (v < node.end || seen[v] == static_cast<int>(n)) return;
      seen[v] = static_cast<int>(n);
      front.boundary.push_back(v);
    };
    for (int v = node.begin; v < node.end; ++v) std::for_each(later[v].begin(), later[v].end(), pass_on);
    for (const int child : front.children)
      std::for_each(fronts_[child].boundary.begin(), fronts_[child].boundary.end(), pass_on);
    std::sort(front.boundary.begin(), front.boundary.end());
    if (node.parent >= 0) fronts_[node.parent].children.push_back(static_cast<int>(n));
  }

  // Entries of the lower triangle, by the vertex whose front eliminates them, at first in the matrix's numbering.
  std::vector<std::vector<Entry>> entries(vertex_count);
  for (int j = 0; j < pattern.cols(); ++j)
    for (int value = pattern.outerIndexPtr()[j]; value < pattern.outerIndexPtr()[j + 1]; ++value) {
      const int i = pattern.innerIndexPtr()[value];
      entries[i / 3].push_back({value, j, i});
    }
  for (std::size_t n = 0; n < fronts_.size(); ++n) {
    Front& front = fronts_[n];
    const int own = front.pivots / 3, first = front.begin / 3;
    for (int v = 0; v < own; ++v) local[first + v] = v;
    for (std::size_t b = 0; b < front.boundary.size(); ++b) local[front.boundary[b]] = own + static_cast<int>(b);
    for (int v = first; v < first + own; ++v)
      for (const Entry& e : entries[v])
        front.entries.push_back({e.value, 3 * local[e.row / 3] + e.row % 3, e.column - front.begin});
    for (const int child : front.children)
      for (const int v : fronts_[child].boundary) fronts_[child].into_parent.push_back(local[v]);
  }
}

MatrixXd Cholesky::assemble(const Front& front, const SparseMatrix& matrix, double shift,
                            std::vector<MatrixXd>& updates) const {
  const auto size = front.pivots + 3 * static_cast<Eigen::Index>(front.boundary.size());
  MatrixXd sum = MatrixXd::Zero(size, size);
  for (const Entry& e : front.entries) sum(e.row, e.column) += matrix.valuePtr()[e.value];
  sum.diagonal().head(front.pivots).array() += shift;
  for (const int child : front.children) {
    const std::vector<int>& to = fronts_[child].into_parent;
    const MatrixXd update = std::move(updates[child]);
    for (std::size_t j = 0; j < to.size(); ++j)
      for (std::size_t i = j; i < to.size(); ++i)
        sum.block<3, 3>(3 * to[i], 3 * to[j]) +=
            update.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j));
  }
  return sum;
}

bool Cholesky::factorize(const SparseMatrix& matrix, double shift) {
  std::vector<MatrixXd> updates(fronts_.size());  // what each front passes to its parent
  for (std::size_t n = 0; n < fronts_.size(); ++n) {
    Front& front = fronts_[n];
    MatrixXd sum = assemble(front, matrix, shift, updates);
    const Eigen::Index pivots = front.pivots, rest = sum.rows() - pivots;
    Eigen::Ref<MatrixXd> eliminated = sum.topLeftCorner(pivots, pivots);
    const Eigen::LLT<Eigen::Ref<MatrixXd>> dense(eliminated);
    if (dense.info() != Eigen::Success) return false;
    if (rest > 0) {
      auto below = sum.bottomLeftCorner(rest, pivots);
      eliminated.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(below);
      updates[n] = sum.bottomRightCorner(rest, rest);
      updates[n].selfadjointView<Eigen::Lower>().rankUpdate(below, -1);
    }
    front.factor = sum.leftCols(pivots);
  }
  return true;
}

VectorXd Cholesky::solve(const VectorXd& right) const {
  VectorXd x = right;
  for (const Front& front : fronts_) {
    auto own = x.segment(front.begin, front.pivots);
    front.factor.topRows(front.pivots).triangularView<Eigen::Lower>().solveInPlace(own);
    const VectorXd passed_on = front.factor.bottomRows(3 * front.boundary.size()) * own;
    for (std::size_t b = 0; b < front.boundary.size(); ++b)
      x.segment<3>(3 * front.boundary[b]) -= passed_on.segment<3>(3 * static_cast<Eigen::Index>(b));
  }
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    VectorXd above(3 * front->boundary.size());
    for (std::size_t b = 0; b < front->boundary.size(); ++b)
      above.segment<3>(3 * static_cast<Eigen::Index>(b)) = x.segment<3>(3 * front->boundary[b]);
    auto own = x.segment(front->begin, front->pivots);
    own -= front->factor.bottomRows(above.size()).transpose() * above;
    front->factor.topRows(front->pivots).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }
  return x;
}

}  // namespace fascia::reference
