// Covers: sim/contact/tissue/tissue_surface
// Covers: pair_candidates, pair_guards
#include "sim/contact/pair_search.h"

#include <catch2/catch.hpp>

#include "sim/contact/tissue/penetration.h"
#include "tests/sim/reference/box_model.h"
#include "tests/support/touching_bodies.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr double kSize = 0.2;
Model box(int cells = 4) { return test::box_model(cells, cells, cells, {kSize, kSize, kSize}, test::soft(1e5)); }

std::vector<Vector3d> nowhere(const Model& model) { return {model.rest_positions.size(), Vector3d::Zero()}; }

// The second body alone moves by `way` in the step.
std::vector<PairRow> found(PairSearch& search, const Model& model, const Vector3d& way) {
  std::vector<Vector3d> end = nowhere(model);
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v) end[v] = way;
  return search.find(nowhere(model), end, {});
}

TEST_CASE("pairs of two boxes have gaps along outward normals, and weights that add up to nothing", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize + 0.003, 0.01}), "upper");
  PairSearch search(model);
  const std::vector<PairRow> rows = found(search, model, {0, 0, 0});
  // The vertices of the upper box's bottom above the lower one, and those of the lower one's top below the upper one
  CHECK(rows.size() > 20);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const PairRow& row = rows[k];
    CAPTURE(k, row.normal.transpose(), row.gap, row.slot, search.skin());
    CHECK(std::abs(row.normal.y()) == Approx(1));
    CHECK(row.normal.y() * (row.bodies[0] == 1 ? 1 : -1) > 0);
    CHECK(row.weights[0] + row.weights[1] + row.weights[2] + row.weights[3] == Approx(0).margin(1e-12));
    CHECK(row.gap == Approx(0.003 - std::min(search.skin(), 0.003 + 0.25 * search.skin())).margin(1e-12));
    CHECK(row.stiffness > 0);
    if (k > 0) CHECK(row.slot > rows[k - 1].slot);
    CHECK(row.slot < search.slot_count());
  }
}

TEST_CASE("pairs beside the ends of edges are stiff where softnesses differ, and say which sides vertices are on",
          "[contact]") {
  Model lower = box(), upper = box(3);
  for (Model* model : {&lower, &upper}) {
    model->materials.push_back(test::soft(1e7));
    model->material_names.push_back("hard");
    for (std::size_t t = 0; t < model->tets.size(); ++t) model->tet_material[t] = t % 3 == 0;
  }
  // Turned, so that edges cross, and pressed flat by what every pair remembers
  for (Vector3d& x : upper.rest_positions) x = Eigen::AngleAxisd(0.4, Vector3d::UnitY()) * x;
  std::size_t beside = 0;
  for (int k = 0; k < 8; ++k) {
    const Model model = test::beside(lower, test::moved(upper, {0.02 + 0.005 * k, kSize + 0.003, 0.03}), "upper");
    PairSearch search(model);
    ContactMemory memory(search.row_count());
    for (std::uint32_t slot = 0; slot < search.slot_count(); ++slot) memory[force_row(slot)].normal = 1;
    for (const PairRow& row : search.find(nowhere(model), nowhere(model), memory)) {
      const auto edges = std::count(row.sides.begin(), row.sides.end(), 1) == 2;
      std::array<double, 2> sums{};
      bool outside = false;
      for (std::size_t v = 0; v < 4; ++v) {
        sums[row.sides[v]] += row.weights[v];
        outside |= (row.sides[v] == 0) != (row.weights[v] > 0) && row.weights[v] != 0;
        const bool of_upper = row.vertices[v] >= model.bodies[1].vertex_begin;
        CHECK(row.bodies[row.sides[v]] == (of_upper ? 1u : 0u));
      }
      CAPTURE(k, row.slot, edges, row.stiffness, row.weights);
      CHECK(sums[0] == Approx(1));
      CHECK(sums[1] == Approx(-1));
      CHECK(row.stiffness > 0);
      beside += outside;
    }
  }
  CHECK(beside > 10);
}

