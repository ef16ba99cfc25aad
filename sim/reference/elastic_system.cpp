#include "sim/reference/elastic_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace fascia::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct FreeVertices {
  std::vector<int> place;  // [vertex_count] in the order of elimination, -1 where not free or in no tet
  EliminationTree tree;
};

FreeVertices free_vertices(const Model& model) {
  const std::vector<char> held = model.held();
  FreeVertices result;
  std::vector<int>& place = result.place;  // at first their numbers
  place.assign(model.rest_positions.size(), -1);
  std::vector<Vector3d> positions;
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet)
      if (!held[v] && place[v] < 0) {
        place[v] = static_cast<int>(positions.size());
        positions.push_back(model.rest_positions[v]);
      }
  std::vector<std::vector<int>> neighbors(positions.size());
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet)
      for (const std::uint32_t w : tet)
        if (v != w && place[v] >= 0 && place[w] >= 0) neighbors[place[v]].push_back(place[w]);
  for (std::vector<int>& list : neighbors) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  result.tree = nested_dissection(neighbors, positions);
  for (int& p : place)
    if (p >= 0) p = result.tree.place[p];
  return result;
}

}  // namespace

ElasticSystem::ElasticSystem(const Model& model) : model_(model) {
  rest_.reserve(model.tets.size());
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    rest_.emplace_back(Corners{x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
  }
  FreeVertices free = free_vertices(model);
  const std::vector<int>& order = free.place;
  tree_ = std::move(free.tree);
  const int free_count = static_cast<int>(tree_.place.size());
  dof_count_ = 3 * free_count;
  first_dof_.resize(order.size());
  std::transform(order.begin(), order.end(), first_dof_.begin(), [](int place) { return place < 0 ? -1 : 3 * place; });

  // Ascending row blocks of the upper triangle, per block column.
  std::vector<std::vector<int>> rows(free_count);
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet)
      for (const std::uint32_t w : tet)
        if (order[v] >= 0 && order[v] <= order[w]) rows[order[w]].push_back(order[v]);
  for (std::vector<int>& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
  }
  if (dof_count_ > 0) make_pattern(rows);

  block_rank_.resize(model.tets.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < 4; ++b) {
        const int i = order[model.tets[t][a]], j = order[model.tets[t][b]];
        int& rank = block_rank_[t][4 * a + b];
        rank = -1;
        if (i < 0 || i > j) continue;
        rank = static_cast<int>(std::lower_bound(rows[j].begin(), rows[j].end(), i) - rows[j].begin());
      }
}

void ElasticSystem::make_pattern(const std::vector<std::vector<int>>& rows) {
  pattern_.resize(dof_count_, dof_count_);
  const int block_count = static_cast<int>(rows.size());
  Eigen::VectorXi column_sizes(dof_count_);
  for (int j = 0; j < block_count; ++j)
    for (int c = 0; c < 3; ++c) column_sizes[3 * j + c] = 3 * (static_cast<int>(rows[j].size()) - 1) + c + 1;
  pattern_.reserve(column_sizes);
  for (int j = 0; j < block_count; ++j)
    for (int c = 0; c < 3; ++c)
      for (const int i : rows[j])
        for (int r = 0; r < (i == j ? c + 1 : 3); ++r) pattern_.insert(3 * i + r, 3 * j + c) = 0;
  pattern_.makeCompressed();
}

VectorXd ElasticSystem::free_part(const VectorXd& all) const {
  VectorXd free(dof_count_);
  for (std::size_t v = 0; v < first_dof_.size(); ++v)
    if (first_dof_[v] >= 0) free.segment<3>(first_dof_[v]) = all.segment<3>(3 * v);
  return free;
}

void ElasticSystem::add_to_free(const VectorXd& free, double factor, VectorXd& all) const {
  for (std::size_t v = 0; v < first_dof_.size(); ++v)
    if (first_dof_[v] >= 0) all.segment<3>(3 * v) += factor * free.segment<3>(first_dof_[v]);
}

