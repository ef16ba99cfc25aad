#include "sim/coarse/coarse_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "sim/material/law.h"
#include "sim/material/symmetric_eigen.h"

namespace fascia {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

// (L L^T)^-1 = L^-T L^-1, by blocks of columns, skipping entries that are known to be zero: a third of the work of
// solving for the identity.
MatrixXd inverse_of(const MatrixXd& factor) {
  constexpr Eigen::Index kBlock = 64;
  const Eigen::Index n = factor.rows();
  MatrixXd lower = MatrixXd::Identity(n, n), inverse(n, n);
  for (Eigen::Index j = 0; j < n; j += kBlock) {
    const Eigen::Index width = std::min(kBlock, n - j), rest = n - j;
    auto columns = lower.block(j, j, rest, width);
    factor.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>().solveInPlace(columns);
  }
  for (Eigen::Index i = 0; i < n; i += kBlock) {
    const Eigen::Index width = std::min(kBlock, n - i), rest = n - i;
    inverse.block(i, 0, width, i + width).noalias() =
        lower.block(i, i, rest, width).transpose() * lower.block(i, 0, rest, i + width);
  }
  return inverse.selfadjointView<Eigen::Lower>();
}

// A run of consecutive tets with one material and the same coarse functions, such as those within a cell of the
// lattice. The stiffness between two functions with gradients p and q is lambda p q^T + mu (q p^T + p.q I) times the
// volume, linear in the sum of V p q^T over the tets, which is computed once.
class AlikeTets {
 public:
  bool takes(const std::vector<std::uint32_t>& nodes, const Material& material) const {
    return count_ > 0 && count_ < kMost && nodes == nodes_ && material == material_;
  }
  void begin(const std::vector<std::uint32_t>& nodes, const Material& material) {
    nodes_ = nodes;
    material_ = material;
    scaled_.resize(3 * static_cast<Eigen::Index>(nodes.size()), kMost);
    count_ = 0;
  }
  void add(const std::vector<Vector3d>& gradients, double volume) {
    for (std::size_t i = 0; i < gradients.size(); ++i)
      scaled_.block<3, 1>(3 * static_cast<Eigen::Index>(i), count_) = std::sqrt(volume) * gradients[i];
    ++count_;
  }
  /// Adds to the lower triangle of `a`.
  void add_stiffness(MatrixXd& a, double h) {
    if (count_ == 0) return;
    const double scale = h * h * (1 + material_.damping / h), mu = scale * material_.lame_mu(),
                 not_viscous = h * material_.damping * (material_.lame_lambda() - viscous_lambda(material_)),
                 lambda = scale * material_.lame_lambda() - not_viscous;
    sum_.noalias() = scaled_.leftCols(count_) * scaled_.leftCols(count_).transpose();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t j = 0; j < nodes_.size(); ++j) {
        if (nodes_[j] > nodes_[i]) continue;
        const auto pq = sum_.block<3, 3>(3 * static_cast<Eigen::Index>(i), 3 * static_cast<Eigen::Index>(j));
        auto block = a.block<3, 3>(3 * nodes_[i], 3 * nodes_[j]);
        block += lambda * pq + mu * pq.transpose();
        block.diagonal().array() += mu * pq.trace();
      }
  }

 private:
  static constexpr Eigen::Index kMost = 64;
  std::vector<std::uint32_t> nodes_;
  Material material_;
  Eigen::Index count_ = 0;
  MatrixXd scaled_, sum_;  // gradients times the root of the volume, [3 * nodes] rows, a column per tet
};

}  // namespace

