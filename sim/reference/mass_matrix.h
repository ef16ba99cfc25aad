// The mass matrix M of the kinetic energy 1/2 v^T M v (MovingMasses in sim/model/model.h): diagonal, but for what moves
// at the centroids of quadratic tets. Vectors are [3 * vertex_count].
#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "sim/model/model.h"
#include "sim/reference/elastic_system.h"

namespace fascia::reference {

class MassMatrix {
 public:
  explicit MassMatrix(const Model& model);

  bool is_diagonal() const { return coupled_.nonZeros() == 0; }
  const Eigen::VectorXd& own() const { return own_; }  // the diagonal without what moves at centroids [kg]
  Eigen::VectorXd times(const Eigen::VectorXd& all) const { return own_.cwiseProduct(all) + coupled_times(all); }
  /// What moves at centroids: its part of the product with M.
  Eigen::VectorXd coupled_times(const Eigen::VectorXd& all) const;
  /// The same in a matrix over the unknowns of `system`, of which `hessian` has the upper triangle, multiplied by
  /// `factor`.
  void add_coupled(double factor, const ElasticSystem& system, SparseMatrix& hessian) const;

 private:
  Eigen::VectorXd own_;
  Eigen::SparseMatrix<double> coupled_;  // [vertex_count, vertex_count] [kg], of every component
};

}  // namespace fascia::reference
