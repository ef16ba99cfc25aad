#include "sim/accuracy/finer_solution.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>

#include "sim/accuracy/conjugate_gradients.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/spread_loads.h"
#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Vectors = std::vector<Vector3d>;

constexpr std::size_t kPointsOfOne = QuadraticTet::kPoints;

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

FinerSolution::FinerSolution(const Model& model, const State& state, ElementOrder kind, const std::stop_token& stop)
    : model_(model), kind_(kind), refined_(refined(model, state, kind)) {
  make_elements();
  keep_free_pieces();
  if (stop.stop_requested()) return;
  const Vectors forces = forces_of_coarse_tets(state);
  move_on(kind == ElementOrder::quadratic ? loads_on_cut_tets(forces) : loads_on_edges(forces), stop);
}

void FinerSolution::keep_free_pieces() {
  for (const std::vector<std::uint32_t>& corners : free_pieces(refined_.model.tets, refined_.held)) {
    std::vector<std::uint32_t> vertices = corners;
    for (const MidEdge& edge : refined_.edges)
      if (std::binary_search(corners.begin(), corners.end(), edge.a)) vertices.push_back(edge.vertex);
    Vectors places;
    for (const std::uint32_t v : vertices)
      places.push_back(refined_.model.rest_positions[v] + refined_.state.displacement[v]);
    free_.add(vertices, places);
  }
}

Vectors FinerSolution::forces_of_coarse_tets(const State& state) const {
  Vectors forces(model_.rest_positions.size(), Vector3d::Zero());
  for (const std::uint32_t t : refined_.tets) {
    const LinearTet corners = corners_of(model_, model_.tets[t]);
    const QuadraticTet ten(corners);
    const std::vector<PointStress> own = stresses_of(model_, state, t, QuadraticTet::points());
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      const Matrix3d first_piola = own[q].rotation * matrix_of(own[q].stress);
      if (kind_ == ElementOrder::quadratic) {
        add_forces(ten, model_.element(t), q, first_piola, forces);
      } else {
        for (std::size_t a = 0; a < 4; ++a)
          forces[model_.tets[t][a]] += 0.25 * corners.volume * first_piola * corners.gradients.col(static_cast<int>(a));
      }
    }
  }
  return forces;
}

void FinerSolution::move_on(const Vectors& loads, const std::stop_token& stop) {
  constexpr int kMostSteps = 40, kMostHalves = 10;
  constexpr double kShare = 1e-5;      // of the first step's work
  constexpr double kRounding = 1e-20;  // of the elastic energy
  const auto potential = [&] {
    double sum = 0;
    for (const Element& element : elements_) sum += element.energy;
    for (std::size_t v = 0; v < loads.size(); ++v)
      if (!refined_.held[v]) sum -= loads[v].dot(refined_.state.displacement[v]);
    return sum;
  };
  update_points();
  double elastic = 0;
  for (const Element& element : elements_) elastic += element.energy;
  double first = 0, before = potential();
  for (int step = 0; step < kMostSteps && !converged_; ++step) {
    const Vectors missing = residual(loads);
    Vectors delta;
    if (!solve(missing, stop, delta)) return;
    double work = 0;
    for (std::size_t v = 0; v < delta.size(); ++v) work += missing[v].dot(delta[v]);
    if (step == 0) first = work;
    const Vectors start = refined_.state.displacement;
    double length = 1;
    for (int half = 0; half < kMostHalves; ++half, length *= 0.5) {
      for (std::size_t v = 0; v < delta.size(); ++v) refined_.state.displacement[v] = start[v] + length * delta[v];
      update_points();
      if (potential() <= before) break;
    }
    before = potential();
    converged_ = length == 1 && work <= std::max(kShare * first, kRounding * elastic);
  }
}

void FinerSolution::make_elements() {
  const Model& fine = refined_.model;
  elements_.reserve(fine.tets.size());
  for (std::size_t s = 0; s < fine.tets.size(); ++s) {
    const Material& material = fine.materials[fine.tet_material[s]];
    Element element{QuadraticTet(corners_of(fine, fine.tets[s])),
                    {},
                    material.lame_mu(),
                    material.lame_lambda(),
                    volume_split(material).bulk,
                    0,
                    {}};
    const ElementVertices vertices = fine.element(s);
    std::copy(vertices.begin(), vertices.end(), element.vertices.begin());
    elements_.push_back(element);
  }
}

