#include "sim/reference/elastic_system.h"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "sim/material/law.h"
#include "sim/reference/quadratic_elasticity.h"

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
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t))
      if (!held[v] && place[v] < 0) {
        place[v] = static_cast<int>(positions.size());
        positions.push_back(model.rest_positions[v]);
      }
  std::vector<std::vector<int>> neighbors(positions.size());
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t))
      for (const std::uint32_t w : model.element(t))
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

Corners gather(const VectorXd& u, const Tet& tet) {
  return {u.segment<3>(3 * tet[0]), u.segment<3>(3 * tet[1]), u.segment<3>(3 * tet[2]), u.segment<3>(3 * tet[3])};
}

QuadraticTet::Nodes gather(const VectorXd& u, const ElementVertices& element) {
  QuadraticTet::Nodes nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = u.segment<3>(3 * element[n]);
  return nodes;
}

constexpr auto kEvery = [](const ElementVertices&) { return true; };

}  // namespace

ElasticSystem::ElasticSystem(const Model& model) : model_(model) {
  rest_.reserve(model.tets.size());
  for (const Tet& tet : model.tets) {
    const auto& x = model.rest_positions;
    rest_.emplace_back(Corners{x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
  }
  for (std::size_t t = 0, points = 0, blocks = 0; t < model.tets.size(); ++t) {
    first_point_.push_back(points);
    first_block_.push_back(blocks);
    points += model.is_quadratic(t) ? QuadraticTet::kPoints : 1;
    blocks += model.element(t).size() * model.element(t).size();
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
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t))
      for (const std::uint32_t w : model.element(t))
        if (order[v] >= 0 && order[v] <= order[w]) rows[order[w]].push_back(order[v]);
  for (std::vector<int>& column : rows) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
  }
  if (dof_count_ > 0) make_pattern(rows);

  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t))
      for (const std::uint32_t w : model.element(t)) {
        const int i = order[v], j = order[w];
        int& rank = block_rank_.emplace_back(-1);
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

template <class Wanted, class F>
void ElasticSystem::visit(const VectorXd& u, const ViscousStep& viscous, bool with_hessian, bool project,
                          Wanted&& wanted, F&& f) const {
  const bool damped = !viscous.previous_strain.empty();
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    const Material& material = model_.materials[model_.tet_material[t]];
    const double damping_over_h = damped ? material.damping / viscous.h : 0;
    const ElementVertices element = model_.element(t);
    if (!wanted(element)) continue;
    if (model_.is_quadratic(t)) {
      PointStrains previous;
      for (std::size_t q = 0; q < previous.size(); ++q)
        previous[q] = damped ? viscous.previous_strain[first_point_[t] + q] : Matrix3d::Zero();
      f(t, element,
        elastic(QuadraticTet(rest_[t]), gather(u, element), material, damping_over_h, previous, with_hessian, project));
    } else {
      const Matrix3d previous = damped ? viscous.previous_strain[first_point_[t]] : Matrix3d::Zero();
      f(t, element,
        elastic(rest_[t], gather(u, model_.tets[t]), material, damping_over_h, previous, with_hessian, project));
    }
  }
}

Vector3d ElasticSystem::reach(std::size_t t, const ElementVertices& element, int a) const {
  if (law_of(model_.materials[model_.tet_material[t]].model).is_st_venant_kirchhoff) return Vector3d::Zero();
  return (model_.rest_positions[element[a]] - model_.rest_positions[element[0]]).cwiseAbs();
}

double ElasticSystem::evaluate(const VectorXd& u, const ViscousStep& viscous, VectorXd& gradient,
                               double* rounded) const {
  double energy = 0, work = 0;
  gradient.setZero(u.size());
  visit(u, viscous, false, false, kEvery,
        [&]<int n>(std::size_t t, const ElementVertices& element, const ElementDerivatives<n>& d) {
          energy += d.energy;
          for (int a = 0; a < n; ++a) {
            const Vector3d force = d.gradient.template segment<3>(3 * a);
            gradient.segment<3>(3 * element[a]) += force;
            work += force.cwiseAbs().dot(reach(t, element, a));
          }
        });
  if (rounded) *rounded = work;
  return energy;
}

