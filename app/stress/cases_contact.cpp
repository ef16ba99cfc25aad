// Cases with rigid tools that do what no hand does: they appear inside the tissue, shake, crush, pinch and press from
// all sides.
#include <cmath>
#include <numbers>

#include "app/stress/case_maker.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

using Eigen::Vector3d;
using Key = Instrument::Key;

const Vector3d kMiddle(0.5 * kBarLength, 0.5 * kBarWidth, 0.5 * kBarWidth);
constexpr double kAway = 2;  // [m] where no tool touches

Instrument tool(const std::string& name, const ToolShape& shape, std::vector<Key> path) {
  Instrument instrument;
  instrument.name = name;
  instrument.shape = shape;
  instrument.path = std::move(path);
  return instrument;
}

ToolShape ball(double radius) { return SphereShape{{0, 0, 0}, radius}; }

Key at(double time, const Vector3d& position) { return {time, position, {0, 0, 0}}; }

// A clamped beam without gravity that springs back once the tools have left it.
StressCase& touched(StressCases& c, const std::string& name, std::vector<Instrument> tools, long steps = 120,
                    const std::function<void(Scene&)>& change = {}) {
  Scene s = c.beam_scene();
  s.bodies[0].material.damping = 0.01;
  s.tools.instruments = std::move(tools);
  if (change) change(s);
  StressCase& made = c.add("contact", name, std::move(s), std::nullopt, steps);
  made.criteria.recovers = true;
  return made;
}

// Presses the beam's free end down by `depth` within half a second, and slides along it, before it leaves.
Instrument presses(double depth) {
  const double top = kBarWidth + 0.04;
  return tool("ball", ball(0.04),
              {at(0, {0.3, top + 0.01, 0.1}), at(0.4, {0.3, top - depth, 0.1}), at(0.8, {0.2, top - depth, 0.12}),
               at(1, {0.2, top + 0.1, 0.12})});
}

// A block on the ground, of 10 cm or less.
Scene block(StressCases& c, double height) {
  const int cells = c.quick ? 3 : 6;
  const TetMesh mesh = make_box(cells, std::max(1, static_cast<int>(cells * height / 0.1)), cells, {0.1, height, 0.1});
  Scene s = c.scene("block_" + in_short(height), mesh, false);
  s.bodies[0].material.young_modulus = 2e4;
  s.bodies[0].material.damping = 0.01;
  s.gravity = {0, -9.81, 0};
  s.tools.ground = Ground{0, 0.5};
  return s;
}

}  // namespace

