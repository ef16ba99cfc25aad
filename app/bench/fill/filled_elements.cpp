#include "app/bench/fill/filled_elements.h"

#include <Eigen/LU>
#include <algorithm>
#include <memory>

#include "app/bench/fill/rigid_motion.h"
#include "app/bench/fill/shapes.h"
#include "app/bench/timing.h"
#include "base/text.h"
#include "sim/accuracy/recovered_stress.h"
#include "sim/accuracy/relative_distance.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/elements/quadratic_tet.h"
#include "sim/grab/build_model.h"
#include "sim/output/sample.h"
#include "sim/simulation/simulation.h"
#include "sim/surface/embedding.h"
#include "sim/surface/shape_file.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

constexpr int kSteps = 60, kWatchEvery = 6;  // of the motion, from rest under the weight
constexpr int kTimedSteps = 25;
constexpr double kAsFast = 1.1;      // of the linear fill's time: what the clock of a busy machine tells apart
constexpr double kHeldShare = 0.25;  // of the height: thicker than the cells of all fills
constexpr double kBlow = 0.1;        // speed of the free body's ends, over that of waves
constexpr double kFreeStep = 0.1;    // of the time in which a wave crosses it
constexpr std::size_t kMostSamples = 4000;

struct Filled {
  Scene scene;
  Model model;
  EmbeddedPoints samples;
};

Filled filled(const Scene& base, ElementOrder elements, int resolution) {
  Filled result;
  result.scene = base;
  result.scene.bodies[0].elements = elements;
  result.scene.bodies[0].resolution = resolution;
  result.model = build_model(result.scene);
  return result;
}

std::unique_ptr<Simulation> simulate(const Bench& bench, const Filled& filled) {
  auto simulation = std::make_unique<Simulation>(filled.scene, filled.model, bench.graphics.programs.get(), false);
  simulation->gpu()->finish_background();
  return simulation;
}

std::vector<Vector3d> equilibrium(const Bench& bench, const Filled& filled) {
  Filled patient = filled;
  patient.scene.solver.tolerance = 1e-5;
  const auto simulation = simulate(bench, patient);
  const StaticReport report = simulation->solve_static();
  if (!report.converged) bench.say("not converged: " + describe(report));
  return at_points(filled.samples, simulation->state().displacement);
}

std::vector<Vector3d> motion(const Bench& bench, const Filled& filled) {
  const auto simulation = simulate(bench, filled);
  std::vector<Vector3d> all;
  for (int step = 1; step <= kSteps; ++step) {
    bench.stop_if_interrupted();
    simulation->step();
    if (step % kWatchEvery != 0) continue;
    const std::vector<Vector3d> now = at_points(filled.samples, simulation->state().displacement);
    all.insert(all.end(), now.begin(), now.end());
  }
  return all;
}

/// The motion of the body without supports and weight, after a blow that bends it: nothing depends on the vertices that
/// a selection finds in a mesh.
std::vector<Vector3d> free_motion(const Bench& bench, const Filled& held) {
  Filled free = held;
  free.scene.bodies[0].fixed.clear();
  free.scene.gravity.setZero();
  const Material& material = held.model.materials[0];
  const double waves = std::sqrt(material.young_modulus / material.density);  // their speed [m/s]
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : held.samples.points) box.extend(x);
  Eigen::Index along = 0;
  const double size = box.sizes().maxCoeff(&along);
  free.scene.solver.integrator = Integrator::bdf2;
  free.scene.solver.time_step = kFreeStep * size / waves;
  free.model = build_model(free.scene);
  for (std::size_t v = 0; v < free.model.rest_positions.size(); ++v) {
    const double place = 2 * (free.model.rest_positions[v] - box.center())[along] / size;
    free.model.initial_velocity[v][(along + 1) % 3] = kBlow * waves * place * place;
  }
  remove_rigid_motion(free.model);
  return motion(bench, free);
}

/// Medians of steps that take turns, so that a disturbance affects all alike.
void measure_times(const Bench& bench, const std::vector<const Filled*>& fills, std::vector<double>& ms) {
  std::vector<std::unique_ptr<Simulation>> simulations;
  for (const Filled* fill : fills) {
    simulations.push_back(simulate(bench, *fill));
    for (int k = 0; k < 3; ++k) simulations.back()->step();
  }
  std::vector<std::vector<double>> times(fills.size());
  for (int k = 0; k < kTimedSteps; ++k)
    for (std::size_t f = 0; f < fills.size(); ++f) times[f].push_back(milliseconds_of([&] { simulations[f]->step(); }));
  ms.clear();
  for (const auto& of_one : times) ms.push_back(spread_of(of_one).median);
}

