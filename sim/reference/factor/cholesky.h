// Cholesky factor of a mesh's Hessian, front by front (multifrontal: Duff, Reid 1983). All unknowns that are eliminated
// together form one dense matrix, so the work is dense products, which are several times as fast as single columns.
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "sim/reference/factor/nested_dissection.h"

namespace fascia::reference {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

class Cholesky {
 public:
  Cholesky() = default;
  /// `pattern`: upper triangle, three unknowns per vertex, in the order of the tree.
  Cholesky(const SparseMatrix& pattern, const EliminationTree& tree);

  /// Factorizes `matrix`, which has the entries of the pattern, plus `shift` times the identity. False if that is not
  /// positive definite; then there is no factor.
  bool factorize(const SparseMatrix& matrix, double shift = 0);
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Entry {
    int value, row, column;  // from the matrix's values to the front
  };
  struct Front {
    int begin = 0, pivots = 0;  // unknowns that it eliminates
    std::vector<int> boundary;  // vertices that it passes on to, ascending
    std::vector<int> children;
    std::vector<int> into_parent;  // [boundary] vertex of the parent's front
    std::vector<Entry> entries;
    Eigen::MatrixXd factor;  // [pivots + 3 * boundary] [pivots], lower triangle
  };
  Eigen::MatrixXd assemble(const Front& front, const SparseMatrix& matrix, double shift,
                           std::vector<Eigen::MatrixXd>& updates) const;

  std::vector<Front> fronts_;  // children before parents
};

}  // namespace fascia::reference
