#include "sim/accuracy/refined_stress.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>

#include "sim/accuracy/conjugate_gradients.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/spread_loads.h"
#include "sim/mesh/linear_tets.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Vectors = std::vector<Vector3d>;

constexpr std::size_t kPointsOfOne = QuadraticTet::kPoints;

std::vector<Vector4d> points_of_one() {
  std::vector<Vector4d> points(kPointsOfOne, Vector4d::Constant(QuadraticTet::kFar));
  for (int q = 0; q < QuadraticTet::kPoints; ++q) points[static_cast<std::size_t>(q)][q] = QuadraticTet::kNear;
  return points;
}

/// Barycentric coordinates of a vertex of a quadratic tet.
Vector4d place_of(const ElementVertices& element, std::uint32_t vertex) {
  const auto n = static_cast<std::size_t>(std::find(element.begin(), element.end(), vertex) - element.begin());
  if (n < 4) return Vector4d::Unit(static_cast<int>(n));
  const auto [a, b] = kMidEdgeCorners[n - 4];
  return 0.5 * (Vector4d::Unit(static_cast<int>(a)) + Vector4d::Unit(static_cast<int>(b)));
}

LinearTet corners_of(const Model& model, const Tet& tet) {
  const auto& x = model.rest_positions;
  return LinearTet({x[tet[0]], x[tet[1]], x[tet[2]], x[tet[3]]});
}

/// The forces [N] at vertices of stresses P at the points of a quadratic tet.
void add_forces(const QuadraticTet& rest, const ElementVertices& vertices, std::size_t q, const Matrix3d& first_piola,
                Vectors& forces) {
  const Eigen::Matrix<double, 3, 10> of =
      0.25 * rest.volume * first_piola * rest.shape_gradients_at_point(static_cast<int>(q));
  for (std::size_t n = 0; n < 10; ++n) forces[vertices[n]] += of.col(static_cast<int>(n));
}

/// What functions at corners have at mid-edge vertices.
void continue_to(const std::vector<MidEdge>& edges, Vectors& field) {
  for (const MidEdge& edge : edges) field[edge.vertex] = 0.5 * (field[edge.a] + field[edge.b]);
}

/// The forces on functions at corners, from those on all.
void restrict_to_corners(const std::vector<MidEdge>& edges, Vectors& forces) {
  for (const MidEdge& edge : edges)
    for (const std::uint32_t v : {edge.a, edge.b}) forces[v] += 0.5 * forces[edge.vertex];
}

}  // namespace

RefinedStress::RefinedStress(const Model& model, const State& state, const std::stop_token& stop) : model_(model) {
  for (std::uint32_t t = 0; t < model.tets.size(); ++t)
    if (model.is_quadratic(t)) tets_.push_back(t);
  cut(state);
  Vectors forces(model.rest_positions.size(), Vector3d::Zero());
  for (const std::uint32_t t : tets_) {
    if (stop.stop_requested()) return;
    const QuadraticTet rest(corners_of(model, model.tets[t]));
    const std::vector<PointStress> own = stresses_of(model, state, t, points_of_one());
    for (std::size_t q = 0; q < kPointsOfOne; ++q)
      add_forces(rest, model.element(t), q, own[q].rotation * matrix_of(own[q].stress), forces);
  }
  move_on(loads_of(forces), stop);
}

void RefinedStress::move_on(const Vectors& loads, const std::stop_token& stop) {
  constexpr int kMostSteps = 20, kMostHalves = 10;
  constexpr double kShare = 1e-5;  // of the first step's work
  const auto potential = [&] {
    double sum = 0;
    for (const Element& element : elements_) sum += element.energy;
    for (std::size_t v = 0; v < loads.size(); ++v)
      if (!held_[v]) sum -= loads[v].dot(fine_state_.displacement[v]);
    return sum;
  };
  update_points();
  double first = 0, before = potential();
  for (int step = 0; step < kMostSteps && !converged_; ++step) {
    const Vectors missing = residual(loads);
    Vectors delta;
    if (!solve(missing, stop, delta)) return;
    double work = 0;
    for (std::size_t v = 0; v < delta.size(); ++v) work += missing[v].dot(delta[v]);
    if (step == 0) first = work;
    const Vectors start = fine_state_.displacement;
    double length = 1;
    for (int half = 0; half < kMostHalves; ++half, length *= 0.5) {
      for (std::size_t v = 0; v < delta.size(); ++v) fine_state_.displacement[v] = start[v] + length * delta[v];
      update_points();
      if (potential() <= before) break;
    }
    before = potential();
    converged_ = length == 1 && work <= kShare * first;
  }
}

