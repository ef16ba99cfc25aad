// Random scenes with all valid values: written and read back they are the same, to the bit.
#include <array>
#include <cstring>
#include <random>

#include "sim/material/tissue_looks.h"
#include "sim/scene/scene_write.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  bool chance(int one_in = 2) { return random_() % static_cast<unsigned>(one_in) == 0; }
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  /// Over the whole range, near its ends, whole numbers, zero of either sign.
  double number(double least, double most) {
    switch (whole(0, 6)) {
      case 0:
        return least;
      case 1:
        return most;
      case 2:
        return least <= 0 && most >= 0 ? (chance() ? 0.0 : -0.0) : least;
      case 3:
        return std::clamp(std::floor(uniform(least, most)), least, most);
      case 4:
        return least > 0 ? std::clamp(least * std::pow(most / least, uniform(0, 1)), least, most)
                         : uniform(least, most);
      default:
        return uniform(least, most);
    }
  }
  Eigen::Vector3d vector(double most) { return {number(-most, most), number(-most, most), number(-most, most)}; }
  std::string text() {
    static const std::vector<std::string> parts = {"a", " ", "\"", "\\", "\n", "\xc3\xa9", "\xe2\x82\xac", "{",
                                                   "]", ".", "=",  "\t", "/",  "7",        "null"};
    std::string made = "t";
    for (int n = whole(0, 6); n > 0; --n)
      made += parts[static_cast<std::size_t>(whole(0, static_cast<int>(parts.size()) - 1))];
    return made;
  }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(whole(0, static_cast<int>(all.size()) - 1))];
  }

 private:
  double uniform(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }
  std::mt19937 random_;
};

Selection selection(Dice& dice) {
  switch (dice.whole(0, 4)) {
    case 0: {
      const Eigen::Vector3d a = dice.vector(1e30), b = dice.vector(1e30);
      return BoxSelection{a.cwiseMin(b), a.cwiseMax(b)};
    }
    case 1:
      return SphereSelection{dice.vector(1e30), dice.number(0, 1e30)};
    case 2:
      return VertexSelection{{0, static_cast<std::uint32_t>(dice.whole(0, 2147483647))}};
    case 3:
      return GroupSelection{dice.text()};
    default:
      return LowestSelection{dice.number(0, 1)};
  }
}

Body body(Dice& dice, Method method) {
  Body body;
  body.name = dice.text();
  body.mesh = dice.text();
  body.transform = {dice.number(1e-9, 1e9), dice.vector(36000), dice.vector(1e6)};
  const auto model = [&] {
    std::vector<MaterialModel> able;
    for (const MaterialModel m : material_models())
      if (carries(method, m)) able.push_back(m);
    return dice.one_of(able);
  };
  visit_material(body.material, [&](double& value, const char*, const char*, double least, double most, auto&&...) {
    value = dice.number(least, most);
  });
  body.material.model = model();
  const auto look = [&] { return &tissue_looks()[static_cast<std::size_t>(dice.whole(0, 5))]; };
  const auto color = [&] { return std::array{dice.number(0, 1), dice.number(0, 1), dice.number(0, 1)}; };
  if (dice.chance()) body.material.look = look();
  if (dice.chance()) body.material.color = color();
  for (const char* key : {"17", "4", "a.b", "core"}) {  // in the order of their bytes, as a reader finds them
    if (dice.chance()) continue;
    MaterialOverride& values = body.region_materials.emplace_back(key, MaterialOverride{}).second;
    visit_material(values,
                   [&](std::optional<double>& value, const char*, const char*, double least, double most, auto&&...) {
                     if (dice.chance()) value = dice.number(least, most);
                   });
    if (dice.chance()) values.model = model();
    if (dice.chance()) values.look = look();
    if (dice.chance()) values.color = color();
  }
  for (const char* name : {"core", "3"}) {
    if (dice.chance()) continue;
    TetRegion& region = body.regions.emplace_back(TetRegion{name, {}});
    for (std::uint32_t next = 0; region.tets.size() < 4; next = region.tets.back().last + 2) {
      const auto first = next + static_cast<std::uint32_t>(dice.whole(0, 1000));
      region.tets.push_back({first, first + static_cast<std::uint32_t>(dice.whole(0, 2))});
    }
  }
  for (int n = dice.whole(0, 3); n > 0; --n) body.fixed.push_back(selection(dice));
  for (int n = dice.whole(0, 2); n > 0; --n) {
    PrescribedMotion& motion = body.prescribed.emplace_back();
    motion.start = dice.number(0, 1e9);
    motion.duration = dice.number(0, 1e9);
    if (dice.chance()) motion.targets = dice.text();
    if (motion.targets.empty() || dice.chance()) motion.select = selection(dice);
    if (!motion.targets.empty()) continue;
    motion.translate = dice.vector(1e6);
    motion.scale = dice.number(1e-3, 1e3);
    motion.angle_deg = dice.number(-36000, 36000);
    motion.center = dice.vector(1e6);
    if (const Eigen::Vector3d axis = dice.vector(1e6); axis.norm() >= 1e-6) motion.axis = axis;
  }
  if (dice.chance())
    body.initial_velocity = dice.text();
  else
    body.initial_velocity = dice.vector(1e6);
  if (dice.chance()) body.surface = dice.text();
  return body;
}