// Their rounding goes through each other in every step: taken back each time, such bodies stood still while their
// forces grew, and flew apart in the end.
TEST_CASE("faces that begin on each other without a gap do not count as having gone through", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize, 0.01}), "upper");
  PairSearch search(model);
  CHECK(found(search, model, {0, 0, 0}).size() > 20);
  test::Random random(6);
  std::vector<Vector3d> end = nowhere(model);
  for (Vector3d& u : end) u = 1e-4 * kSize * random.vector();
  search.misses(end);
  CHECK_FALSE(search.cuts());
}

TEST_CASE("what is far apart has no pairs, and what will meet within the step has them", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize + 0.15, 0.01}), "upper");
  PairSearch search(model);
  CHECK(found(search, model, {0, 0, 0}).empty());
  CHECK_FALSE(search.sees_near());
  CHECK(found(search, model, {0, -0.05, 0}).empty());
  const std::size_t met = found(search, model, {0, -0.3, 0}).size();
  CHECK(met > 20);
  // Also where it comes down beside where it started
  const Model shifted = test::beside(box(), test::moved(box(3), {0.32, kSize + 0.15, 0.01}), "upper");
  PairSearch other(shifted);
  CHECK(found(other, shifted, {0, -0.3, 0}).empty());
  CHECK(found(other, shifted, {-0.4, -0.2, 0}).size() > 20);
}

// A box whose front is `along` the lower one and leans forward a little, so that the normals of its front and of the
// lower box's top are opposed by what bending tissue has. `above`: of its front's edge.
Model leaning_box(double along, double above) {
  constexpr double lean = 0.01;
  Model upper = test::moved(box(3), {along - kSize, kSize + above, 0.013});
  const Vector3d edge = {along, kSize + above, 0};
  for (Vector3d& x : upper.rest_positions) {
    const Vector3d from = x - edge;
    x = edge + Vector3d(from.x() + lean * from.y(), from.y() - lean * from.x(), from.z());
  }
  return test::beside(box(), upper, "upper");
}

TEST_CASE("a box that slides over another one is not pressed back by the vertices that its front passes", "[contact]") {
  const double way = 0.02, skin = PairSearch(leaning_box(0.05, 0)).skin();
  std::size_t passed = 0;
  for (const double above : {1.0, 0.9, 0.7})  // of the skin
    for (int k = 0; k < 60; ++k) {
      const Model model = leaning_box(0.05 + 0.001 * k, above * skin);
      PairSearch search(model);
      for (const PairRow& row : found(search, model, {way, 0, 0})) {
        const double moved = (row.bodies[0] == 1 ? way : -way) * row.normal.x(), gap = row.gap + moved;
        CAPTURE(above, k, row.normal.transpose(), row.gap, gap, row.vertices[0]);
        CHECK((gap > -0.1 * skin || std::abs(row.normal.x()) < 0.3));
        passed += std::abs(row.normal.y()) > 0.9;
      }
    }
  CHECK(passed > 1000);
}

// It is looked for where its fall leads, into the vertices ahead, which the contact beneath it prevents.
TEST_CASE("a step is solved again where the normal at an edge stops what slides around it", "[contact]") {
  const double way = 0.02, skin = PairSearch(leaning_box(0.05, 0)).skin();
  int again = 0;
  for (int k = 0; k < 60; ++k) {
    const Model model = leaning_box(0.05 + 0.001 * k, 0.95 * skin);
    PairSearch search(model);
    const auto slid = [&](const Vector3d& by) {
      std::vector<Vector3d> end = nowhere(model);
      for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v) end[v] = by;
      return end;
    };
    found(search, model, {way, -0.8 * skin, 0});
    if (!search.misses(slid({way, 0, 0}))) continue;
    ++again;
    for (const PairRow& row : search.find_again()) {
      CAPTURE(k, row.normal.transpose(), row.gap, row.vertices[0]);
      CHECK((row.gap + (row.bodies[0] == 1 ? way : -way) * row.normal.x() > -0.1 * skin ||
             std::abs(row.normal.x()) < 0.3));
    }
    CHECK_FALSE(search.misses(slid({way, 0, 0})));
  }
  CHECK(again > 5);
}

