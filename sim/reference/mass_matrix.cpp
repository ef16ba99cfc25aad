#include "sim/reference/mass_matrix.h"

#include "sim/elements/quadratic_tet.h"

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
    const ElementVertices element = model.element(t);
    for (std::size_t a = 0; a < element.size(); ++a)
      for (std::size_t b = 0; b < element.size(); ++b)
        entries.emplace_back(static_cast<int>(element[a]), static_cast<int>(element[b]),
                             masses.centroid[t] * QuadraticTet::at_centroid(a) * QuadraticTet::at_centroid(b));
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
