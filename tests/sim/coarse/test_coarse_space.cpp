// The coarse space of the two-level method and its matrix: properties that hold on any mesh.
// Covers: coarse_gather, coarse_matrix
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "sim/coarse/coarse_gather.h"
#include "sim/coarse/coarse_matrix.h"
#include "sim/coarse/coarse_space.h"
#include "sim/material/symmetric_eigen.h"
#include "sim/ordering/mesh_order.h"
#include "sim/reference/elastic_system.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

const Material kTissue{1e5, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff};

Model beam() {
  return make_model(make_box(16, 4, 4, {0.4, 0.1, 0.1}), kTissue, [](const Vector3d& x) { return x.x() < 1e-9; });
}

// Two bars side by side, closer to each other than a lattice cell is wide; with `joined` connected at one end to a
// hairpin.
Model two_bars(bool joined) {
  TetMesh mesh;
  const TetMesh box = make_box(24, 9, 2, {0.6, 0.225, 0.05});
  // Cells of the middle third are left out, except for the last ones of a hairpin.
  for (const Tet& tet : box.tets) {
    Vector3d center = Vector3d::Zero();
    for (const std::uint32_t v : tet) center += box.positions[v] / 4;
    const bool slit = center.y() > 0.1 && center.y() < 0.125;
    if (!slit || (joined && center.x() > 0.55)) mesh.tets.push_back(tet);
  }
  mesh.positions = box.positions;
  mesh.regions.assign(mesh.tets.size(), 0);
  return make_model(mesh, kTissue, [](const Vector3d&) { return false; });
}

std::set<std::uint32_t> nodes_where(const Model& model, const CoarseSpace& space,
                                    const std::function<bool(const Vector3d&)>& where) {
  std::set<std::uint32_t> nodes;
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    if (where(model.rest_positions[v]))
      nodes.insert(space.node.begin() + space.begin[v], space.node.begin() + space.begin[v + 1]);
  return nodes;
}

std::size_t common(const std::set<std::uint32_t>& a, const std::set<std::uint32_t>& b) {
  std::size_t count = 0;
  for (const std::uint32_t node : a) count += b.count(node);
  return count;
}

}  // namespace

TEST_CASE("coarse weights of a free vertex sum to one, constrained vertices have none") {
  const Model model = beam();
  const std::uint32_t target = GENERATE(8u, 30u, 80u);
  const CoarseSpace space = make_coarse_space(model, target);
  CAPTURE(target, space.node_count);
  CHECK(space.node_count >= target / 2);
  CHECK(space.node_count <= 2 * target);
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v) {
    double sum = 0;
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) sum += space.weight[k];
    CAPTURE(v);
    REQUIRE(sum == (held[v] ? Approx(0).margin(0) : Approx(1)));
  }
}

TEST_CASE("a mesh of a few vertices needs no coarse space") {
  const Model model = make_model(make_box(1, 1, 1, {1, 1, 1}), kTissue, [](const Vector3d&) { return false; });
  CHECK(make_coarse_space(model, 30).node_count == 0);
}

TEST_CASE("parts that are near in space but not in the mesh share no coarse node") {
  const bool joined = GENERATE(false, true);
  CAPTURE(joined);
  const Model model = two_bars(joined);
  const CoarseSpace space = make_coarse_space(model, 40);
  REQUIRE(space.node_count > 10);
  // Farther from the bend of the hairpin than a lattice cell.
  const auto lower = nodes_where(model, space, [](const Vector3d& x) { return x.x() < 0.35 && x.y() < 0.11; });
  const auto upper = nodes_where(model, space, [](const Vector3d& x) { return x.x() < 0.35 && x.y() > 0.115; });
  CHECK(lower.size() > 3);
  CHECK(upper.size() > 3);
  CHECK(common(lower, upper) == 0);
  const auto lower_end = nodes_where(model, space, [](const Vector3d& x) { return x.x() > 0.5 && x.y() < 0.11; });
  const auto upper_end = nodes_where(model, space, [](const Vector3d& x) { return x.x() > 0.5 && x.y() > 0.115; });
  CHECK((common(lower_end, upper_end) > 0) == joined);
}