Scene scene(Dice& dice, const std::filesystem::path& file) {
  Scene scene;
  scene.file = file;
  scene.title = dice.text();
  scene.gravity = dice.vector(1e6);
  scene.duration = dice.number(0, 1e9);
  const SolverChoice pair = dice.one_of(solver_choices());
  scene.solver.method = pair.method;
  scene.solver.acceleration = pair.acceleration;
  scene.solver.integrator = dice.one_of(integrators()).integrator;
  visit_settings(scene.solver, [&](auto& value, const char*, const char*, auto least, auto most, auto&&...) {
    value = static_cast<std::decay_t<decltype(value)>>(dice.number(double(least), double(most)));
  });
  for (int n = dice.whole(1, 3); n > 0; --n) {
    scene.bodies.push_back(body(dice, pair.method));
    scene.bodies.back().name += std::to_string(n);  // each name once
  }
  if (dice.chance())
    scene.camera =
        CameraSettings{{1, 2, dice.number(3, 1e9)}, {dice.number(-1, 0.5), 0, 0}, {0, 1, 0}, dice.number(1, 170)};
  scene.display.color = dice.one_of(all_colors());
  if (dice.chance()) scene.display.range = Eigen::Vector2d(dice.number(-1e30, -1e-30), dice.number(1e-30, 1e30));
  scene.display.wireframe = dice.chance();
  visit_marks(scene.display.marks, [&](bool& kind, auto&&...) { kind = dice.chance(); });
  scene.display.legend = {dice.one_of(all_legend_sides()), dice.number(6, 60), dice.chance()};
  if (dice.chance()) {
    scene.camera_motion.smooth = dice.chance();
    for (const double time : {dice.number(0, 1), dice.number(2, 1e9)}) {
      CameraKey& key = scene.camera_motion.keys.emplace_back();
      key.time = time;
      if (dice.chance()) key.target = dice.vector(1e6);
      if (dice.chance()) key.fov_deg = dice.number(1, 170);
      if (dice.chance()) key.eye = {dice.number(1e7, 1e8), 0, 0};
      if (!key.eye && dice.chance()) key.orbit_deg = dice.number(-3600, 3600);
      if (!key.eye && dice.chance()) key.elevation_deg = dice.number(-89, 89);
      if (!key.eye && dice.chance()) key.zoom = dice.number(0.001, 1000);
    }
  }
  return scene;
}

bool same_bits(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::memcmp(a.data(), b.data(), 3 * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("random valid scenes are read back from their text to the bit") {
  const TemporaryFolder folder;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Dice dice(seed);
    const Scene made = scene(dice, folder / "s.json");
    const std::string text = scene_to_json(made, folder.path());
    CAPTURE(seed, text);
    const Scene read = read_scene_content(made.file, text);
    REQUIRE(read == made);
    CHECK(same_bits(read.gravity, made.gravity));
    for (std::size_t b = 0; b < made.bodies.size(); ++b) {
      CHECK(same_bits(read.bodies[b].transform.translate, made.bodies[b].transform.translate));
      CHECK(std::signbit(read.bodies[b].material.damping) == std::signbit(made.bodies[b].material.damping));
    }
    CHECK(scene_to_json(read, folder.path()) == text);  // so a repeated write gives the same file
  }
}