void FinerSolution::update_points() {
  for (std::size_t s = 0; s < elements_.size(); ++s) {
    Element& element = elements_[s];
    const VolumeSplit split = volume_split(refined_.model.materials[refined_.model.tet_material[s]]);
    const MaterialLaw& law = law_of(split.pointwise.model);
    QuadraticTet::Nodes nodes;
    for (std::size_t n = 0; n < 10; ++n) nodes[n] = refined_.state.displacement[element.vertices[n]];
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

Vectors FinerSolution::loads_on_cut_tets(const Vectors& coarse_forces) const {
  const Middles middles = middles_of(refined_.coarse_edges);
  Vectors on_corners = coarse_forces;
  restrict_to_corners(refined_.coarse_edges, on_corners);
  Vectors field = spread_field(model_, refined_.tets, middles, on_corners);
  continue_to(refined_.coarse_edges, field);
  field.resize(refined_.held.size());
  continue_to(refined_.edges, field);

  // What the coarse mesh's forces have beside the field, and then beside the tractions.
  Vectors result(refined_.held.size(), Vector3d::Zero());
  std::copy(coarse_forces.begin(), coarse_forces.end(), result.begin());
  const auto add_field = [&](const Model& model, std::size_t t, double factor) {
    const double mass = factor * model.materials[model.tet_material[t]].density * volume_of(model, t);
    const ElementVertices element = model.element(t);
    Vector3d at_centroid(0, 0, 0);
    for (std::size_t n = 0; n < 10; ++n) at_centroid += QuadraticTet::at_centroid(n) * field[element[n]];
    for (std::size_t n = 0; n < 10; ++n) {
      const double own = n < 4 ? QuadraticTet::kOwnCornerMass : QuadraticTet::kOwnMidEdgeMass;
      result[element[n]] +=
          mass * (own * field[element[n]] + QuadraticTet::kCentroidMass * QuadraticTet::at_centroid(n) * at_centroid);
    }
  };
  const auto add_tractions = [&](const std::vector<FaceLoad>& loads, double factor) {
    for (const FaceLoad& load : loads) {
      const std::array<Vector3d, 6> forces = forces_of(load);
      for (std::size_t i = 0; i < 6; ++i) result[load.vertices[i]] += factor * forces[i];
    }
  };
  for (const std::uint32_t t : refined_.tets) add_field(model_, t, -1);
  const std::vector<FaceLoad> loads = spread_on_faces(model_, refined_.tets, middles, refined_.held, result, false);
  add_tractions(loads, -1);
  add_tractions(on_finer_faces(loads, refined_.model, middles_of(refined_.edges)), 1);
  for (std::size_t s = 0; s < elements_.size(); ++s) add_field(refined_.model, s, 1);
  return result;
}

Vectors FinerSolution::loads_on_edges(const Vectors& coarse_forces) const {
  const Middles middles = middles_of(refined_.edges);
  Vectors result = coarse_forces;
  const Vectors field = spread_field(model_, refined_.tets, middles, coarse_forces);
  for (const std::uint32_t t : refined_.tets) {
    const double share = model_.materials[model_.tet_material[t]].density * volume_of(model_, t) / 4;
    for (const std::uint32_t v : model_.tets[t]) result[v] -= share * field[v];
  }
  const std::vector<FaceLoad> loads = spread_on_faces(model_, refined_.tets, middles, refined_.held, result, true);
  // On the functions 4 L_a L_b of edges. Those of the corners, L_a - sum_b 2 L_a L_b, have what is left.
  result = coarse_forces;
  result.resize(refined_.held.size(), Vector3d::Zero());
  for (std::size_t s = 0; s < elements_.size(); ++s) {
    const ElementVertices element = refined_.model.element(s);
    const double mass = model_.materials[model_.tet_material[refined_.tets[s]]].density * volume_of(refined_.model, s);
    Vector3d all = Vector3d::Zero();
    for (std::size_t a = 0; a < 4; ++a) all += field[element[a]];
    for (std::size_t m = 0; m < 6; ++m) {
      const auto [a, b] = kMidEdgeCorners[m];
      result[element[4 + m]] += mass / 30 * (all + field[element[a]] + field[element[b]]);
    }
  }
  for (const FaceLoad& load : loads) {
    const std::array<Vector3d, 6> forces = forces_of(load);
    for (std::size_t k = 3; k < 6; ++k) result[load.vertices[k]] += forces[k];
  }
  for (const MidEdge& edge : refined_.edges)
    for (const std::uint32_t v : {edge.a, edge.b}) result[v] -= 0.5 * result[edge.vertex];
  return result;
}

Vectors FinerSolution::residual(const Vectors& loads) const {
  Vectors result = loads;
  for (std::size_t s = 0; s < elements_.size(); ++s)
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      const PointState& point = elements_[s].points[q];
      add_forces(elements_[s].rest, refined_.model.element(s), q, -point.first_piola, result);
    }
  for (std::size_t v = 0; v < result.size(); ++v)
    if (refined_.held[v]) result[v].setZero();
  return result;
}

QuadraticTet::PointGradients FinerSolution::added_stresses(const Element& element, const Vectors& of) const {
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

Vectors FinerSolution::apply(const Vectors& to) const {
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
    if (refined_.held[v]) result[v].setZero();
  return result;
}

bool FinerSolution::solve(const Vectors& residual, const std::stop_token& stop, Vectors& delta) const {
  const std::size_t coarse = model_.rest_positions.size();
  std::vector<int> places(coarse, -1);
  int unknowns = 0;
  for (const std::uint32_t t : refined_.tets)
    for (const std::uint32_t v : model_.tets[t])
      if (!refined_.held[v] && places[v] < 0) places[v] = 3 * unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  const auto block_of = [](const Vector3d& a, const Vector3d& b, double mu, double lambda) -> Matrix3d {
    return mu * (a.dot(b) * Matrix3d::Identity() + b * a.transpose()) + lambda * a * b.transpose();
  };
  for (const std::uint32_t t : refined_.tets) {
    const Element& one = elements_[refined_.first_of[t]];
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

  std::vector<Matrix3d> linear(coarse, Matrix3d::Zero()), blocks(refined_.held.size(), Matrix3d::Zero());
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
    free_.remove_from(r);
    const Vectors balanced = r;
    restrict_to_corners(refined_.edges, r);
    Vectors middle(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(coarse)), rough = middle;
    restrict_to_corners(refined_.coarse_edges, rough);
    Eigen::VectorXd right(3 * unknowns);
    for (std::size_t v = 0; v < coarse; ++v)
      if (places[v] >= 0) right.segment<3>(places[v]) = rough[v];
    const Eigen::VectorXd solved = factorized.solve(right);
    for (std::size_t v = 0; v < coarse; ++v)
      if (places[v] >= 0) z[v] = solved.segment<3>(places[v]);
    continue_to(refined_.coarse_edges, z);
    for (std::size_t v = 0; v < coarse; ++v)
      if (!refined_.held[v]) z[v] += linear[v] * middle[v];
    continue_to(refined_.edges, z);
    for (std::size_t v = 0; v < z.size(); ++v) {
      if (refined_.held[v])
        z[v].setZero();
      else
        z[v] += blocks[v] * balanced[v];
    }
    free_.remove_from(z);
    return z;
  };
  return conjugate_gradients(
      residual, [&](const Vectors& to) { return apply(to); }, precondition, 1e-3 /* the next step finds the rest */,
      stop, delta);
}

std::vector<Vector3d> FinerSolution::displacements() const {
  const Vectors& all = refined_.state.displacement;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(model_.rest_positions.size())};
}

std::vector<FinerSolution::Point> FinerSolution::at(std::size_t tet) const {
  std::vector<Point> points;
  const ElementVertices whole = model_.element(tet);
  for (std::size_t s = refined_.first_of[tet]; s < refined_.first_of[tet] + refined_.parts; ++s) {
    const std::vector<PointStress> own = stresses_of(refined_.model, refined_.state, s, QuadraticTet::points());
    for (std::size_t q = 0; q < kPointsOfOne; ++q) {
      Point point{Vector4d::Zero(), own[q].stress, own[q].growth_gap};
      for (std::size_t c = 0; c < 4; ++c)
        point.barycentric +=
            (c == q ? QuadraticTet::kNear : QuadraticTet::kFar) * place_in(whole, refined_.model.tets[s][c]);
      points.push_back(point);
    }
  }
  return points;
}

}  // namespace fascia
