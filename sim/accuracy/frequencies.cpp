#include "sim/accuracy/frequencies.h"

#include <numbers>
#include <random>

#include "sim/material/symmetric_eigen.h"
#include "sim/reference/mass_matrix.h"

namespace fascia {
namespace {

constexpr int kGuards = 6;       // vectors beyond those that are asked for: they converge last
constexpr int kIterations = 40;  // each shrinks the error by the square of a ratio of frequencies

}  // namespace

Eigen::VectorXd natural_frequencies(const Model& model, int count) {
  using Eigen::MatrixXd, Eigen::VectorXd;
  const reference::ElasticSystem system(model);
  const VectorXd rest = VectorXd::Zero(3 * static_cast<Eigen::Index>(model.rest_positions.size()));
  reference::SparseMatrix stiffness = system.empty_hessian();
  VectorXd scale;
  system.assemble(rest, {}, false, stiffness, scale);
  reference::Cholesky cholesky(stiffness, system.elimination_tree());
  if (!cholesky.factorize(stiffness)) return {};
  const reference::MassMatrix masses(model);
  reference::SparseMatrix upper = system.empty_hessian();
  upper.diagonal() += system.free_part(masses.own());
  masses.add_coupled(1, system, upper);
  const auto mass = upper.selfadjointView<Eigen::Upper>();
  const Eigen::Index columns = std::min<Eigen::Index>(count + kGuards, upper.rows());
  std::mt19937 random(33);
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatrixXd basis = MatrixXd::NullaryExpr(upper.rows(), columns, [&] { return uniform(random); });
  VectorXd values;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    MatrixXd next(upper.rows(), columns);
    const MatrixXd moved = mass * basis;
    for (Eigen::Index c = 0; c < columns; ++c) next.col(c) = cholesky.solve(moved.col(c));
    const MatrixXd k = next.transpose() * moved, n = next.transpose() * (mass * next);
    const SymmetricEigen eigen = symmetric_eigen(0.5 * (k + k.transpose()), n);
    values = eigen.values;
    basis = next * eigen.vectors;
  }
  return values.head(std::min<Eigen::Index>(count, columns)).cwiseSqrt() / (2 * std::numbers::pi);
}

}  // namespace fascia