/// The finest quadratic fill whose step takes no longer than the linear one's.
int resolution_as_fast(const Bench& bench, const Scene& base, const Filled& linear) {
  const auto as_fast = [&](int cells) {
    bench.stop_if_interrupted();
    const Filled quadratic = filled(base, ElementOrder::quadratic, cells);
    std::vector<double> ms;
    measure_times(bench, {&linear, &quadratic}, ms);
    return ms[1] <= kAsFast * ms[0];
  };
  int cells = std::max(kFewestCells, *linear.scene.bodies[0].resolution * 2 / 5);
  if (as_fast(cells)) {
    while (as_fast(cells + 1)) ++cells;
    return cells;
  }
  while (cells > kFewestCells && !as_fast(cells - 1)) --cells;
  return std::max(cells - 1, kFewestCells);
}

/// A hand takes the vertex that is farthest from the supports, pulls it by 0.4 of the longest side, and lets go.
void pull(const Bench& bench, const Filled& filled, const Vector3d& grip, double size, FilledPoint& point) {
  Filled pulled = filled;
  ScriptedGrab grab;
  grab.where = grip;
  grab.radius = 0.1 * size;
  grab.start = 0.1;
  grab.duration = 0.2;
  grab.release = 0.6;
  grab.translate = Vector3d(0.3, 0.2, 0.2).normalized() * 0.4 * size;
  pulled.scene.grabs = {grab};
  pulled.model = build_model(pulled.scene);
  const auto simulation = simulate(bench, pulled);
  const Model& model = pulled.model;
  for (int step = 0; step < kSteps; ++step) {
    bench.stop_if_interrupted();
    simulation->step();
    const State state = simulation->state();
    const auto lowest = [&](const Eigen::Matrix3d& h, double& least) {
      least = std::min(least, (Eigen::Matrix3d::Identity() + h).determinant());
    };
    for (std::size_t t = 0; t < model.tets.size(); ++t) {
      const ElementVertices element = model.element(t);
      const auto corner = [&](std::size_t a) { return model.rest_positions[model.tets[t][a]]; };
      const LinearTet rest({corner(0), corner(1), corner(2), corner(3)});
      if (model.is_quadratic(t)) {
        QuadraticTet::Nodes u;
        for (std::size_t a = 0; a < 10; ++a) u[a] = state.displacement[element[a]];
        const QuadraticTet tet(rest);
        for (const Eigen::Matrix3d& h : tet.at_points(u)) lowest(h, point.least_det);
        for (const Eigen::Matrix3d& h : tet.at_corners(u)) lowest(h, point.least_det_at_corners);
      } else {
        const auto u = [&](std::size_t a) { return state.displacement[element[a]]; };
        point.least_det = std::min(point.least_det, rest.deformation_gradient({u(0), u(1), u(2), u(3)}).determinant());
        point.least_det_at_corners = point.least_det;
      }
    }
  }
}

FilledPoint describe_fill(const Filled& fill) {
  const Body& body = fill.scene.bodies[0];
  FilledPoint point;
  point.elements = body.elements;
  point.resolution = *body.resolution;
  point.vertices = fill.model.rest_positions.size();
  point.tets = fill.model.tets.size();
  for (std::size_t t = 0; t < fill.model.tets.size(); ++t) point.volume += volume_of(fill.model, t);
  return point;
}

}  // namespace

