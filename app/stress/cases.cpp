// The torture: starts, numbers at the ends of their ranges, meshes nobody should have made, and hands that know no
// mercy.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "app/stress/stress.h"
#include "base/error.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "sim/model/model.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double kBarLength = 0.4, kBarWidth = 0.2;  // of the beam [m]
const double kBarSize = Vector3d(kBarLength, kBarWidth, kBarWidth).norm();
constexpr double kNearFace = 1e-6;  // [m]

std::string in_short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

// As a vector of float32 would be: both sides of a replay start from the same numbers.
Vector3d rounded(const Vector3d& v) { return v.cast<float>().cast<double>(); }

struct Maker {
  SolverChoice pair;
  MaterialModel model;
  fs::path folder;
  bool quick;
  std::vector<StressCase> cases;

  TetMesh beam(double length = kBarLength) const {
    const int along = static_cast<int>(std::lround((quick ? 4 : 8) * length / kBarLength)), across = quick ? 2 : 4;
    return make_box(along, across, across, {length, kBarWidth, kBarWidth});
  }

  // A scene of one body: tissue of 1 MPa, clamped at x = 0 unless it is free, no gravity.
  Scene scene(const std::string& mesh_name, const TetMesh& mesh, bool clamped = true) const {
    write_mesh(folder / "meshes" / (mesh_name + ".msh"), mesh);
    Scene scene;
    scene.file = folder / "stress.json";
    scene.title = mesh_name;
    scene.gravity.setZero();
    Body body;
    body.name = "body";
    body.mesh = "meshes/" + mesh_name + ".msh";
    body.material.young_modulus = 1e6;
    body.material.model = model;
    if (clamped) body.fixed.push_back(BoxSelection{{-kNearFace, -1, -1}, {kNearFace, 1, 1}});
    scene.bodies.push_back(body);
    scene.solver.method = pair.method;
    scene.solver.acceleration = pair.acceleration;
    return scene;
  }
  Scene beam_scene(bool clamped = true) const { return scene("beam", beam(), clamped); }

  // At rest in the places that `place` gives the vertices; those at x = 0 stay where a clamped body holds them.
  std::optional<State> start(const Scene& scene, const std::function<Vector3d(const Vector3d&)>& place) const {
    const Model built = build_model(scene);
    State state = initial_state(built);
    const std::vector<char> held = built.held();
    for (std::size_t v = 0; v < held.size(); ++v)
      if (!held[v]) state.displacement[v] = rounded(place(built.rest_positions[v]) - built.rest_positions[v]);
    return state;
  }
  std::optional<State> bent(const Scene& scene) const {
    return start(scene, [](const Vector3d& x) -> Vector3d {
      return x + Vector3d(-0.2 * x.x() * x.x() / kBarLength, 0.3 * x.x() * x.x() / kBarLength, 0);
    });
  }

  StressCase& add(const std::string& group, const std::string& name, Scene scene, std::optional<State> state,
                  long steps) {
    StressCase& made = cases.emplace_back();
    made.group = group;
    made.name = name;
    made.replay = {std::move(scene), std::move(state), {}, steps};
    return made;
  }

  void starts() {
    for (const double young : {1e6, 1e9}) {
      Scene s = beam_scene();
      s.bodies[0].material.young_modulus = young;
      const auto torture = [&](const std::string& name, const std::function<Vector3d(const Vector3d&)>& place) {
        StressCase& made = add("start", name + " E=" + in_short(young), s, start(s, place), 150);
        made.criteria.recovers = true;
        made.criteria.farthest = 6;  // random places are two sizes away to begin with
      };
      std::mt19937 random(3);
      std::uniform_real_distribution<double> uniform(-1, 1);
      torture("random", [&](const Vector3d&) -> Vector3d {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        return Vector3d(0.5 * kBarLength, 0.5 * kBarWidth, 0.5 * kBarWidth) + kBarLength * Vector3d(x, y, z);
      });
      torture("flattened", [](const Vector3d& x) { return Vector3d(x.x(), 0.5 * kBarWidth, x.z()); });
      torture("collapsed to a point",
              [](const Vector3d&) { return Vector3d(0.5 * kBarLength, 0.5 * kBarWidth, 0.5 * kBarWidth); });
      torture("mirrored", [](const Vector3d& x) { return Vector3d(-x.x(), x.y(), x.z()); });
      torture("half mirrored", [](const Vector3d& x) {
        return Vector3d(x.x() > 0.5 * kBarLength ? kBarLength - x.x() : x.x(), x.y(), x.z());
      });
    }
  }

