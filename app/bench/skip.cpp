#include "app/bench/skip.h"

#include <functional>

#include "app/bench/beam.h"
#include "app/bench/box.h"
#include "app/bench/timing.h"

namespace fascia {
namespace {

// A solver with its own model, since the switch of a feature may change both.
struct Subject {
  Model model;
  std::unique_ptr<GpuSolver> solver;
  std::size_t bytes = 0;

  Subject(Bench& bench, const Model& m, const SolverSettings& settings) : model(m) {
    const std::size_t before = gl::allocated_bytes();
    solver = std::make_unique<GpuSolver>(*bench.graphics.programs, model, settings);
    solver->publish();
    bytes = gl::allocated_bytes() - before;
  }
  void change(const std::function<void(Subject&)>& how) {
    const std::size_t before = gl::allocated_bytes();
    how(*this);
    bytes += gl::allocated_bytes() - before;
  }
};

struct Feature {
  std::string name;
  SolverChoice pair;
  std::function<void(Subject&)> on, off;
  Model (*built_in)(Model) = nullptr;  // replaces them for features that a scene has from the start or never
  MaterialModel law = MaterialModel::signed_st_venant_kirchhoff;  // without it
};

void set(Subject& s, const std::function<void(SolverSettings&)>& change) {
  SolverSettings settings = s.solver->settings();
  change(settings);
  s.solver->set_settings(settings);
}

std::vector<GrabSpring> grab(const Model& model) {
  std::vector<GrabSpring> springs;
  for (const std::uint32_t v : beam_tip(model)) springs.push_back({v, {0, 0.1, 0}, 100});
  return springs;
}

Model with_second_material(Model model) {
  model.materials.push_back(model.materials[0]);
  for (std::size_t t = 0; t < model.tets.size(); t += 2) model.tet_material[t] = 1;
  return model;
}

Model with_motion(Model model) {
  Motion motion;
  motion.vertices = beam_tip(model);
  motion.translate = {0.1, 0, 0};
  motion.duration = 1;
  model.motions.push_back(std::move(motion));
  return model;
}

std::vector<Feature> features() {
  const SolverChoice two_level{Method::two_level, Acceleration::subspace}, jacobi{Method::jacobi, Acceleration::none},
      sweep{Method::gauss_seidel, Acceleration::none};
  const auto damp = [](double seconds) {
    return [=](Subject& s) {
      s.model.materials[0].damping = seconds;
      s.solver->materials_changed();
    };
  };
  const auto obey = [](MaterialModel law) {
    return [=](Subject& s) {
      s.model.materials[0].model = law;
      s.solver->materials_changed();
    };
  };
  const auto accelerate = [](Acceleration acceleration) {
    return [=](Subject& s) { set(s, [=](SolverSettings& settings) { settings.acceleration = acceleration; }); };
  };
  const auto color = [](ColorBy by) { return [=](Subject& s) { s.solver->set_color(by); }; };
  const auto tolerate = [](double residual) {
    return [=](Subject& s) { set(s, [=](SolverSettings& settings) { settings.tolerance = residual; }); };
  };
  const auto limit = [](int colors) {
    return [=](Subject& s) { set(s, [=](SolverSettings& settings) { settings.colors = colors; }); };
  };
  std::vector<Feature> list;
  for (const SolverChoice& pair : {two_level, jacobi}) {
    list.push_back({"damping", pair, damp(0.01), damp(0)});
    list.push_back({"grab", pair, [](Subject& s) { s.solver->set_grab(grab(s.model)); },
                    [](Subject& s) { s.solver->set_grab({}); }});
    list.push_back({"tolerance", pair, tolerate(1e-9), tolerate(0)});
    list.push_back({"stress colors", pair, color(ColorBy::von_mises), color(ColorBy::none)});
    list.push_back({"signed stretches", pair, obey(MaterialModel::signed_st_venant_kirchhoff),
                    obey(MaterialModel::st_venant_kirchhoff), nullptr, MaterialModel::st_venant_kirchhoff});
  }
  list.push_back({"double displacements", two_level, [](Subject& s) { s.solver->set_compensated(true); },
                  [](Subject& s) { s.solver->set_compensated(false); }});
  list.push_back({"chebyshev", jacobi, accelerate(Acceleration::chebyshev), accelerate(Acceleration::none)});
  list.push_back(
      {"anderson_positions", jacobi, accelerate(Acceleration::anderson_positions), accelerate(Acceleration::none)});
  list.push_back({"phantoms", sweep, limit(8), limit(0)});
  list.push_back({"second material", two_level, {}, {}, with_second_material});
  list.push_back({"prescribed motion", two_level, {}, {}, with_motion});
  return list;
}

}  // namespace

std::vector<std::string> bench_skip(Bench& bench) {
  Model model = box_model(cells_of(bench.full_or_quick(5'000, 500)));
  const int repetitions = bench.full_or_quick(25, 3);
  Table table;
  table.notes = {
      std::to_string(model.tets.size()) + " tets, 10 iterations; a step and the positions for drawing after it",
      "never: a solver that never had the feature; off: one where it was switched on and off again; on",
      "the three take turns; ms: medians, _low, _high: a tenth is below, above"};
  table.columns = {
      "feature", "method", "acceleration", "state", "dispatches_per_step", "gpu_bytes", "bytes_per_iteration",
      "ms",      "ms_low", "ms_high"};
  std::vector<std::string> costly;
  const State start = bent_beam(model);
  for (const Feature& feature : features()) {
    bench.say("skip: " + feature.name + ", " + name_of(feature.pair));
    model.materials[0].model = feature.law;
    SolverSettings settings;
    settings.method = feature.pair.method;
    settings.acceleration = feature.pair.acceleration;
    std::vector<std::unique_ptr<Subject>> subjects;
    std::vector<std::string> states{"never"};
    subjects.push_back(std::make_unique<Subject>(bench, model, settings));
    if (feature.off) {
      states.push_back("off");
      subjects.push_back(std::make_unique<Subject>(bench, model, settings));
      subjects.back()->change([&](Subject& s) {
        for (const auto& change : {feature.on, feature.off}) {
          change(s);
          s.solver->step();
          s.solver->publish();
        }
      });
    }
    states.push_back("on");
    subjects.push_back(std::make_unique<Subject>(bench, feature.built_in ? feature.built_in(model) : model, settings));
    if (feature.on) subjects.back()->change(feature.on);

    std::vector<std::vector<double>> times(subjects.size());
    std::vector<std::uint64_t> dispatches(subjects.size());
    for (int turn = 0; turn <= repetitions; ++turn)
      for (std::size_t i = 0; i < subjects.size(); ++i) {
        bench.stop_if_interrupted();
        GpuSolver& solver = *subjects[i]->solver;
        solver.upload(start);
        std::uint64_t stepped = 0;
        const double ms = milliseconds_of([&] {
          solver.step();
          stepped = gl::dispatch_count();
          solver.publish();
        });
        dispatches[i] = solver.dispatches_per_step() + gl::dispatch_count() - stepped;
        if (turn > 0) times[i].push_back(ms);
      }
    for (std::size_t i = 0; i < subjects.size(); ++i) {
      const Spread ms = spread_of(times[i]);
      table.rows.push_back({feature.name, name_of(feature.pair.method), name_of(feature.pair.acceleration), states[i],
                            dispatches[i], subjects[i]->bytes, subjects[i]->solver->bytes_per_iteration(), ms.median,
                            ms.low, ms.high});
    }
    const std::string name = feature.name + ", " + name_of(feature.pair) + ": ";
    if (feature.off && dispatches[1] != dispatches[0])
      costly.push_back(name + std::to_string(dispatches[1]) + " dispatches when off, " + std::to_string(dispatches[0]) +
                       " without");
    if (feature.off && subjects[1]->bytes != subjects[0]->bytes)
      costly.push_back(name + std::to_string(subjects[1]->bytes) + " bytes when off, " +
                       std::to_string(subjects[0]->bytes) + " without");
  }
  bench.write("skip", std::move(table));
  if (costly.empty()) bench.say("skip: what is off takes as many dispatches and bytes as what never was");
  return costly;
}

}  // namespace fascia
