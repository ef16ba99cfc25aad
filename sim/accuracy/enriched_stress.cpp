#include "sim/accuracy/enriched_stress.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <map>
#include <utility>

#include "sim/accuracy/conjugate_gradients.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/spread_loads.h"
#include "sim/elements/quadratic_tet.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using reference::Vector6d;

/// The gradient of 4 L_a L_b, a and b being the corners of edge e.
Vector3d edge_gradient(const LinearTet& rest, std::size_t e, const Vector4d& at) {
  const auto a = static_cast<int>(kMidEdgeCorners[e][0]), b = static_cast<int>(kMidEdgeCorners[e][1]);
  return 4 * (at[a] * rest.gradients.col(b) + at[b] * rest.gradients.col(a));
}

}  // namespace

EnrichedStress::EnrichedStress(const Model& model, const State& state, const std::stop_token& stop)
    : model_(model), held_(model.held()) {
  make_elements(state);
  find_edges();
  solve(loads_of_edges(), stop);
}

void EnrichedStress::make_elements(const State& state) {
  const std::vector<Vector4d> middle{Vector4d::Constant(0.25)};
  element_of_.resize(model_.tets.size());
  for (std::size_t t = 0; t < model_.tets.size(); ++t) {
    if (model_.is_quadratic(t)) continue;
    const Tet& tet = model_.tets[t];
    const LinearTet rest({model_.rest_positions[tet[0]], model_.rest_positions[tet[1]], model_.rest_positions[tet[2]],
                          model_.rest_positions[tet[3]]});
    const PointStress own = stresses_of(model_, state, t, middle).front();
    element_of_[t] = static_cast<std::uint32_t>(elements_.size());
    elements_.push_back({static_cast<std::uint32_t>(t), rest, own.rotation,
                         rest.volume * own.rotation * matrix_of(own.stress) * rest.gradients});
  }
}

void EnrichedStress::find_edges() {
  const std::size_t vertices = held_.size();
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers;
  for (Element& element : elements_) {
    const Tet& tet = model_.tets[element.tet];
    for (std::size_t e = 0; e < 6; ++e) {
      std::array<std::uint32_t, 2> ends{tet[kMidEdgeCorners[e][0]], tet[kMidEdgeCorners[e][1]]};
      if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
      const auto [place, added] = numbers.try_emplace(ends, static_cast<std::uint32_t>(ends_.size()));
      if (added) ends_.push_back(ends);
      element.edges[e] = static_cast<std::uint32_t>(vertices) + place->second;
    }
  }
  for (const auto& ends : ends_) held_.push_back(held_[ends[0]] && held_[ends[1]]);
}

EnrichedStress::Vectors EnrichedStress::loads_of_edges() const {
  const std::size_t vertices = held_.size() - ends_.size();
  Vectors forces(vertices, Vector3d::Zero()), residual(held_.size(), Vector3d::Zero());
  std::vector<std::uint32_t> tets;
  for (const Element& element : elements_) {
    tets.push_back(element.tet);
    for (std::size_t a = 0; a < 4; ++a) forces[model_.tets[element.tet][a]] += element.forces.col(static_cast<int>(a));
  }
  Middles middles;
  for (std::size_t e = 0; e < ends_.size(); ++e) middles.emplace(ends_[e], static_cast<std::uint32_t>(vertices + e));
  const Vectors field = spread_field(model_, tets, middles, forces);
  for (const Element& element : elements_) {
    const Tet& tet = model_.tets[element.tet];
    const double mass = model_.materials[model_.tet_material[element.tet]].density * element.rest.volume;
    Vector3d all = Vector3d::Zero();
    for (const std::uint32_t v : tet) all += field[v];
    for (std::size_t e = 0; e < 6; ++e) {
      const auto [a, b] = kMidEdgeCorners[e];
      const Vector3d ends = field[tet[a]] + field[tet[b]];
      residual[element.edges[e]] +=
          mass / 30 * (all + ends) - element.forces.col(static_cast<int>(a)) - element.forces.col(static_cast<int>(b));
    }
  }
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const LinearTet& rest = elements_[t].rest;
    const Tet& tet = model_.tets[tets[t]];
    const double mass = model_.materials[model_.tet_material[tets[t]]].density * rest.volume / 4;
    for (const std::uint32_t v : tet) forces[v] -= mass * field[v];
  }
  for (const FaceLoad& load : spread_on_faces(model_, tets, middles, held_, forces, true)) {
    const std::array<Vector3d, 6> of_face = forces_of(load);
    for (std::size_t k = 3; k < 6; ++k) residual[load.vertices[k]] += of_face[k];
  }
  for (std::size_t i = 0; i < residual.size(); ++i)
    if (held_[i]) residual[i].setZero();
  return residual;
}

Matrix3d EnrichedStress::gradient_at(const Element& element, const Vectors& of, const Vector4d& barycentric) const {
  const Tet& tet = model_.tets[element.tet];
  Matrix3d gradient = Matrix3d::Zero();
  for (std::size_t a = 0; a < 4; ++a)
    gradient += of[tet[a]] * element.rest.gradients.col(static_cast<int>(a)).transpose();
  for (std::size_t e = 0; e < 6; ++e)
    gradient += of[element.edges[e]] * edge_gradient(element.rest, e, barycentric).transpose();
  return element.rotation.transpose() * gradient;
}