  // Let go bent, under gravity: the steady case of which one number at a time is turned to the ends of its range.
  StressCase& released(const std::string& group, const std::string& name, Scene scene, long steps) {
    scene.gravity = {0, -9.81, 0};
    std::optional<State> state = bent(scene);
    StressCase& made = add(group, name, std::move(scene), std::move(state), steps);
    made.criteria.creates_no_energy = true;
    return made;
  }

  void numbers() {
    for (const double young : {1e2, 1e4, 1e6, 1e8, 1e10}) {
      Scene s = beam_scene();
      s.bodies[0].material.young_modulus = young;
      StressCase& made = released("number", "E=" + in_short(young), s, 90);
      // Jelly of 100 Pa is no beam: its own weight tears it down by many times its length.
      if (young < 1e4) made.criteria.farthest = 100;
      made.criteria.keeps_upright = young >= 1e4;
    }
    for (const double ratio : {-0.9, 0.0, 0.3, 0.49, 0.499}) {
      Scene s = beam_scene();
      s.bodies[0].material.poisson_ratio = ratio;
      released("number", "nu=" + in_short(ratio), s, 90);
    }
    for (const int rate : {15, 60, 250, 1000}) {
      Scene s = beam_scene();
      s.solver.time_step = 1.0 / rate;
      released("number", "h=1/" + std::to_string(rate), s, rate < 100 ? 90 : 250);
    }
    for (const int iterations : {1, 5, 20, 100}) {
      Scene s = beam_scene();
      s.solver.iterations = iterations;
      released("number", "iterations=" + std::to_string(iterations), s, iterations > 50 ? 60 : 90);
    }
    const auto halves = [&](const char* name, int steps, const std::function<void(Body&, MaterialOverride&)>& change) {
      TetMesh mesh = beam();
      mesh.regions.assign(mesh.tets.size(), 1);
      for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
        Vector3d center = Vector3d::Zero();
        for (const std::uint32_t v : mesh.tets[t]) center += 0.25 * mesh.positions[v];
        if (std::fmod(center.x() / kBarLength, 0.5) > 0.25) mesh.regions[t] = 2;
      }
      Scene s = scene("layers", mesh);
      change(s.bodies[0], s.bodies[0].region_materials.emplace_back("2", MaterialOverride{}).second);
      return released("number", name, s, steps);
    };
    // Soft layers of 10 kPa would be crushed by the weight of the beam in the exact solution, too. These are turned
    // inside out by the stiff ones, and in the exact solution, too, some of their tets still are after 90 steps; none
    // after 180.
    halves("layers of E 1:1e6", 180, [](Body& body, MaterialOverride& m) {
      body.material.young_modulus = 3e4;
      m.young_modulus = 3e10;
    });
    halves("densities 1:1e4", 90, [](Body& body, MaterialOverride& m) {
      body.material.density = 100;
      m.density = 1e6;
    });
  }

  // Free in space: nothing outside acts, so nothing may appear.
  void free_flight() {
    Scene s = beam_scene(false);
    std::optional<State> state = bent(s);
    const Model built = build_model(s);
    for (std::size_t v = 0; v < state->velocity.size(); ++v)
      state->velocity[v] = rounded(Vector3d(1, 2, 0.5) + Vector3d(3, -2, 5).cross(built.rest_positions[v]));
    StressCase& made = add("conservation", "free and spinning", s, state, 90);
    made.criteria.farthest = 20;
    made.criteria.creates_no_energy = made.criteria.creates_no_momentum = true;
  }

  // Every vertex off its place by up to a tenth of the mean edge around it.
  std::optional<State> shaken(const Scene& scene) const {
    const Model built = build_model(scene);
    std::vector<double> edge(built.rest_positions.size(), 0), count(edge);
    for (const Tet& tet : built.tets)
      for (const std::uint32_t a : tet)
        for (const std::uint32_t b : tet) {
          edge[a] += (built.rest_positions[a] - built.rest_positions[b]).norm();
          count[a] += a != b;
        }
    std::mt19937 random(8);
    std::uniform_real_distribution<double> uniform(-0.1, 0.1);
    std::size_t v = 0;
    State state = initial_state(built);
    const std::vector<char> held = built.held();
    for (; v < edge.size(); ++v)
      if (!held[v] && count[v] > 0)
        state.displacement[v] =
            rounded(edge[v] / count[v] * Vector3d(uniform(random), uniform(random), uniform(random)));
    return state;
  }

  StressCase& shape(const std::string& name, const TetMesh& mesh, bool clamped, double scale = 1) {
    Scene s = scene(name, mesh, clamped);
    s.bodies[0].transform.scale = scale;
    std::optional<State> state = shaken(s);
    StressCase& made = add("mesh", name, std::move(s), std::move(state), 180);
    made.criteria.creates_no_energy = true;
    made.criteria.creates_no_momentum = !clamped;
    return made;
  }

  void meshes() {
    const auto simplex = [](double x, const Vector3d& apex) {
      TetMesh mesh;
      mesh.positions = {{0, 0, 0}, {x, 0, 0}, {0.5 * x, 0.8 * x, 0}, apex};
      mesh.tets = {{0, 1, 2, 3}};
      mesh.regions = {0};
      return mesh;
    };
    shape("single tet", simplex(0.1, {0.05, 0.03, 0.08}), false);
    TetMesh pair_of_tets = simplex(0.1, {0.05, 0.03, 0.08});
    pair_of_tets.positions.insert(pair_of_tets.positions.end(), {{0.05, -0.06, -0.02}, {0.05, -0.05, -0.09}});
    pair_of_tets.tets.push_back({0, 1, 5, 4});
    pair_of_tets.regions.push_back(0);
    shape("two tets sharing an edge", pair_of_tets, false);
    shape("needle", simplex(0.001, {0.0005, 0.0003, 0.1}), false);
    shape("cap", simplex(0.1, {0.05, 0.03, 0.0002}), false);

    // Every second layer of cells squashed until its tets have dihedral angles of 0.1 degrees.
    TetMesh slivers = beam();
    const int along = quick ? 4 : 8;
    const double cell = kBarLength / along,
                 thin = (kBarWidth / (quick ? 2 : 4)) * std::tan(0.1 * std::numbers::pi / 180);
    deform(slivers, [&](const Vector3d& x) -> Vector3d {
      const int layer = static_cast<int>(std::lround(x.x() / cell));
      const int pairs = layer / 2;
      return {pairs * (cell + thin) + (layer % 2) * cell, x.y(), x.z()};
    });
    // Shaken by a tenth of the long edges, the thin layers are turned inside out fifty times their thickness deep.
    StressCase& squashed = shape("slivers", slivers, true);
    squashed.criteria.recovers = true;
    squashed.criteria.farthest = 10;

    TetMesh parts = beam();
    const TetMesh one = parts;
    for (const double offset : {0.3, 0.6}) {
      const auto base = static_cast<std::uint32_t>(parts.positions.size());
      for (const Vector3d& x : one.positions) parts.positions.push_back(x + Vector3d(0, offset, 0));
      for (const Tet& tet : one.tets)
        parts.tets.push_back({tet[0] + base, tet[1] + base, tet[2] + base, tet[3] + base});
      parts.regions.resize(parts.tets.size(), 0);
    }
    shape("disconnected parts", parts, true).criteria.recovers = true;
    shape("1 mm", beam(), true, 1e-3 / kBarLength).criteria.recovers = true;
    // As stiff for its weight as the small ones, so that it comes to rest within the time.
    StressCase& large = shape("100 m", beam(), true, 100 / kBarLength);
    large.replay.scene.bodies[0].material.young_modulus = 1e10;
    large.criteria.recovers = true;
  }

  // Springs on the vertices near the free end, as the grab makes them: as stiff together as tissue indented by a disc.
  GrabInput grip(const Model& built, const Vector3d& offset) const {
    GrabInput springs;
    const double stiffness = 3 * 1e6 * 0.08 * 0.5 * kBarSize;
    for (std::uint32_t v = 0; v < built.rest_positions.size(); ++v)
      if (built.rest_positions[v].x() > 0.99 * kBarLength) springs.push_back({v, offset, 0});
    for (GrabSpring& spring : springs) spring.stiffness = stiffness / static_cast<double>(springs.size());
    return springs;
  }

  // `during` makes the inputs of the first 80 steps; then all is let go and 160 more follow.
  void handled(const std::string& name, double farthest,
               const std::function<void(long step, const Model&, std::vector<Input>&)>& during) {
    constexpr long kHandled = 80, kFreed = 160;
    Scene s = beam_scene();
    const Model built = build_model(s);
    StressCase& made = add("handling", name, s, std::nullopt, kHandled + kFreed);
    for (long step = 0; step < kHandled; ++step) during(step, built, made.replay.inputs);
    for (Input& back : std::vector<Input>{{kHandled, s.solver},
                                          {kHandled, MaterialInput{0, s.bodies[0].material}},
                                          {kHandled, GravityInput{s.gravity}},
                                          {kHandled, GrabInput{}}})
      made.replay.inputs.push_back(std::move(back));
    made.criteria.recovers = true;
    made.criteria.farthest = farthest;
  }

  void handling() {
    handled("grab pulled 10 sizes away", 12, [&](long step, const Model& built, std::vector<Input>& inputs) {
      const double way = std::min(1.0, step / 30.0);
      inputs.push_back({step, grip(built, 10 * kBarSize * way * Vector3d(0.8, 0.6, 0))});
    });
    handled("grab shaken at 30 Hz", 12, [&](long step, const Model& built, std::vector<Input>& inputs) {
      inputs.push_back({step, grip(built, (step % 2 ? 1 : -1) * kBarSize * Vector3d(0.3, 1, 0.5))});
    });
    handled("grab through the body", 3, [&](long step, const Model& built, std::vector<Input>& inputs) {
      inputs.push_back({step, grip(built, std::min(1.0, step / 60.0) * Vector3d(-2 * kBarLength, 0, 0))});
    });
    std::mt19937 random(5);
    handled("sliders scrubbed every frame", 100, [&](long step, const Model&, std::vector<Input>& inputs) {
      const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
      };
      Material m;
      m.model = model;
      m.young_modulus = std::pow(10.0, between(2, 10));
      m.poisson_ratio = between(-0.9, 0.499);
      m.density = std::pow(10.0, between(2, 4));
      m.damping = step % 3 ? between(0, 1) : 0;
      inputs.push_back({step, MaterialInput{0, m}});
      inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
    });
    handled("iterations and substeps scrubbed", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
      SolverSettings settings = beam_solver();
      settings.iterations = 1 + static_cast<int>(step * 7 % 40);
      settings.substeps = 1 + static_cast<int>(step * 3 % 4);
      inputs.push_back({step, settings});
      inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
    });
    handled("time step changed every frame", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
      SolverSettings settings = beam_solver();
      settings.time_step = std::pow(10.0, std::uniform_real_distribution<double>(-3, -1.2)(random));
      inputs.push_back({step, settings});
      inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
    });
    handled("gravity flipped", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
      inputs.push_back({step, GravityInput{Vector3d(0, (step / 5) % 2 ? 98.1 : -98.1, 0)}});
    });
    // Belongs to no pair: told once, with the default one that it comes back to.
    if (pair == solver_choices().front())
      handled("method switched every frame", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
        SolverSettings settings = beam_solver();
        std::vector<SolverChoice> able;
        for (const SolverChoice& p : solver_choices())
          if (carries(p.method, model)) able.push_back(p);
        const SolverChoice& now = able[static_cast<std::size_t>(step) % able.size()];
        settings.method = now.method;
        settings.acceleration = now.acceleration;
        inputs.push_back({step, settings});
        inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
      });

    constexpr double kLong = 1;
    Scene s = scene("long_beam", beam(kLong));
    PrescribedMotion twist;
    twist.select = BoxSelection{{kLong - kNearFace, -1, -1}, {kLong + kNearFace, 1, 1}};
    twist.angle_deg = 720;
    twist.center = {0, 0.5 * kBarWidth, 0.5 * kBarWidth};
    twist.duration = 3;
    s.bodies[0].prescribed.push_back(twist);
    add("handling", "twisted by 720 degrees", s, std::nullopt, 220);
  }

  SolverSettings beam_solver() const {
    SolverSettings settings;
    settings.method = pair.method;
    settings.acceleration = pair.acceleration;
    return settings;
  }
};

}  // namespace

std::vector<StressCase> stress_cases(const SolverChoice& pair, MaterialModel model, const fs::path& folder,
                                     bool quick) {
  std::error_code ec;
  fs::create_directories(folder / "meshes", ec);
  if (ec) throw Error((folder / "meshes").string(), "cannot be made: " + ec.message(), "expected a writable folder");
  Maker maker{pair, model, folder, quick, {}};
  maker.starts();
  maker.numbers();
  maker.free_flight();
  maker.meshes();
  maker.handling();
  return std::move(maker.cases);
}

}  // namespace fascia