void RefinedStress::cut(const State& state) {
  TetMesh coarse, fine;
  fine.positions = coarse.positions = model_.rest_positions;
  first_of_.resize(model_.tets.size());
  for (const std::uint32_t t : tets_) {
    first_of_[t] = static_cast<std::uint32_t>(fine.tets.size());
    coarse.tets.push_back(model_.tets[t]);
    coarse.mid_edges.push_back(model_.mid_edges[t]);
    for (const Tet& tet : cut_in_eight(model_.tets[t], model_.mid_edges[t], model_.rest_positions)) {
      fine.tets.push_back(tet);
      fine_.tet_material.push_back(model_.tet_material[t]);
    }
  }
  std::vector<std::uint32_t> all(fine.tets.size());
  for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
  add_mid_edges(fine, all);
  coarse_edges_ = mid_edges_of(coarse);
  edges_ = mid_edges_of(fine);
  fine_.rest_positions = fine.positions;
  fine_.tets = fine.tets;
  fine_.mid_edges = fine.mid_edges;
  fine_.materials = model_.materials;
  held_ = model_.held();
  held_.resize(fine.positions.size());
  for (const MidEdge& edge : edges_) held_[edge.vertex] = held_[edge.a] && held_[edge.b];
  for (std::uint32_t v = 0; v < held_.size(); ++v)
    if (held_[v]) fine_.fixed.push_back(v);
  fine_state_.displacement = state.displacement;
  fine_state_.displacement.resize(fine.positions.size());
  for (const std::uint32_t t : tets_) {
    const ElementVertices whole = model_.element(t);
    for (std::size_t s = first_of_[t]; s < first_of_[t] + 8; ++s)
      for (std::size_t m = 0; m < 6; ++m) {
        const auto [a, b] = kMidEdgeCorners[m];
        const QuadraticTet::ShapeFunctions values = QuadraticTet::shape_functions(
            0.5 * (place_of(whole, fine_.tets[s][a]) + place_of(whole, fine_.tets[s][b])));
        Vector3d& u = fine_state_.displacement[fine_.mid_edges[s][m]];
        u.setZero();
        for (std::size_t n = 0; n < 10; ++n) u += values[n] * state.displacement[whole[n]];
      }
  }
  for (std::size_t s = 0; s < fine_.tets.size(); ++s) {
    const Material& material = fine_.materials[fine_.tet_material[s]];
    Element element{QuadraticTet(corners_of(fine_, fine_.tets[s])),
                    {},
                    material.lame_mu(),
                    material.lame_lambda(),
                    volume_split(material).bulk,
                    0,
                    {}};
    const ElementVertices vertices = fine_.element(s);
    std::copy(vertices.begin(), vertices.end(), element.vertices.begin());
    elements_.push_back(element);
  }
}

void RefinedStress::update_points() {
  for (std::size_t s = 0; s < elements_.size(); ++s) {
    Element& element = elements_[s];
    const VolumeSplit split = volume_split(fine_.materials[fine_.tet_material[s]]);
    const MaterialLaw& law = law_of(split.pointwise.model);
    QuadraticTet::Nodes nodes;
    for (std::size_t n = 0; n < 10; ++n) nodes[n] = fine_state_.displacement[element.vertices[n]];
    const QuadraticTet::PointGradients gradients = element.rest.at_points(nodes);
    std::array<Dilatation, kPointsOfOne> dilatations;
    double mean = 0;
    element.energy = 0;
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      const Matrix3d f = Matrix3d::Identity() + gradients[q];
      const Density density = law.density(f, split.pointwise, true);
      dilatations[q] = law.dilatation(f, true);
      mean += 0.25 * dilatations[q].value;
      element.energy += 0.25 * element.rest.volume * density.energy;
      element.points[q] = {f, density.first, dilatations[q].first, density.second};
    }
    const double pressure = split.bulk * mean;
    element.energy += 0.5 * element.rest.volume * pressure * mean;
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      element.points[q].first_piola += pressure * dilatations[q].first;
      element.points[q].tangent += pressure * dilatations[q].second;
    }
  }
}