TEST_CASE("crossing edges of two boxes are a pair", "[contact]") {
  // Two boxes, each turned by 45 degrees about an axis of its own, so that an edge of one lies across an edge of the
  // other
  Model lower = box(1), upper = box(1);
  const Eigen::Matrix3d about_z(Eigen::AngleAxisd(0.785398, Vector3d::UnitZ())),
      about_x(Eigen::AngleAxisd(0.785398, Vector3d::UnitX()));
  const Vector3d middle = Vector3d::Constant(kSize / 2);
  const double height = kSize * std::sqrt(2.0);
  for (Vector3d& x : lower.rest_positions) x = about_z * (x - middle);
  for (Vector3d& x : upper.rest_positions) x = about_x * (x - middle) + Vector3d(0.013, height + 1e-3, 0.017);
  const Model model = test::beside(lower, upper, "upper");
  PairSearch search(model);
  std::vector<PairRow> rows = found(search, model, {0, 0, 0});
  std::erase_if(rows, [](const PairRow& row) { return row.gap > 0.01; });  // of vertices farther down the slopes
  REQUIRE(rows.size() == 1);
  CAPTURE(rows[0].normal.transpose(), rows[0].weights[0], rows[0].weights[1], rows[0].weights[2], rows[0].weights[3]);
  CHECK(std::abs(rows[0].normal.y()) == Approx(1));
  int above = 0;
  for (const double weight : rows[0].weights) above += weight > 0 ? 1 : 0;
  CHECK(above == 2);
}

TEST_CASE("a body at rest does not touch itself, however thin", "[contact]") {
  Model plate = test::box_model(40, 1, 20, {0.2, 0.004, 0.2}, test::soft(1e5));
  plate.bodies = {{"plate",
                   0,
                   static_cast<std::uint32_t>(plate.rest_positions.size()),
                   0,
                   static_cast<std::uint32_t>(plate.tets.size()),
                   0,
                   1,
                   {}}};
  plate.contact.self = true;
  PairSearch search(plate);
  REQUIRE_FALSE(search.empty());
  CHECK(search.find(nowhere(plate), nowhere(plate), {}).empty());
  // Rolled up until its ends overlap
  std::vector<Vector3d> rolled;
  const double radius = 0.2 / 6.0;
  for (const Vector3d& x : plate.rest_positions) {
    const double angle = 1.2 * x.x() / radius, r = radius - x.y() - 1e-3 * angle;
    rolled.push_back(Vector3d(r * std::sin(angle), radius - r * std::cos(angle), x.z()) - x);
  }
  CHECK(search.find(rolled, rolled, {}).size() > 5);
}

TEST_CASE("models whose tissue touches nothing have no pairs", "[contact]") {
  const Model alone = box();
  CHECK(PairSearch(alone).empty());
  Model apart = test::beside(box(), test::moved(box(), {0, kSize, 0}), "upper");
  apart.contact.bodies = false;
  PairSearch search(apart);
  CHECK(search.empty());
  CHECK(search.find(nowhere(apart), nowhere(apart), {}).empty());
}

TEST_CASE("a result that goes through other tissue is told from one that does not", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize + 0.003, 0.01}), "upper");
  PairSearch search(model);
  found(search, model, {0, 0, 0});
  std::vector<Vector3d> end = nowhere(model);
  CHECK_FALSE(search.misses(end));
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v) end[v] = {0, -0.01, 0};
  CHECK(search.misses(end));
}

