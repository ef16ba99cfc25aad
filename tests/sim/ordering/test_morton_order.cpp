// The tets that a solver leaves out, and the order of the others.
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "sim/ordering/morton_order.h"
#include "tests/support/models.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Model box(const std::function<bool(const Eigen::Vector3d&)>& is_fixed) {
  return make_model(make_box(6, 3, 3, {0.6, 0.3, 0.3}), {1e4, 0.3, 1000, 0, MaterialModel::st_venant_kirchhoff},
                    is_fixed);
}

}  // namespace

TEST_CASE("tets between fixed vertices are left out, all others occur once") {
  const Model model = box([](const Eigen::Vector3d& x) { return x.x() < 0.15; });
  std::vector<std::uint32_t> solved = solved_tets(model);
  std::sort(solved.begin(), solved.end());
  std::vector<std::uint32_t> expected;
  for (std::uint32_t t = 0; t < model.tets.size(); ++t) {
    bool moves = false;
    for (const std::uint32_t v : model.tets[t]) moves |= model.rest_positions[v].x() >= 0.15;
    if (moves) expected.push_back(t);
  }
  CHECK(solved == expected);
  CHECK(solved.size() == model.tets.size() - 6 * 9);  // the first layer of cells
}

TEST_CASE("tets that a prescribed motion deforms are kept") {
  Model model = box([](const Eigen::Vector3d&) { return false; });
  Motion motion;
  for (std::uint32_t v = 0; v < model.rest_positions.size(); ++v) motion.vertices.push_back(v);
  model.motions.push_back(motion);
  CHECK(solved_tets(model).size() == model.tets.size());
}

TEST_CASE("neighbors are close in memory, for any order of the file") {
  Model model = box([](const Eigen::Vector3d&) { return false; });
  const auto jumps = [&](const std::vector<std::uint32_t>& order) {
    double sum = 0;
    for (std::size_t k = 1; k < order.size(); ++k)
      sum += (model.rest_positions[model.tets[order[k]][0]] - model.rest_positions[model.tets[order[k - 1]][0]]).norm();
    return sum;
  };
  const double sorted = jumps(solved_tets(model));
  std::mt19937 random(7);
  std::shuffle(model.tets.begin(), model.tets.end(), random);
  std::vector<std::uint32_t> file_order(model.tets.size());
  for (std::uint32_t t = 0; t < file_order.size(); ++t) file_order[t] = t;
  CHECK(jumps(solved_tets(model)) < 1.1 * sorted);
  CHECK(jumps(solved_tets(model)) < 0.5 * jumps(file_order));
}