TEST_CASE("the gathered mean deformation gradient of an affine motion is that motion's") {
  const Model model = beam();
  const CoarseSpace space = make_coarse_space(model, 40);
  const CoarseGather gather = make_coarse_gather(model, space);
  Matrix3d f;
  f << 1.2, -0.4, 0.1, 0.5, 0.9, -0.2, 0.05, 0.3, 1.1;
  for (std::uint32_t j = 0; j < space.node_count; ++j) {
    Matrix3d m = Matrix3d::Identity();
    for (std::uint32_t k = gather.begin[j]; k < gather.begin[j + 1]; ++k) {
      const Vector3d& x = model.rest_positions[gather.vertex[k]];
      m += (f * x - x) * gather.gradient[k].transpose();
    }
    CAPTURE(j);
    REQUIRE((m - f).norm() < 1e-12);
  }
}

TEST_CASE("the transpose of a coarse space has the same entries") {
  const CoarseSpace space = make_coarse_space(beam(), 40);
  const CoarseTranspose transposed = transpose(space);
  REQUIRE(transposed.begin.size() == space.node_count + 1);
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> entries;  // of vertex and node
  for (std::uint32_t j = 0; j < space.node_count; ++j)
    for (std::uint32_t k = transposed.begin[j]; k < transposed.begin[j + 1]; ++k)
      entries[{transposed.vertex[k], j}] = transposed.weight[k];
  CHECK(entries.size() == space.weight.size());
  for (std::uint32_t v = 0; v + 1 < space.begin.size(); ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) {
      CAPTURE(v, space.node[k]);
      REQUIRE(entries.at({v, space.node[k]}) == space.weight[k]);
    }
}

TEST_CASE("coarse nodes are in the order of their vertices, with equal numbers of entries adjacent") {
  const Model model =
      make_model(make_box(40, 8, 8, {1, 0.2, 0.2}), kTissue, [](const Vector3d& x) { return x.x() < 1e-9; });
  const CoarseSpace space = make_coarse_space(placed(model, mesh_order_of(model)), 250);
  const CoarseTranspose columns = transpose(space);
  REQUIRE(space.node_count > 200);
  const auto entries = [&](std::uint32_t j) { return columns.begin[j + 1] - columns.begin[j]; };
  std::size_t sum = 0, in_step = 0;  // for groups of eight invocations
  for (std::uint32_t first = 0; first < space.node_count; first += 8) {
    std::uint32_t most = 0;
    for (std::uint32_t j = first; j < std::min(first + 8, space.node_count); ++j) {
      sum += entries(j);
      most = std::max(most, entries(j));
    }
    in_step += 8 * most;
  }
  CAPTURE(sum, in_step);
  CHECK(in_step < 1.15 * static_cast<double>(sum));  // 1.56 in the order of the lattice

  // The first half of the nodes should need few vertices of the second half: half of them in a random order, few also
  // in the lattice's.
  const auto half = static_cast<std::uint32_t>(space.begin.size() / 2);
  std::size_t apart = 0;
  for (std::uint32_t j = 0; j < space.node_count; ++j)
    for (std::uint32_t k = columns.begin[j]; k < columns.begin[j + 1]; ++k)
      apart += (columns.vertex[k] < half) != (2 * j < space.node_count);
  CAPTURE(apart);
  CHECK(apart < 0.15 * static_cast<double>(sum));
}