Corners ElasticSystem::corners(const VectorXd& u, const Tet& tet) const {
  return {u.segment<3>(3 * tet[0]), u.segment<3>(3 * tet[1]), u.segment<3>(3 * tet[2]), u.segment<3>(3 * tet[3])};
}

Derivatives ElasticSystem::derivatives(std::size_t t, const VectorXd& u, const ViscousStep& viscous, bool with_hessian,
                                       bool project) const {
  const Material& material = model_.materials[model_.tet_material[t]];
  const bool damped = !viscous.previous_strain.empty();
  const Matrix3d previous = damped ? viscous.previous_strain[t] : Matrix3d::Zero();
  return elastic(rest_[t], corners(u, model_.tets[t]), material, damped ? material.damping / viscous.h : 0, previous,
                 with_hessian, project);
}

double ElasticSystem::evaluate(const VectorXd& u, const ViscousStep& viscous, VectorXd& gradient) const {
  double energy = 0;
  gradient.setZero(u.size());
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    const Derivatives d = derivatives(t, u, viscous, false, false);
    energy += d.energy;
    for (int a = 0; a < 4; ++a) gradient.segment<3>(3 * model_.tets[t][a]) += d.gradient.segment<3>(3 * a);
  }
  return energy;
}

void ElasticSystem::assemble(const VectorXd& u, const ViscousStep& viscous, bool project, SparseMatrix& hessian,
                             VectorXd& scale) const {
  double* values = hessian.valuePtr();
  const int* column_begin = hessian.outerIndexPtr();
  std::fill(values, values + hessian.nonZeros(), 0.0);
  scale.setZero(u.size());
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    const Tet& tet = model_.tets[t];
    const Derivatives d = derivatives(t, u, viscous, true, project);
    Vector12d size;
    for (int a = 0; a < 4; ++a) size.segment<3>(3 * a) = u.segment<3>(3 * tet[a]).cwiseAbs();
    const Vector12d tet_scale = d.hessian.cwiseAbs() * size;
    for (int a = 0; a < 4; ++a) {
      scale.segment<3>(3 * tet[a]) += tet_scale.segment<3>(3 * a);
      for (int b = 0; b < 4; ++b) {
        const int rank = block_rank_[t][4 * a + b];
        if (rank < 0) continue;
        const int column = first_dof_[tet[b]];
        for (int c = 0; c < 3; ++c) {
          double* target = values + column_begin[column + c] + 3 * rank;
          for (int r = 0; r < (a == b ? c + 1 : 3); ++r) target[r] += d.hessian(3 * a + r, 3 * b + c);
        }
      }
    }
  }
}

VectorXd ElasticSystem::hessian_times(const VectorXd& u, const ViscousStep& viscous, const VectorXd& direction) const {
  VectorXd product = VectorXd::Zero(u.size());
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    const Tet& tet = model_.tets[t];
    Vector12d tet_direction;
    for (int a = 0; a < 4; ++a) tet_direction.segment<3>(3 * a) = direction.segment<3>(3 * tet[a]);
    if (tet_direction.isZero(0)) continue;
    const Vector12d tet_product = derivatives(t, u, viscous, true, false).hessian * tet_direction;
    for (int a = 0; a < 4; ++a) product.segment<3>(3 * tet[a]) += tet_product.segment<3>(3 * a);
  }
  return product;
}

bool ElasticSystem::viscous() const {
  return std::any_of(model_.materials.begin(), model_.materials.end(), [](const Material& m) { return m.damping > 0; });
}

std::vector<Matrix3d> ElasticSystem::strains(const VectorXd& u) const {
  std::vector<Matrix3d> result(rest_.size());
  for (std::size_t t = 0; t < rest_.size(); ++t) result[t] = green_strain_matrix(rest_[t], corners(u, model_.tets[t]));
  return result;
}

double ElasticSystem::min_det_f(const VectorXd& u) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < rest_.size(); ++t)
    smallest = std::min(smallest, rest_[t].deformation_gradient(corners(u, model_.tets[t])).determinant());
  return smallest;
}

}  // namespace fascia::reference