Matrix3d EnrichedStress::mean_gradient(const Element& element, const Vectors& of) const {
  return gradient_at(element, of, Vector4d::Constant(0.25));  // it is linear in the tet
}

Matrix3d EnrichedStress::stress_at(const Element& element, const Vectors& of, const Vector4d& barycentric,
                                   double mean_trace) const {
  const Material& material = model_.materials[model_.tet_material[element.tet]];
  const Matrix3d gradient = gradient_at(element, of, barycentric);
  return material.lame_mu() * (gradient + gradient.transpose()) +
         material.lame_lambda() * mean_trace * Matrix3d::Identity();
}

EnrichedStress::Vectors EnrichedStress::apply(const Vectors& to) const {
  Vectors result(to.size(), Vector3d::Zero());
  for (const Element& element : elements_) {
    const Tet& tet = model_.tets[element.tet];
    const double trace = mean_gradient(element, to).trace(), weight = element.rest.volume / 4;
    for (const Vector4d& point : QuadraticTet::points()) {
      const Matrix3d stress = weight * element.rotation * stress_at(element, to, point, trace);
      for (std::size_t a = 0; a < 4; ++a) result[tet[a]] += stress * element.rest.gradients.col(static_cast<int>(a));
      for (std::size_t e = 0; e < 6; ++e) result[element.edges[e]] += stress * edge_gradient(element.rest, e, point);
    }
  }
  for (std::size_t i = 0; i < result.size(); ++i)
    if (held_[i]) result[i].setZero();
  return result;
}

void EnrichedStress::solve(const Vectors& residual, const std::stop_token& stop) {
  const std::size_t vertices = held_.size() - ends_.size();
  std::vector<int> places(vertices, -1);  // of the unknowns of vertices
  int unknowns = 0;
  std::vector<char> used(vertices);
  for (const Element& element : elements_)
    for (const std::uint32_t v : model_.tets[element.tet]) used[v] = 1;
  for (std::size_t v = 0; v < vertices; ++v)
    if (used[v] && !held_[v]) places[v] = 3 * unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Matrix3d> blocks(ends_.size(), Matrix3d::Zero());
  for (const Element& element : elements_) {
    const Material& material = model_.materials[model_.tet_material[element.tet]];
    const double mu = material.lame_mu(), lambda = material.lame_lambda(), volume = element.rest.volume;
    const Tet& tet = model_.tets[element.tet];
    const Eigen::Matrix<double, 3, 4> turned = element.rotation * element.rest.gradients;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) {
        const int row = places[tet[a]], column = places[tet[b]];
        if (row < 0 || column < 0 || column > row) continue;
        const Vector3d ga = turned.col(static_cast<int>(a)), gb = turned.col(static_cast<int>(b));
        Matrix3d block =
            volume * (mu * (ga.dot(gb) * Matrix3d::Identity() + gb * ga.transpose()) + lambda * ga * gb.transpose());
        if (row == column) block.diagonal() *= 1 + 1e-9;  // what nothing holds
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) entries.emplace_back(row + i, column + j, block(i, j));
      }
    for (std::size_t e = 0; e < 6; ++e) {
      Matrix3d& block = blocks[element.edges[e] - vertices];
      const Vector3d mean =
          turned.col(static_cast<int>(kMidEdgeCorners[e][0])) + turned.col(static_cast<int>(kMidEdgeCorners[e][1]));
      block += lambda * volume * mean * mean.transpose();
      for (const Vector4d& point : QuadraticTet::points()) {
        const Vector3d g = element.rotation * edge_gradient(element.rest, e, point);
        block += volume / 4 * mu * (g.squaredNorm() * Matrix3d::Identity() + g * g.transpose());
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(3 * unknowns, 3 * unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (stop.stop_requested()) return;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> linear(matrix);
  for (Matrix3d& block : blocks) block = Matrix3d(block.inverse());
  if (linear.info() != Eigen::Success) return;
  const auto precondition = [&](const Vectors& r) {
    Vectors z(r.size(), Vector3d::Zero());
    Eigen::VectorXd right(3 * unknowns);
    for (std::size_t v = 0; v < vertices; ++v)
      if (places[v] >= 0) right.segment<3>(places[v]) = r[v];
    const Eigen::VectorXd solved = linear.solve(right);
    for (std::size_t v = 0; v < vertices; ++v)
      if (places[v] >= 0) z[v] = solved.segment<3>(places[v]);
    for (std::size_t e = 0; e < blocks.size(); ++e)
      if (!held_[vertices + e]) z[vertices + e] = blocks[e] * r[vertices + e];
    return z;
  };
  converged_ = conjugate_gradients(
      residual, [&](const Vectors& to) { return apply(to); }, precondition, 1e-6, stop, delta_);
}

Vector6d EnrichedStress::at(std::size_t tet, const Vector4d& barycentric) const {
  const Element& element = elements_[element_of_[tet]];
  return components_of(stress_at(element, delta_, barycentric, mean_gradient(element, delta_).trace()));
}

}  // namespace fascia
