#include "sim/accuracy/frequencies.h"

#include <numbers>
#include <random>

#include "sim/material/symmetric_eigen.h"
#include "sim/reference/elastic_system.h"

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
  VectorXd scale, mass(rest.size());
  system.assemble(rest, {}, false, stiffness, scale);
  reference::Cholesky cholesky(stiffness, system.elimination_tree());
  if (!cholesky.factorize(stiffness)) return {};
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v)
    mass.segment<3>(3 * static_cast<Eigen::Index>(v)).setConstant(masses[v]);
  const VectorXd m = system.free_part(mass);
  const Eigen::Index columns = std::min<Eigen::Index>(count + kGuards, m.size());
  std::mt19937 random(33);
  std::uniform_real_distribution<double> uniform(-1, 1);
  MatrixXd basis = MatrixXd::NullaryExpr(m.size(), columns, [&] { return uniform(random); });
  VectorXd values;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    MatrixXd next(m.size(), columns);
    for (Eigen::Index c = 0; c < columns; ++c) next.col(c) = cholesky.solve(m.cwiseProduct(basis.col(c)));
    const MatrixXd k = next.transpose() * m.asDiagonal() * basis, n = next.transpose() * m.asDiagonal() * next;
    const SymmetricEigen eigen = symmetric_eigen(0.5 * (k + k.transpose()), n);
    values = eigen.values;
    basis = next * eigen.vectors;
  }
  return values.head(std::min<Eigen::Index>(count, columns)).cwiseSqrt() / (2 * std::numbers::pi);
}

}  // namespace fascia