// Of the first solution of a step, which moves the upper box through the top of the lower one.
TEST_CASE("what a solution leads through each other is guarded until it no longer presses", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize + 0.01, 0.01}), "upper");
  PairSearch search(model);
  std::vector<Vector3d> end = nowhere(model);
  CHECK_FALSE(search.misses(end));
  // Found without any way, then solved with one that is sideways at first sight: no pair has seen it.
  found(search, model, {0, 0, 0});
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v) end[v] = {0, -0.03, 0};
  REQUIRE(search.misses(end));
  const std::vector<PairRow> rows = search.find_again();
  double raised = 0;
  for (const PairRow& row : rows) {
    raised += row.before;
    CAPTURE(row.slot, row.normal.transpose(), row.before);
    CHECK(row.normal.y() * (row.bodies[0] == 1 ? 1 : -1) > 0.5);  // edges of the rims meet between two sides
    CHECK(row.slot < search.slot_count());
  }
  CHECK(raised > 0);  // pairs that were pressed in press harder
  end = nowhere(model);
  CHECK_FALSE(search.misses(end));
}

// A solution that no search has mended: the upper box sinks in by 7 mm, and both move sideways.
TEST_CASE("edges of a body that begins in another one may leave", "[contact]") {
  const Model model = test::beside(box(), test::moved(box(3), {0.02, kSize - 0.01, 0.013}), "upper");
  PairSearch search(model);
  found(search, model, {0, 0, 0});
  std::vector<Vector3d> end = nowhere(model);  // one side is out, the other is still in
  for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v)
    end[v].y() = 0.1 * (model.rest_positions[v].x() - 0.02);
  search.misses(end);
  CHECK_FALSE(search.cuts());
}

TEST_CASE("bodies that a solution leaves in each other are taken back, with their momentum", "[contact]") {
  Model model = test::beside(box(), test::moved(box(3), {0.02, kSize + 0.003, 0.01}), "upper");
  const std::vector<double> masses = lumped_masses(model);
  const auto moved = [&](const Vector3d& lower, const Vector3d& upper) {
    std::vector<Vector3d> end(model.rest_positions.size(), lower);
    for (std::uint32_t v = model.bodies[1].vertex_begin; v < end.size(); ++v) end[v] = upper;
    return end;
  };
  const auto moment = [&](const std::vector<Vector3d>& way) {
    Vector3d sum(0, 0, 0);
    for (std::size_t v = 0; v < way.size(); ++v) sum += masses[v] * way[v];
    return sum;
  };
  const std::vector<Vector3d> start = nowhere(model), apart = moved({0.01, 0, 0}, {0.01, 0.01, 0}),
                              through = moved({0.01, 0, 0}, {0.03, -0.01, 0});
  PairSearch search(model);
  found(search, model, {0, 0, 0});
  REQUIRE(search.misses(through));
  CHECK(search.cuts());
  CHECK_FALSE(search.taken_back(start, apart, masses));
  const auto back = search.taken_back(start, through, masses);
  REQUIRE(back);
  CHECK_FALSE(penetrating_triangles(model, *back));
  CHECK((moment(*back) - moment(through)).norm() < 1e-12 * moment(through).norm());
  const auto angular = [&](const std::vector<Vector3d>& way) {  // about the center of mass
    Vector3d center(0, 0, 0), sum(0, 0, 0);
    double mass = 0;
    for (std::size_t v = 0; v < way.size(); ++v) {
      mass += masses[v];
      center += masses[v] * model.rest_positions[v];
    }
    for (std::size_t v = 0; v < way.size(); ++v)
      sum += masses[v] * (model.rest_positions[v] - center / mass).cross(way[v]);
    return sum;
  };
  CAPTURE(angular(*back).transpose(), angular(through).transpose());  // turns are finite
  CHECK((angular(*back) - angular(through)).norm() < 0.05 * angular(through).norm());

  for (std::uint32_t v = 0; v < model.bodies[1].vertex_begin; ++v) model.fixed.push_back(v);
  PairSearch held(model);
  found(held, model, {0, 0, 0});
  const auto stopped = held.taken_back(start, moved({0, 0, 0}, {0.03, -0.01, 0}), masses);
  REQUIRE(stopped);
  CHECK(stopped->front().norm() == 0);
  CHECK((stopped->back() - 0.25 * Vector3d(0.03, -0.01, 0)).norm() < 1e-12);

  // A script moves the lower box up by 10 mm, which no way of the upper one makes up for.
  PairSearch scripted(model);
  found(scripted, model, {0, 0, 0});
  CHECK_FALSE(scripted.taken_back(start, moved({0, 0.01, 0}, {0, 0, 0}), masses));
}