void add_contact(StressCases& c) {
  if (!info_of(c.pair.method).carries_contact) return;
  const double blink = 1e-6;  // [s]
  const Vector3d above = kMiddle + Vector3d(0, kAway, 0);
  touched(
      c, "tool appears inside and vanishes",
      {tool("ball", ball(0.05), {at(0.1, above), at(0.1 + blink, kMiddle), at(0.5, kMiddle), at(0.5 + blink, above)})});
  std::vector<Key> shaken;
  for (int k = 0; k < 60; ++k)
    shaken.push_back(at(k / 60.0, {0.35, kBarWidth + 0.04 - (k % 2 ? 0.03 : 0), 0.1 + (k % 3 ? 0.01 : -0.01)}));
  shaken.push_back(at(1 + blink, above));
  touched(c, "tool shakes by 3 cm in every step", {tool("ball", ball(0.04), shaken)});
  // 100 kHz, of which every step sees one moment: without any order.
  std::vector<Key> jittered{at(0, {0.3, kBarWidth + 0.05, 0.1})};
  for (int k = 12; k < 60; ++k)
    jittered.push_back(at(k / 60.0, Vector3d(0.3, kBarWidth + 0.02, 0.1) +
                                        0.002 * Vector3d(std::sin(12.9 * k), std::sin(78.2 * k), std::sin(37.7 * k))));
  jittered.push_back(at(1 + blink, above));
  touched(c, "tool jitters at 100 kHz", {tool("ball", ball(0.04), jittered)});
  std::vector<Key> stepped;  // down by 3 cm, then along the beam, five places a second
  for (int k = 0; k < 6; ++k) {
    const Vector3d place(0.35 - 0.03 * std::max(0, k - 1), kBarWidth + 0.04 - 0.015 * std::min(k, 2), 0.1);
    stepped.push_back(at(0.2 * k + blink, place));
    stepped.push_back(at(0.2 * (k + 1), place));
  }
  stepped.push_back(at(1.2 + blink, above));
  touched(c, "tool moved at 5 frames a second", {tool("ball", ball(0.04), stepped)}, 150);
  touched(c, "tool flies through at 60 m/s",
          {tool("ball", ball(0.05),
                {at(0.1, kMiddle + Vector3d(0, 1, 0)), at(0.1 + 1.0 / 30, kMiddle - Vector3d(0, 1, 0))})});
  std::vector<Instrument> ten;
  for (int k = 0; k < 10; ++k) {
    const double angle = 0.2 * std::numbers::pi * k;
    const Vector3d outward(0, std::cos(angle), std::sin(angle));
    const Vector3d start(0.1 + 0.025 * k, kMiddle.y(), kMiddle.z());
    ten.push_back(
        tool("ball " + std::to_string(k), ball(0.03),
             {at(0, start + 0.25 * outward), at(0.5, start + 0.11 * outward), at(1, start + 0.25 * outward)}));
  }
  touched(c, "ten tools", ten);

  for (const double young : {1e3, 1e4, 1e5, 1e6, 1e8})
    // Tissue of 1 kPa swings by itself, once in five seconds.
    touched(c, "pressed E=" + in_short(young), {presses(0.03)}, young < 1e6 ? 300 : 150, [&](Scene& s) {
      s.bodies[0].material.young_modulus = young;
    }).criteria.recovers = young > 1e4;
  StressCase& reset = touched(c, "reset while pressed", {presses(0.03)}, 240);
  for (const long step : {30, 31, 70, 90}) reset.replay.inputs.push_back({step, ResetInput{}});
  StressCase& undone = touched(c, "sliders moved and undone while pressed", {presses(0.03)}, 150);
  const Material before = undone.replay.scene.bodies[0].material;
  for (long step = 24; step < 48; ++step) {
    Material changed = before;
    if (step % 2 == 0) changed.young_modulus *= step % 4 == 0 ? 30 : 0.03;
    if (step % 6 == 0) changed.poisson_ratio = 0.48;
    undone.replay.inputs.push_back({step, MaterialInput{0, changed}});
  }
  undone.replay.inputs.push_back({48, MaterialInput{0, before}});

  for (const double ratio : {0.0, 0.45, 0.49})
    touched(c, "pressed nu=" + in_short(ratio), {presses(0.03)}, 150,
            [&](Scene& s) { s.bodies[0].material.poisson_ratio = ratio; });
  for (const double friction : {0.0, 0.5, 2.0})
    touched(c, "pressed mu=" + in_short(friction), {presses(0.03)}, 150,
            [&](Scene& s) { s.tools.contact.friction = friction; });

  Scene crushed = block(c, 0.1);
  crushed.tools.instruments.push_back(tool("plate", BoxShape{{0, 0, 0}, {0.1, 0.05, 0.1}},
                                           {at(0.2, {0.05, 0.155, 0.05}), at(1.2, {0.05, 0.07, 0.05}),
                                            at(1.5, {0.05, 0.07, 0.05}), at(2, {0.05, 0.3, 0.05})}));
  c.add("contact", "crushed to 20 %", crushed, std::nullopt, 150);

  Scene sliver = c.scene("sliver", make_box(8, 1, 2, {0.2, 0.005, 0.05}));
  sliver.bodies[0].material.damping = 0.01;
  Instrument forceps =
      tool("forceps", {}, {at(0, {0.24, 0.0025, 0.025}), at(0.5, {0.24, 0.0025, 0.025}), at(1, {0.24, 0.0025, 0.025})});
  forceps.shape = JawsShape{BoxShape{{-0.04, 0.004, 0}, {0.04, 0.004, 0.02}}, {0, 0, 1}, 40};
  forceps.path[1].grip = 1;
  sliver.tools.instruments.push_back(forceps);
  c.add("contact", "jaws close on a sliver", sliver, std::nullopt, 120).criteria.recovers = true;

  Scene lies = block(c, 0.1);
  lies.solver.rest_speed = 0;
  c.add("contact", "lies on the ground", lies, std::nullopt, c.quick ? 240 : 20'000).criteria.lies_still = true;
}

}  // namespace fascia