TEST_CASE("the coarse matrix is the Hessian at rest projected onto the coarse space, and its inverse inverts it") {
  Model model = beam();
  model.materials[0].damping = GENERATE(0.0, 0.01);
  const double h = 1.0 / 60;
  const CoarseSpace space = make_coarse_space(model, 30);
  const Eigen::MatrixXd a = coarse_matrix(model, space, h);
  REQUIRE(a.rows() == 3 * space.node_count);

  const reference::ElasticSystem system(model);
  const auto size = static_cast<Eigen::Index>(3 * model.rest_positions.size());
  Eigen::MatrixXd p = Eigen::MatrixXd::Zero(size, a.cols());
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k)
      for (Eigen::Index r = 0; r < 3; ++r)
        p(static_cast<Eigen::Index>(3 * v) + r, 3 * space.node[k] + r) = space.weight[k];
  const std::vector<double> masses = lumped_masses(model);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(size);
  const reference::ViscousStep viscous{system.strains(rest), h};
  Eigen::MatrixXd expected(a.rows(), a.cols());
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    Eigen::VectorXd column =
        h * h * system.hessian_times(rest, system.viscous() ? viscous : reference::ViscousStep{}, p.col(c));
    for (Eigen::Index i = 0; i < size; ++i) column[i] += masses[static_cast<std::size_t>(i / 3)] * p(i, c);
    expected.col(c) = p.transpose() * column;
  }
  CAPTURE((a - expected).norm() / expected.norm());
  CHECK((a - expected).norm() < 1e-12 * expected.norm());
  const Eigen::MatrixXd identity = a * coarse_inverse(a).cast<double>();
  // The diagonal is raised by 1e-7 and the inverse is rounded to float32, both times the condition of the matrix.
  const double condition = a.norm() * coarse_inverse(a).cast<double>().norm();
  CHECK((identity - Eigen::MatrixXd::Identity(a.rows(), a.cols())).norm() < 4e-7 * condition);
}

TEST_CASE("the inverse with springs is that of the matrix with springs") {
  const Model model = beam();
  const double h = 1.0 / 60;
  const CoarseSpace space = make_coarse_space(model, 40);
  std::vector<std::uint32_t> free;
  for (std::uint32_t v = 0; v + 1 < space.begin.size(); ++v)
    if (space.begin[v + 1] > space.begin[v]) free.push_back(v);
  const std::vector<VertexStiffness> springs{{free[10], 300}, {free[free.size() / 2], 500}, {free.back(), 400}};
  Eigen::MatrixXd a = coarse_matrix(model, space, h);
  const Eigen::MatrixXf inverse = coarse_inverse(a), held = with_stiffness(inverse, space, springs, h);
  for (const VertexStiffness& s : springs)
    for (std::uint32_t k = space.begin[s.vertex]; k < space.begin[s.vertex + 1]; ++k)
      for (std::uint32_t l = space.begin[s.vertex]; l < space.begin[s.vertex + 1]; ++l)
        a.block<3, 3>(3 * space.node[k], 3 * space.node[l]).diagonal().array() +=
            h * h * s.stiffness * space.weight[k] * space.weight[l];
  const Eigen::MatrixXf expected = coarse_inverse(a);
  const float error = (held - expected).norm() / expected.norm(), change = (held - inverse).norm() / expected.norm();
  CAPTURE(error, change);
  CHECK(change > 0.1f);  // the springs have an effect
  CHECK(error < 1e-4f);
  CHECK(with_stiffness(inverse, space, {}, h) == inverse);
  CHECK(with_stiffness(inverse, space, {{free[10], 0}}, h) == inverse);
}

