// Cases with grabs, and with settings that change while the body moves.
#include <cmath>
#include <random>

#include "app/stress/case_maker.h"
#include "sim/grab/build_model.h"
#include "sim/model/model.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

// `during` makes the inputs of the first 80 steps; then the grab is released and 160 more follow.
void handled(StressCases& c, const std::string& name, double farthest,
             const std::function<void(long step, const Model&, std::vector<Input>&)>& during) {
  constexpr long kHandled = 80, kFreed = 160;
  Scene s = c.beam_scene();
  const Model built = build_model(s);
  StressCase& made = c.add("handling", name, s, std::nullopt, kHandled + kFreed);
  for (long step = 0; step < kHandled; ++step) during(step, built, made.replay.inputs);
  for (Input& back : std::vector<Input>{{kHandled, s.solver},
                                        {kHandled, MaterialInput{0, s.bodies[0].material}},
                                        {kHandled, GravityInput{s.gravity}},
                                        {kHandled, GrabInput{}}})
    made.replay.inputs.push_back(std::move(back));
  made.criteria.recovers = true;
  made.criteria.farthest = farthest;
}

}  // namespace

void add_handling(StressCases& c) {
  handled(c, "grab pulled 10 sizes away", 12, [&](long step, const Model& built, std::vector<Input>& inputs) {
    const double share = std::min(1.0, step / 30.0);
    inputs.push_back({step, grip_end(built, 10 * kBarSize * share * Vector3d(0.8, 0.6, 0))});
  });
  handled(c, "grab shaken at 30 Hz", 12, [&](long step, const Model& built, std::vector<Input>& inputs) {
    inputs.push_back({step, grip_end(built, (step % 2 ? 1 : -1) * kBarSize * Vector3d(0.3, 1, 0.5))});
  });
  handled(c, "grab through the body", 3, [&](long step, const Model& built, std::vector<Input>& inputs) {
    inputs.push_back({step, grip_end(built, std::min(1.0, step / 60.0) * Vector3d(-2 * kBarLength, 0, 0))});
  });
  std::mt19937 random(5);
  handled(c, "sliders scrubbed every frame", 100, [&](long step, const Model&, std::vector<Input>& inputs) {
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    Material m;
    m.model = c.model;
    m.young_modulus = std::pow(10.0, between(2, 10));
    m.poisson_ratio = between(-0.9, 0.499);
    m.density = std::pow(10.0, between(2, 4));
    m.damping = step % 3 ? between(0, 1) : 0;
    inputs.push_back({step, MaterialInput{0, m}});
    inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
  });
  handled(c, "iterations and substeps scrubbed", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
    SolverSettings settings = c.solver();
    settings.iterations = 1 + static_cast<int>(step * 7 % 40);
    settings.substeps = 1 + static_cast<int>(step * 3 % 4);
    inputs.push_back({step, settings});
    inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
  });
  handled(c, "time step changed every frame", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
    SolverSettings settings = c.solver();
    settings.time_step = std::pow(10.0, std::uniform_real_distribution<double>(-3, -1.2)(random));
    inputs.push_back({step, settings});
    inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
  });
  handled(c, "gravity flipped", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
    inputs.push_back({step, GravityInput{Vector3d(0, (step / 5) % 2 ? 98.1 : -98.1, 0)}});
  });
  // Independent of the solver choice: added once, with the default choice, to which it returns.
  if (c.pair == solver_choices().front())
    handled(c, "method switched every frame", 3, [&](long step, const Model&, std::vector<Input>& inputs) {
      SolverSettings settings = c.solver();
      std::vector<SolverChoice> able;
      for (const SolverChoice& p : solver_choices())
        if (can_run(p.method, c.model, c.elements)) able.push_back(p);
      const SolverChoice& now = able[static_cast<std::size_t>(step) % able.size()];
      settings.method = now.method;
      settings.acceleration = now.acceleration;
      inputs.push_back({step, settings});
      inputs.push_back({step, GravityInput{Vector3d(0, -9.81, 0)}});
    });

  constexpr double kLong = 1;
  Scene s = c.scene("long_beam", c.beam(kLong));
  PrescribedMotion twist;
  twist.select = BoxSelection{{kLong - kNearFace, -1, -1}, {kLong + kNearFace, 1, 1}};
  twist.angle_deg = 720;
  twist.center = {0, 0.5 * kBarWidth, 0.5 * kBarWidth};
  twist.duration = 3;
  s.bodies[0].prescribed.push_back(twist);
  c.add("handling", "twisted by 720 degrees", s, std::nullopt, 220);
}

}  // namespace fascia
