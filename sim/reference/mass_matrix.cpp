#include "sim/reference/mass_matrix.h"

namespace fascia::reference {

using Eigen::Index;
using Eigen::VectorXd;

MassMatrix::MassMatrix(const Model& model) {
  const MovingMasses masses = moving_masses(model);
  const auto count = static_cast<Index>(masses.own.size());
  own_.resize(3 * count);
  for (Index v = 0; v < count; ++v) own_.segment<3>(3 * v).setConstant(masses.own[static_cast<std::size_t>(v)]);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < masses.centroid.size(); ++t) {
    if (masses.centroid[t] == 0) continue;
    for (const std::uint32_t row : model.mid_edges[t])
      for (const std::uint32_t column : model.mid_edges[t])
        entries.emplace_back(static_cast<int>(row), static_cast<int>(column), masses.centroid[t] / 36);
  }
  coupled_.resize(count, count);
  coupled_.setFromTriplets(entries.begin(), entries.end());
}

VectorXd MassMatrix::coupled_times(const VectorXd& all) const {
  if (is_diagonal()) return VectorXd::Zero(all.size());
  using Components = Eigen::Matrix<double, 3, Eigen::Dynamic>;
  const Components product = Eigen::Map<const Components>(all.data(), 3, all.size() / 3) * coupled_;
  return Eigen::Map<const VectorXd>(product.data(), all.size());
}

void MassMatrix::add_coupled(double factor, const ElasticSystem& system, SparseMatrix& hessian) const {
  for (Index column = 0; column < coupled_.outerSize(); ++column)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(coupled_, column); entry; ++entry)
      system.add_block(static_cast<std::uint32_t>(entry.row()), static_cast<std::uint32_t>(column),
                       factor * entry.value() * Eigen::Matrix3d::Identity(), hessian);
}

}  // namespace fascia::reference