TEST_CASE("an inclusion of another material has coarse nodes of its own") {
  Model model =
      make_model(make_box(12, 12, 12, {0.12, 0.12, 0.12}), kTissue, [](const Vector3d& x) { return x.y() < 1e-9; });
  const auto inside = [](const Vector3d& x) { return (x - Vector3d(0.06, 0.06, 0.06)).cwiseAbs().maxCoeff() < 0.0301; };
  model.materials.push_back(kTissue);
  model.materials[1].young_modulus *= 1000;
  for (std::size_t t = 0; t < model.tets.size(); ++t) {
    Vector3d center = Vector3d::Zero();
    for (const std::uint32_t v : model.tets[t]) center += model.rest_positions[v] / 4;
    model.tet_material[t] = inside(center) ? 1 : 0;
  }
  const CoarseSpace space = make_coarse_space(model, 120);
  const auto inner = nodes_where(model, space, inside);
  const auto outer = nodes_where(model, space, [&](const Vector3d& x) { return !inside(x); });
  CAPTURE(space.node_count, inner.size(), outer.size());
  CHECK(inner.size() >= 8);  // enough to rotate as a whole
  CHECK(outer.size() >= 40);
  CHECK(common(inner, outer) == 0);
}

TEST_CASE("very many bodies do not make the coarse problem large") {
  TetMesh mesh;
  const TetMesh box = make_box(3, 3, 3, {0.01, 0.01, 0.01});
  for (int k = 0; k < 300; ++k) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vector3d& x : box.positions) mesh.positions.push_back(x + 0.02 * Vector3d(k % 10, k / 10 % 10, k / 100));
    for (const Tet& tet : box.tets) mesh.tets.push_back({tet[0] + base, tet[1] + base, tet[2] + base, tet[3] + base});
  }
  mesh.regions.assign(mesh.tets.size(), 0);
  const Model model = make_model(mesh, kTissue, [](const Vector3d&) { return false; });
  const std::uint32_t target = coarse_node_target(model.tets.size());
  const CoarseSpace space = make_coarse_space(model, target);
  CAPTURE(target, space.node_count);
  CHECK(space.node_count > target / 2);
  CHECK(space.node_count <= target + target / 2);
  for (std::size_t v = 0; v < model.rest_positions.size(); ++v) {
    double sum = 0;
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k) sum += space.weight[k];
    CAPTURE(v);
    REQUIRE((sum == 0 || sum == Approx(1)));
  }
}

TEST_CASE("a coarse mesh beside a fine one has no more functions than it can carry") {
  // As fine as the second bar, the lattice would have several nodes between two layers of vertices of the first one.
  TetMesh mesh = make_box(6, 4, 4, {0.3, 0.1, 0.1});
  const TetMesh fine = make_box(12, 8, 8, {0.3, 0.1, 0.1});
  const auto offset = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vector3d& x : fine.positions) mesh.positions.push_back(x + Vector3d(0, 0.3, 0));
  for (Tet tet : fine.tets) {
    for (std::uint32_t& v : tet) v += offset;
    mesh.tets.push_back(tet);
  }
  mesh.regions.assign(mesh.tets.size(), 0);
  const Model model = make_model(mesh, kTissue, [](const Vector3d& x) { return x.x() < 1e-9; });
  const CoarseSpace space = make_coarse_space(model, coarse_node_target(model.tets.size()));
  // The functions of the first bar are linearly independent: their Gram matrix is well conditioned.
  const std::set<std::uint32_t> nodes = nodes_where(model, space, [](const Vector3d& x) { return x.y() < 0.2; });
  std::map<std::uint32_t, Eigen::Index> number;
  for (const std::uint32_t node : nodes) number.emplace(node, static_cast<Eigen::Index>(number.size()));
  const auto n = static_cast<Eigen::Index>(nodes.size());
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(n, n);
  for (std::uint32_t v = 0; v < offset; ++v)
    for (std::uint32_t k = space.begin[v]; k < space.begin[v + 1]; ++k)
      for (std::uint32_t l = space.begin[v]; l < space.begin[v + 1]; ++l)
        gram(number.at(space.node[k]), number.at(space.node[l])) += space.weight[k] * space.weight[l];
  const Eigen::VectorXd values = symmetric_eigen(gram).values;
  CAPTURE(n, values.minCoeff(), values.maxCoeff());
  CHECK(n > 20);
  CHECK(values.minCoeff() > 1e-3 * values.maxCoeff());
}