MatrixXd coarse_matrix(const Model& model, const CoarseSpace& space, double h) {
  MatrixXd a = MatrixXd::Zero(3 * space.node_count, 3 * space.node_count);
  AlikeTets alike;
  std::vector<std::uint32_t> nodes;
  std::vector<Vector3d> gradients;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    const Tet& tet = model.tets[t];
    Matrix3d dm;
    for (int k = 0; k < 3; ++k) dm.col(k) = model.rest_positions[tet[k + 1]] - model.rest_positions[tet[0]];
    const Matrix3d inv_dm = dm.inverse();
    nodes.clear();
    gradients.clear();
    for (int corner = 0; corner < 4; ++corner) {
      const Vector3d b =
          corner == 0 ? Vector3d(-inv_dm.colwise().sum().transpose()) : Vector3d(inv_dm.row(corner - 1).transpose());
      const std::uint32_t v = tet[static_cast<std::size_t>(corner)];
      for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) {
        const auto place =
            static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), space.node[k]) - nodes.begin());
        if (place == nodes.size()) {
          nodes.push_back(space.node[k]);
          gradients.emplace_back(Vector3d::Zero());
        }
        gradients[place] += space.weight[k] * b;
      }
    }
    const Material& material = model.materials[model.tet_material[t]];
    if (!alike.takes(nodes, material)) {
      alike.add_stiffness(a, h);
      alike.begin(nodes, material);
    }
    alike.add(gradients, dm.determinant() / 6);
  }
  alike.add_stiffness(a, h);
  const std::vector<double> masses = lumped_masses(model);
  for (std::size_t v = 0; v < masses.size(); ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k)
      for (std::uint32_t l = space.begin[v]; l < space.begin[v + 1]; ++l)
        if (space.node[l] <= space.node[k])
          a.block<3, 3>(3 * space.node[k], 3 * space.node[l]).diagonal().array() +=
              masses[v] * space.weight[k] * space.weight[l];
  return a.selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXf coarse_inverse(MatrixXd matrix) {
  const Eigen::VectorXd diagonal = matrix.diagonal();
  Eigen::LLT<MatrixXd> factor;
  for (double raise = 1e-7; raise < 10; raise *= 100) {
    matrix.diagonal() = (1 + raise) * diagonal;
    factor.compute(matrix);
    if (factor.info() == Eigen::Success) return inverse_of(factor.matrixLLT()).cast<float>();
  }
  return Eigen::MatrixXf::Zero(matrix.rows(), matrix.cols());  // not finite: only the fine level corrects
}

Eigen::MatrixXf with_stiffness(const Eigen::MatrixXf& inverse, const CoarseSpace& space,
                               const std::vector<VertexStiffness>& springs, double h) {
  constexpr double kLeast = 1e-3;                 // of the stiffest function
  std::map<std::uint32_t, Eigen::Index> touched;  // node and its index here
  for (const VertexStiffness& s : springs)
    for (std::uint32_t k = space.begin[s.vertex]; k < space.begin[s.vertex + 1]; ++k)
      touched.emplace(space.node[k], static_cast<Eigen::Index>(touched.size()));
  const auto count = static_cast<Eigen::Index>(touched.size());
  if (count == 0) return inverse;
  MatrixXd stiffness = MatrixXd::Zero(count, count);  // of one component [kg]; the same for the others
  for (const VertexStiffness& s : springs)
    for (std::uint32_t k = space.begin[s.vertex]; k < space.begin[s.vertex + 1]; ++k)
      for (std::uint32_t l = space.begin[s.vertex]; l < space.begin[s.vertex + 1]; ++l)
        stiffness(touched.at(space.node[k]), touched.at(space.node[l])) +=
            h * h * s.stiffness * space.weight[k] * space.weight[l];
  const SymmetricEigen eigen = symmetric_eigen(stiffness);
  const double least = kLeast * eigen.values[count - 1];
  Eigen::Index first = 0;
  while (first < count && !(eigen.values[first] > least)) ++first;
  const Eigen::Index rank = 3 * (count - first);
  if (rank == 0) return inverse;  // springs without stiffness
  Eigen::MatrixXf functions = Eigen::MatrixXf::Zero(inverse.rows(), rank);
  Eigen::VectorXd compliance(rank);
  for (Eigen::Index m = 0; m < rank; ++m) {
    compliance[m] = 1 / eigen.values[first + m / 3];
    for (const auto& [node, place] : touched)
      functions(3 * static_cast<Eigen::Index>(node) + m % 3, m) =
          static_cast<float>(eigen.vectors(place, first + m / 3));
  }
  const Eigen::MatrixXf moved = inverse * functions;
  MatrixXd small = (functions.transpose() * moved).cast<double>();
  small.diagonal() += compliance;
  const Eigen::MatrixXf back = small.ldlt().solve(moved.transpose().cast<double>()).cast<float>();
  return inverse - moved * back;
}

}  // namespace fascia