RefinedStress::Vectors RefinedStress::loads_of(const Vectors& coarse_forces) const {
  Vectors on_corners = coarse_forces;
  restrict_to_corners(coarse_edges_, on_corners);
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const MidEdge& edge : coarse_edges_) ends.push_back({edge.a, edge.b});
  SpreadLoads loads = spread_loads(model_, tets_, ends, on_corners);
  continue_to(coarse_edges_, loads.field);
  continue_to(coarse_edges_, loads.traction);

  // What the coarse mesh's forces have beside both.
  Vectors result(held_.size(), Vector3d::Zero());
  std::copy(coarse_forces.begin(), coarse_forces.end(), result.begin());
  for (const std::uint32_t t : tets_) {
    const double mass = model_.materials[model_.tet_material[t]].density * volume_of(model_, t);
    const ElementVertices element = model_.element(t);
    for (std::size_t n = 0; n < 10; ++n)
      result[element[n]] -=
          mass * (n < 4 ? QuadraticTet::kCornerMass : QuadraticTet::kMidEdgeMass) * loads.field[element[n]];
  }
  add_traction(model_, loads.surface, coarse_edges_, loads.traction, -1, result);

  loads.field.resize(held_.size());
  loads.traction.resize(held_.size());
  continue_to(edges_, loads.field);
  add_traction(fine_, boundary_triangles(fine_.tets), edges_, loads.traction, 1, result);
  for (std::size_t s = 0; s < elements_.size(); ++s) {
    const Element& element = elements_[s];
    const double mass = fine_.materials[fine_.tet_material[s]].density * element.rest.volume;
    for (std::size_t n = 0; n < 10; ++n)
      result[element.vertices[n]] +=
          mass * (n < 4 ? QuadraticTet::kCornerMass : QuadraticTet::kMidEdgeMass) * loads.field[element.vertices[n]];
  }
  return result;
}

RefinedStress::Vectors RefinedStress::residual(const Vectors& loads) const {
  Vectors result = loads;
  for (std::size_t s = 0; s < elements_.size(); ++s)
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      const PointState& point = elements_[s].points[q];
      add_forces(elements_[s].rest, fine_.element(s), q, -point.first_piola, result);
    }
  for (std::size_t v = 0; v < result.size(); ++v)
    if (held_[v]) result[v].setZero();
  return result;
}

QuadraticTet::PointGradients RefinedStress::added_stresses(const Element& element, const Vectors& of) const {
  QuadraticTet::Nodes nodes;
  for (std::size_t n = 0; n < 10; ++n) nodes[n] = of[element.vertices[n]];
  QuadraticTet::PointGradients at = element.rest.at_points(nodes);
  double mean = 0;
  for (std::size_t q = 0; q < kPointsOfOne; ++q) mean += 0.25 * element.points[q].dilatation.cwiseProduct(at[q]).sum();
  for (std::size_t q = 0; q < kPointsOfOne; ++q) {
    Eigen::Map<Eigen::Matrix<double, 9, 1>> flat(at[q].data());
    flat = (element.points[q].tangent * flat).eval();
    at[q] += element.bulk * mean * element.points[q].dilatation;
  }
  return at;
}

RefinedStress::Vectors RefinedStress::apply(const Vectors& to) const {
  Vectors result(to.size(), Vector3d::Zero());
  for (const Element& element : elements_) {
    const QuadraticTet::PointGradients stresses = added_stresses(element, to);
    // The gradients of shape functions are linear in the tet: sums over the points by corner do.
    std::array<Vector3d, 10> forces;
    forces.fill(Vector3d::Zero());
    for (int c = 0; c < 4; ++c) {
      Matrix3d at = Matrix3d::Zero();  // int L_c P dV
      for (int q = 0; q < 4; ++q)
        at += 0.25 * element.rest.volume * (q == c ? QuadraticTet::kNear : QuadraticTet::kFar) *
              stresses[static_cast<std::size_t>(q)];
      const Eigen::Matrix<double, 3, 4> by_corner = at * element.rest.gradients;
      for (int a = 0; a < 4; ++a) forces[static_cast<std::size_t>(a)] += (a == c ? 3 : -1) * by_corner.col(a);
      for (std::size_t m = 0; m < 6; ++m) {
        const auto a = static_cast<int>(kMidEdgeCorners[m][0]), b = static_cast<int>(kMidEdgeCorners[m][1]);
        if (a == c) forces[4 + m] += 4 * by_corner.col(b);
        if (b == c) forces[4 + m] += 4 * by_corner.col(a);
      }
    }
    for (std::size_t n = 0; n < 10; ++n) result[element.vertices[n]] += forces[n];
  }
  for (std::size_t v = 0; v < result.size(); ++v)
    if (held_[v]) result[v].setZero();
  return result;
}

