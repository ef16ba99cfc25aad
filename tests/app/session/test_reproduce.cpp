// The copied command line: its content, its quoting, and that it reproduces exactly the same scene.
#include <catch2/catch.hpp>
#include <random>

#include "app/session/reproduce.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

using Texts = std::vector<std::string>;

/// The words into which a POSIX shell splits the line.
Texts words(const std::string& line) {
  const CommandResult result = run_command({"sh", "-c", "for word in " + line + "; do printf '%s\\n' \"$word\"; done"});
  Texts words;
  std::string word;
  for (const char c : result.out) {
    if (c != '\n') {
      word += c;
      continue;
    }
    words.push_back(word);
    word.clear();
  }
  return words;
}

/// The texts after --set.
Texts sets_of(const Texts& words) {
  Texts sets;
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == "--set") sets.push_back(words[i + 1]);
  return sets;
}

struct Desk {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "it's a $cene.json";
  explicit Desk(const std::string& rest = "") {
    write_file(file,
               R"({"fascia_scene": 1, "bodies": [{"mesh": "m.msh", "materials": {"default": {"young_modulus": 1e5},
                         "a.b": {"density": 900}, "core": {"young_modulus": 1e6}}},
                        {"mesh": "n.msh"}])" +
                   rest + "}");
  }
};

}  // namespace

TEST_CASE("an unchanged scene needs no --set") {
  const Desk desk;
  CHECK(sets_between(open_scene(desk.file), open_scene(desk.file)).empty());
  CHECK(words(command_that_reproduces(open_scene(desk.file))) == Texts{"fascia", "view", desk.file.string()});
}

TEST_CASE("a removed key of the scene is not ignored") {
  const Desk desk(R"(, "camera": {"eye": [0, 0, 2]})");
  const Scene file = open_scene(desk.file);
  Scene now = file;
  now.camera.reset();
  CHECK_THROWS_WITH(sets_between(file, now), Catch::Contains("\"camera\""));
}

TEST_CASE("only changed parameters are listed, key by key") {
  const Desk desk(R"(, "display": {"range": [0, 1]})");
  const Scene file = open_scene(desk.file);
  Scene now = file;
  now.bodies[0].material.young_modulus = 1.0 / 3;
  now.bodies[0].region_materials[1].second.damping = 0.25;  // "core"
  now.bodies[1].material.model = MaterialModel::stable_neo_hookean;
  now.gravity = {0, -1.62, 0};
  now.solver.iterations = 17;
  CHECK(sets_between(file, now) == Texts{"gravity=[0,-1.62,0]", "materials.default.young_modulus=0.3333333333333333",
                                         "materials.core.damping=0.25",
                                         "bodies.1.materials.default.model=stable_neo_hookean",
                                         "solver.iterations=17"});
  CHECK(open_scene(desk.file, sets_between(file, now)) == now);

  INFO("half a pair, a range that went, a region whose name cannot stand in a key");
  now = file;
  now.solver.acceleration = Acceleration::none;
  now.display.range.reset();
  now.bodies[0].region_materials[0].second.density = 950;
  const Texts sets = sets_between(file, now);
  CHECK(open_scene(desk.file, sets) == now);
  CHECK(std::count(sets.begin(), sets.end(), "solver.method=two_level") == 1);
}

TEST_CASE("a shell gives every text back unchanged") {
  const Texts texts = {"plain", "a b", "it's",     "\"quoted\"", "$HOME `id` \\ ! * ? [0,1] {a} ~ ; & | < > ( ) #",
                       "",      "-x",  "\xc3\xa9", "''"};
  std::string line;
  for (const std::string& text : texts) line += shell_quoted(text) + " ";
  CHECK(words(line) == texts);
}

TEST_CASE("randomly changed scenes are reproduced by their command line to the same bits") {
  const Desk desk;
  const Scene file = open_scene(desk.file);
  std::mt19937 random(20190521);
  const auto chance = [&] { return random() % 3 == 0; };
  for (int trial = 0; trial < 60; ++trial) {
    Scene now = file;
    const auto turn = [&](double& value, const char*, const char*, double min, double max, auto&&...) {
      if (chance()) value = std::uniform_real_distribution<double>(min, max)(random);
    };
    for (Body& body : now.bodies) visit_material(body.material, turn);
    for (auto& [key, values] : now.bodies[0].region_materials)
      visit_material(values,
                     [&](std::optional<double>& value, const char*, const char*, double min, double max, auto&&...) {
                       if (chance()) value = std::uniform_real_distribution<double>(min, max)(random);
                     });
    if (chance()) now.bodies[1].region_materials = {{"x y", MaterialOverride{}}};
    visit_settings(now.solver, [&](auto& value, const char*, const char*, auto min, auto max, auto&&...) {
      if (!chance()) return;
      value = static_cast<std::decay_t<decltype(value)>>(
          std::uniform_real_distribution<double>(double(min), double(max))(random));
    });
    if (chance()) {
      const SolverChoice pair = solver_choices()[random() % solver_choices().size()];
      now.solver.method = pair.method;
      now.solver.acceleration = pair.acceleration;
    }
    if (chance()) now.gravity = Eigen::Vector3d(-0.0, std::uniform_real_distribution<double>(-10, 10)(random), 1e-3);
    if (chance()) now.camera = CameraSettings{{1.0 / 7, 2, 3}, {0, 0, 0}, {0, 1, 0}, 35};
    const std::string line = command_that_reproduces(now);
    CAPTURE(trial, line);
    const Scene again = open_scene(desk.file, sets_of(words(line)));
    CHECK(again == now);
    CHECK(std::signbit(again.gravity.x()) == std::signbit(now.gravity.x()));
  }
}