void ElasticSystem::assemble(const VectorXd& u, const ViscousStep& viscous, bool project, SparseMatrix& hessian,
                             VectorXd& scale) const {
  double* values = hessian.valuePtr();
  const int* column_begin = hessian.outerIndexPtr();
  std::fill(values, values + hessian.nonZeros(), 0.0);
  scale.setZero(u.size());
  visit(u, viscous, true, project, kEvery,
        [&]<int n>(std::size_t t, const ElementVertices& element, const ElementDerivatives<n>& d) {
          Eigen::Matrix<double, 3 * n, 1> size;
          for (int a = 0; a < n; ++a)
            size.template segment<3>(3 * a) = u.segment<3>(3 * element[a]).cwiseAbs() + reach(t, element, a);
          const Eigen::Matrix<double, 3 * n, 1> tet_scale = d.hessian.cwiseAbs() * size;
          for (int a = 0; a < n; ++a) {
            scale.segment<3>(3 * element[a]) += tet_scale.template segment<3>(3 * a);
            for (int b = 0; b < n; ++b) {
              const int rank = block_rank_[first_block_[t] + static_cast<std::size_t>(n * a + b)];
              if (rank < 0) continue;
              const int column = first_dof_[element[b]];
              for (int c = 0; c < 3; ++c) {
                double* target = values + column_begin[column + c] + 3 * rank;
                for (int r = 0; r < (a == b ? c + 1 : 3); ++r) target[r] += d.hessian(3 * a + r, 3 * b + c);
              }
            }
          }
        });
}

void ElasticSystem::add_block(std::uint32_t row_vertex, std::uint32_t column_vertex, const Matrix3d& block,
                              SparseMatrix& hessian) const {
  const int row = first_dof_[row_vertex], column = first_dof_[column_vertex];
  if (row < 0 || row > column) return;
  for (int c = 0; c < 3; ++c) {
    const int* begin = hessian.innerIndexPtr() + hessian.outerIndexPtr()[column + c];
    const int* end = hessian.innerIndexPtr() + hessian.outerIndexPtr()[column + c + 1];
    double* target = hessian.valuePtr() + (std::lower_bound(begin, end, row) - hessian.innerIndexPtr());
    for (int r = 0; r < (row == column ? c + 1 : 3); ++r) target[r] += block(r, c);
  }
}

VectorXd ElasticSystem::hessian_times(const VectorXd& u, const ViscousStep& viscous, const VectorXd& direction) const {
  VectorXd product = VectorXd::Zero(u.size());
  const auto moves = [&](const ElementVertices& element) {
    return std::any_of(element.begin(), element.end(),
                       [&](std::uint32_t v) { return !direction.segment<3>(3 * v).isZero(0); });
  };
  visit(u, viscous, true, false, moves,
        [&]<int n>(std::size_t, const ElementVertices& element, const ElementDerivatives<n>& d) {
          Eigen::Matrix<double, 3 * n, 1> tet_direction;
          for (int a = 0; a < n; ++a) tet_direction.template segment<3>(3 * a) = direction.segment<3>(3 * element[a]);
          const Eigen::Matrix<double, 3 * n, 1> tet_product = d.hessian * tet_direction;
          for (int a = 0; a < n; ++a) product.segment<3>(3 * element[a]) += tet_product.template segment<3>(3 * a);
        });
  return product;
}

double ElasticSystem::largest_coordinate() const {
  double largest = 0;
  for (const Vector3d& x : model_.rest_positions) largest = std::max(largest, x.lpNorm<Eigen::Infinity>());
  return largest;
}

bool ElasticSystem::viscous() const {
  return std::any_of(model_.materials.begin(), model_.materials.end(), [](const Material& m) { return m.damping > 0; });
}

std::vector<Matrix3d> ElasticSystem::strains(const VectorXd& u) const {
  std::vector<Matrix3d> result;
  for (std::size_t t = 0; t < rest_.size(); ++t) {
    if (model_.is_quadratic(t)) {
      const PointStrains strains = green_strains(QuadraticTet(rest_[t]), gather(u, model_.element(t)));
      result.insert(result.end(), strains.begin(), strains.end());
    } else {
      result.push_back(green_strain_matrix(rest_[t], gather(u, model_.tets[t])));
    }
  }
  return result;
}

double ElasticSystem::min_det_f(const VectorXd& u) const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < rest_.size(); ++t)
    smallest = std::min(smallest, model_.is_quadratic(t)
                                      ? volume_ratios(QuadraticTet(rest_[t]), gather(u, model_.element(t)), false).min
                                      : rest_[t].deformation_gradient(gather(u, model_.tets[t])).determinant());
  return smallest;
}

VectorXd flattened(const std::vector<Vector3d>& vectors) {
  VectorXd all(static_cast<Eigen::Index>(3 * vectors.size()));
  for (std::size_t v = 0; v < vectors.size(); ++v) all.segment<3>(static_cast<Eigen::Index>(3 * v)) = vectors[v];
  return all;
}

std::vector<Vector3d> as_vectors(const VectorXd& all) {
  std::vector<Vector3d> vectors;
  for (Eigen::Index i = 0; i < all.size(); i += 3) vectors.emplace_back(all.segment<3>(i));
  return vectors;
}

}  // namespace fascia::reference