std::vector<FilledPoint> compare_elements(const Bench& bench, const FilledCase& wanted) {
  // Opened on its own, the surface gets the supports and the stiffness that all fills share.
  Scene base = open_scene(wanted.surface);
  settled_model(base);
  base.bodies[0].fixed = {LowestSelection{kHeldShare}};
  base.bodies[0].material.poisson_ratio = wanted.poisson_ratio;
  const int usual =
      wanted.linear.value_or(fill_surface(*read_shape(wanted.surface).surface, wanted.surface.string(), {}).resolution);
  Filled linear = filled(base, ElementOrder::linear, usual);
  Filled quadratic = filled(base, ElementOrder::quadratic,
                            wanted.quadratic ? *wanted.quadratic : resolution_as_fast(bench, base, linear));
  Filled truth = filled(base, ElementOrder::quadratic, wanted.truth.value_or(7 * usual / 4));

  std::vector<Vector3d> places;
  std::vector<char> corner(truth.model.rest_positions.size(), 0);
  for (const Tet& tet : truth.model.tets)
    for (const std::uint32_t v : tet) corner[v] = 1;
  const auto corners = static_cast<std::size_t>(std::count(corner.begin(), corner.end(), 1));
  const std::size_t stride = corners / kMostSamples + 1;
  std::size_t next = 0;
  for (std::size_t v = 0; v < corner.size(); ++v)
    if (corner[v] != 0 && next++ % stride == 0) places.push_back(truth.model.rest_positions[v]);
  for (Filled* fill : {&linear, &quadratic, &truth})
    fill->samples = embed(places, fill->model.rest_positions, fill->model.tets, fill->model.mid_edges);

  const Vector3d grip = truth.model.rest_positions[tip_vertex(truth.model)];
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : truth.model.rest_positions) box.extend(x);
  const std::vector<Vector3d> still = equilibrium(bench, truth), moving = motion(bench, truth),
                              struck = free_motion(bench, truth);
  std::vector<double> ms;
  measure_times(bench, {&linear, &quadratic, &truth}, ms);
  std::vector<FilledPoint> points;
  for (const Filled* fill : {&linear, &quadratic, &truth}) {
    FilledPoint point = describe_fill(*fill);
    point.ms = ms[points.size()];
    if (fill != &truth) {
      point.static_error = relative_distance(equilibrium(bench, *fill), still);
      point.motion_error = relative_distance(motion(bench, *fill), moving);
      point.free_error = relative_distance(free_motion(bench, *fill), struck);
      pull(bench, *fill, grip, box.sizes().maxCoeff(), point);
    }
    points.push_back(point);
  }
  return points;
}

void bench_elements(Bench& bench, std::vector<std::filesystem::path> surfaces, const std::vector<int>& resolutions) {
  if (surfaces.empty())
    for (const Shape& shape : fill_shapes())
      if (shape.name == "sphere" || shape.name == "liver" || shape.name == "brick" || shape.name == "knot") {
        surfaces.push_back(bench.folder / (shape.name + ".obj"));
        write_shape(surfaces.back(), shape.surface);
      }
  Table table{{"errors: of displacements by the mesh alone, RMS over RMS displacement, against the fill `truth`",
               "motion: let go at rest, ten times of the first second; least J under a hand that pulls by 0.4 of the "
               "longest side and lets go"},
              {"surface", "poisson_ratio", "elements", "resolution", "vertices", "tets", "volume_m3", "ms_median",
               "static_error", "motion_error", "free_error", "least_J", "least_J_at_corners"},
              {}};
  for (const std::filesystem::path& surface : surfaces)
    for (const double nu : bench.full_or_quick<std::vector<double>>({0.3, 0.45}, {0.3})) {
      FilledCase wanted{surface, nu, {}, {}, {}};
      if (resolutions.size() == 3) {
        wanted.linear = resolutions[0];
        wanted.quadratic = resolutions[1];
        wanted.truth = resolutions[2];
      }
      const std::vector<FilledPoint> points = compare_elements(bench, wanted);
      for (const FilledPoint& p : points) {
        const bool truth = &p == &points.back();
        const auto measured = [&](double value) { return truth ? Cell() : Cell(value); };
        table.rows.push_back({surface.stem().string(), nu, truth ? "truth" : name_of(p.elements), p.resolution,
                              p.vertices, p.tets, p.volume, p.ms, measured(p.static_error), measured(p.motion_error),
                              measured(p.free_error), measured(p.least_det), measured(p.least_det_at_corners)});
        bench.say(surface.stem().string() + ", nu = " + number(nu) + ", " + name_of(p.elements) + ", resolution " +
                  std::to_string(p.resolution) + ", " + std::to_string(p.tets) + " tets: " + number(p.ms) + " ms" +
                  (truth ? " (truth)"
                         : ", static " + number(100 * p.static_error) + " %, motion " + number(100 * p.motion_error) +
                               " %, free " + number(100 * p.free_error) + " %, least J " + number(p.least_det) +
                               ", at corners " + number(p.least_det_at_corners)));
      }
      bench.write("elements", table);
    }
}

}  // namespace fascia