// The same pairs, in whatever order their distances are now.
TEST_CASE("pairs that pressed keep their slots where others are hardly nearer", "[contact]") {
  Model upper = box(3);
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.3, Vector3d::UnitY()));
  for (Vector3d& x : upper.rest_positions) x = turn * x;
  const Model model = test::beside(box(), test::moved(upper, {-0.03, kSize + 0.003, 0.01}), "upper");
  PairSearch search(model);
  test::Random random(4);
  const auto shaken = [&] {
    std::vector<Vector3d> places;
    for (std::size_t v = 0; v < model.rest_positions.size(); ++v)
      places.push_back(0.04 * search.skin() * random.vector());
    return places;
  };
  std::vector<Vector3d> now = shaken();
  const std::vector<PairRow> first = search.find(now, now, {});
  ContactMemory memory(search.row_count());
  std::size_t crossings = 0;
  for (const PairRow& row : first) {
    memory[force_row(row.slot)].normal = 1;
    met_in(memory[met_row(row.slot)], row.slot) = row.met;
    crossings += std::count_if(row.weights.begin(), row.weights.end(), [](double w) { return w < 0; }) == 2;
  }
  CHECK(crossings > 5);
  int kept = 0, changed_without_memory = 0;
  for (int again = 0; again < 5; ++again) {
    now = shaken();
    for (const bool remembers : {true, false}) {
      const std::vector<PairRow> rows = search.find(now, now, remembers ? memory : ContactMemory());
      for (const PairRow& row : first)
        for (const PairRow& other : rows) {
          if (other.slot != row.slot) continue;
          CAPTURE(again, row.slot, row.met, other.met);
          if (remembers) CHECK(other.met == row.met);
          if (remembers) ++kept;
          if (!remembers && other.met != row.met) ++changed_without_memory;
        }
    }
  }
  CHECK(kept > 4 * static_cast<int>(first.size()));
  CHECK(changed_without_memory > 0);
}

TEST_CASE("an edge that goes through a face meets it from where it came", "[contact]") {
  // Two tets; an edge of the upper one goes down through the top of the lower one, at any angle of normals.
  TetMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0.2, -1, 0.2}};
  mesh.tets = {{0, 1, 2, 3}};
  const auto tet = [&] { return test::make_model(mesh, test::soft(1e5), [](const Vector3d&) { return false; }); };
  Model lower = tet();
  if (signed_volume6(mesh.positions[0], mesh.positions[1], mesh.positions[2], mesh.positions[3]) < 0) {
    std::swap(mesh.tets[0][0], mesh.tets[0][1]);
    lower = tet();
  }
  const Model model = test::beside(lower, test::moved(lower, {0.05, 1.3, 0.05}), "upper");
  PairSearch search(model);
  std::vector<Vector3d> end = nowhere(model);
  search.find(end, end, {});
  for (std::uint32_t v = 4; v < 8; ++v) end[v] = {0, -0.5, 0};
  search.find(nowhere(model), end, {});
  search.misses(end);
  const std::vector<PairRow> rows = search.find_again();
  REQUIRE_FALSE(rows.empty());
  for (const PairRow& row : rows) {
    CAPTURE(row.normal.transpose(), row.bodies[0], row.vertices[0]);
    CHECK(row.normal.y() * (row.bodies[0] == 1 ? 1 : -1) > 0);
  }
}

}  // namespace
}  // namespace fascia