bool RefinedStress::solve(const Vectors& residual, const std::stop_token& stop, Vectors& delta) const {
  const std::size_t coarse = model_.rest_positions.size();
  std::vector<int> places(coarse, -1);
  int unknowns = 0;
  for (const std::uint32_t t : tets_)
    for (const std::uint32_t v : model_.tets[t])
      if (!held_[v] && places[v] < 0) places[v] = 3 * unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  const auto block_of = [](const Vector3d& a, const Vector3d& b, double mu, double lambda) -> Matrix3d {
    return mu * (a.dot(b) * Matrix3d::Identity() + b * a.transpose()) + lambda * a * b.transpose();
  };
  for (const std::uint32_t t : tets_) {
    const Element& one = elements_[first_of_[t]];
    const LinearTet rest = corners_of(model_, model_.tets[t]);
    Eigen::Matrix<double, 3, 4> g = one.points[0].f * rest.gradients;
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = 0; b < 4; ++b) {
        const int row = places[model_.tets[t][a]], column = places[model_.tets[t][b]];
        if (row < 0 || column < 0 || column > row) continue;
        Matrix3d block =
            rest.volume * block_of(g.col(static_cast<int>(a)), g.col(static_cast<int>(b)), one.mu, one.lambda);
        if (row == column) block.diagonal() *= 1 + 1e-9;  // what nothing holds
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) entries.emplace_back(row + i, column + j, block(i, j));
      }
  }
  Eigen::SparseMatrix<double> matrix(3 * unknowns, 3 * unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (stop.stop_requested()) return false;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factorized(matrix);
  if (factorized.info() != Eigen::Success) return false;

  std::vector<Matrix3d> linear(coarse, Matrix3d::Zero()), blocks(held_.size(), Matrix3d::Zero());
  for (const Element& element : elements_) {
    const auto& v = element.vertices;
    for (int a = 0; a < 4; ++a) {
      const Vector3d g = element.points[0].f * element.rest.gradients.col(a);
      linear[v[static_cast<std::size_t>(a)]] += element.rest.volume * block_of(g, g, element.mu, element.lambda);
    }
    Eigen::Matrix<double, 3, 10> mean = Eigen::Matrix<double, 3, 10>::Zero();
    for (int q = 0; q < 4; ++q) {
      const Eigen::Matrix<double, 3, 10> g =
          element.points[static_cast<std::size_t>(q)].f * element.rest.shape_gradients_at_point(q);
      mean += 0.25 * g;
      for (int n = 0; n < 10; ++n)
        blocks[v[static_cast<std::size_t>(n)]] +=
            0.25 * element.rest.volume * block_of(g.col(n), g.col(n), element.mu, element.lambda - element.bulk);
    }
    for (int n = 0; n < 10; ++n)
      blocks[v[static_cast<std::size_t>(n)]] +=
          element.rest.volume * element.bulk * mean.col(n) * mean.col(n).transpose();
  }
  for (auto* list : {&linear, &blocks})
    for (Matrix3d& block : *list)
      if (block.trace() > 0) block = Matrix3d(block.inverse());

  const auto precondition = [&](const Vectors& forces) {
    Vectors r = forces, z(r.size(), Vector3d::Zero());
    restrict_to_corners(edges_, r);
    Vectors middle(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(coarse)), rough = middle;
    restrict_to_corners(coarse_edges_, rough);
    Eigen::VectorXd right(3 * unknowns);
    for (std::size_t v = 0; v < coarse; ++v)
      if (places[v] >= 0) right.segment<3>(places[v]) = rough[v];
    const Eigen::VectorXd solved = factorized.solve(right);
    for (std::size_t v = 0; v < coarse; ++v)
      if (places[v] >= 0) z[v] = solved.segment<3>(places[v]);
    continue_to(coarse_edges_, z);
    for (std::size_t v = 0; v < coarse; ++v)
      if (!held_[v]) z[v] += linear[v] * middle[v];
    continue_to(edges_, z);
    for (std::size_t v = 0; v < z.size(); ++v) {
      if (held_[v])
        z[v].setZero();
      else
        z[v] += blocks[v] * forces[v];
    }
    return z;
  };
  return conjugate_gradients(
      residual, [&](const Vectors& to) { return apply(to); }, precondition, 1e-3 /* the next step finds the rest */,
      stop, delta);
}

std::array<RefinedStress::Point, RefinedStress::kPoints> RefinedStress::at(std::size_t tet) const {
  std::array<Point, kPoints> points;
  const ElementVertices whole = model_.element(tet);
  for (std::size_t k = 0; k < 8; ++k) {
    const std::size_t s = first_of_[tet] + k;
    const std::vector<PointStress> own = stresses_of(fine_, fine_state_, s, points_of_one());
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      Point& point = points[kPointsOfOne * k + q];
      point.barycentric.setZero();
      for (std::size_t c = 0; c < 4; ++c)
        point.barycentric += (c == q ? QuadraticTet::kNear : QuadraticTet::kFar) * place_of(whole, fine_.tets[s][c]);
      point.stress = own[q].stress;
      point.growth_gap = own[q].growth_gap;
    }
  }
  return points;
}

}  // namespace fascia
