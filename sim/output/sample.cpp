#include "sim/output/sample.h"

#include <algorithm>
#include <cmath>

#include "base/file.h"
#include "base/number_text.h"
#include "sim/accuracy/nodal_stress.h"
#include "sim/scene/tools/scene_names.h"

namespace fascia {
namespace {

constexpr Column kColumns[] = {{"step", [](const Sample& s) { return static_cast<double>(s.step); }},
                               {"time_s", [](const Sample& s) { return s.time; }},
                               {"kinetic_J", [](const Sample& s) { return s.kinetic; }},
                               {"elastic_J", [](const Sample& s) { return s.elastic; }},
                               {"gravitational_J", [](const Sample& s) { return s.gravitational; }},
                               {"total_J", [](const Sample& s) { return s.total(); }},
                               {"volume_ratio", [](const Sample& s) { return s.volume_ratio; }},
                               {"min_J", [](const Sample& s) { return s.min_det_f; }},
                               {"max_strain", [](const Sample& s) { return s.max_strain; }},
                               {"max_von_mises_Pa", [](const Sample& s) { return s.max_von_mises; }},
                               {"max_recovered_von_mises_Pa", [](const Sample& s) { return s.max_recovered; }, true},
                               {"p99_recovered_von_mises_Pa", [](const Sample& s) { return s.p99_recovered; }, true},
                               {"momentum_x_kg_m_s", [](const Sample& s) { return s.momentum.x(); }},
                               {"momentum_y_kg_m_s", [](const Sample& s) { return s.momentum.y(); }},
                               {"momentum_z_kg_m_s", [](const Sample& s) { return s.momentum.z(); }},
                               {"reaction_x_N", [](const Sample& s) { return s.reaction.x(); }},
                               {"reaction_y_N", [](const Sample& s) { return s.reaction.y(); }},
                               {"reaction_z_N", [](const Sample& s) { return s.reaction.z(); }},
                               {"grab_x_N", [](const Sample& s) { return s.grab.x(); }},
                               {"grab_y_N", [](const Sample& s) { return s.grab.y(); }},
                               {"grab_z_N", [](const Sample& s) { return s.grab.z(); }},
                               {"probe_x_m", [](const Sample& s) { return s.probe.x(); }},
                               {"probe_y_m", [](const Sample& s) { return s.probe.y(); }},
                               {"probe_z_m", [](const Sample& s) { return s.probe.z(); }},
                               {"residual", [](const Sample& s) { return s.residual; }},
                               {"iterations", [](const Sample& s) { return s.iterations; }},
                               {"step_ms", [](const Sample& s) { return s.step_ms; }},
                               {"frame_ms", [](const Sample& s) { return s.frame_ms; }}};

// Replaces line breaks, since a note is one line.
std::string one_line(const std::string& text) {
  std::string line;
  bool indent = false;
  for (const char c : text) {
    if (c == '\n') indent = true;
    if (indent && (c == ' ' || c == '\n')) continue;
    indent = false;
    line += c;
  }
  return line;
}

}  // namespace

std::span<const Column> sample_columns() { return kColumns; }

Sample sample_of(const Diagnostics& d) {
  Sample s;
  s.time = d.time;
  s.kinetic = d.kinetic;
  s.elastic = d.elastic;
  s.gravitational = d.gravitational;
  s.volume_ratio = d.volume_ratio;
  s.min_det_f = d.min_det_f;
  s.max_strain = d.max_strain;
  s.max_von_mises = d.max_von_mises;
  s.momentum = d.momentum;
  s.reaction = d.reaction;
  s.grab = d.grab_force;
  s.tools = d.tool_loads;
  s.pairs = d.pair_loads;
  if (d.probe) s.probe = *d.probe;
  s.residual = d.residual;
  if (d.iterations) s.iterations = *d.iterations;
  return s;
}

Diagnostics diagnostics_by_reference(const Simulation& simulation) {
  const State state = simulation.state();
  const reference::Measures m = reference::measure(simulation.model, state, simulation.contact_forces());
  Diagnostics d;
  d.time = state.time;
  d.kinetic = m.kinetic;
  d.elastic = m.elastic;
  d.gravitational = m.gravitational;
  d.volume_ratio = m.volume_ratio;
  d.min_det_f = m.min_det_f;
  d.max_det_f = m.max_det_f;
  d.inverted = static_cast<int>(m.inverted);
  d.max_strain = m.max_strain;
  d.max_von_mises = m.max_von_mises;
  for (const Eigen::Vector3d& v : state.velocity) d.max_speed = std::max(d.max_speed, v.norm());
  d.momentum = m.momentum;
  d.angular_momentum = m.angular_momentum;
  d.reaction = m.fixed_reaction;
  for (const GrabForce& grab : forces_of_grabs(simulation.springs(), state.displacement)) d.grab_force += grab.force;
  const ContactLoads loads{simulation.newton_tool_loads(), simulation.newton_pair_loads()};
  d.set_loads(loads, loads);
  d.residual = simulation.newton_report().relative_residual;
  d.iterations = simulation.newton_report().iterations;
  return d;
}

Sample sample_now(Simulation& simulation, std::uint32_t probe) {
  Sample s;
  if (simulation.uses_reference()) {
    s = sample_of(diagnostics_by_reference(simulation));
    s.probe = simulation.state().displacement[probe];
  } else {
    simulation.gpu()->set_probe(probe);
    simulation.gpu()->request_diagnostics();
    std::optional<Diagnostics> diagnostics = simulation.gpu()->take_diagnostics(true);
    simulation.correct_contact(diagnostics);
    s = sample_of(*diagnostics);
    if (std::isnan(s.iterations)) s.iterations = simulation.iterations_granted();
  }
  if (!simulation.model.motions.empty())
    s.supports = reference::support_forces(simulation.model, simulation.state(), simulation.contact_forces());
  s.step = simulation.steps_made();
  if (s.step == 0) s.residual = s.iterations = Sample::kUnknown;
  return s;
}

void measure_recovered(Sample& sample, const Simulation& simulation) {
  const PeakStress peak = peak_of(nodal_stress(simulation.model, simulation.state()), simulation.model);
  sample.max_recovered = peak.max;
  sample.p99_recovered = peak.p99;
}

void write_samples(const std::filesystem::path& path, std::span<const Sample> samples, const Model& model,
                   const Provenance& provenance, std::uint32_t probe) {
  NumberText out;
  for (const auto& [keyword, text] : provenance) out.add("# ").add(keyword).add(": ").add(one_line(text)).add('\n');
  out.add("# Probe: vertex ").add(probe).add('\n');
  const std::vector<reference::Support> supports =
      samples.empty() ? std::vector<reference::Support>{} : samples.front().supports;
  for (std::size_t k = 0; k < supports.size(); ++k) {
    out.add("# Support ").add(k).add(": ").add(one_line(model.bodies[supports[k].body].name));
    if (const auto motion = supports[k].motion)
      out.add(", prescribed ").add(*motion).add('\n');
    else
      out.add(", fixed\n");
  }
  std::vector<const Column*> columns;
  for (const Column& column : kColumns)
    if (!column.on_request || std::any_of(samples.begin(), samples.end(),
                                          [&](const Sample& sample) { return std::isfinite(column.value(sample)); }))
      columns.push_back(&column);
  for (const Column* column : columns) out.add(column == columns.front() ? "" : ",").add(column->name);
  for (std::size_t k = 0; k < supports.size(); ++k)
    for (const char* axis : {"_x_N", "_y_N", "_z_N"}) out.add(",support_").add(k).add(axis);
  for (const Tool& tool : model.tools)
    for (const char* value :
         {"_x_N", "_y_N", "_z_N", "_deepest_m", "_torque_x_Nm", "_torque_y_Nm", "_torque_z_Nm", "_normal_N"})
      out.add(",contact_").add(column_name(tool.name)).add(value);
  const std::vector<std::array<std::uint32_t, 2>> pairs = touching_bodies(model);
  for (const auto& [a, b] : pairs) {
    const std::string column =
        ",contact_" + column_name(model.bodies[a].name) + "_" + column_name(model.bodies[b].name);
    for (const char* value : {"_x_N", "_y_N", "_z_N"})
      if (a != b) out.add(column).add(value);
    for (const char* value : {"_normal_N", "_deepest_m"}) out.add(column).add(value);
  }
  out.add('\n');
  const auto add_cell = [&](double value) {
    if (std::isfinite(value)) out.add(value);
  };
  for (const Sample& sample : samples) {
    for (const Column* column : columns) {
      if (column != columns.front()) out.add(',');
      add_cell(column->value(sample));
    }
    for (const reference::Support& support : sample.supports)
      for (const double force : support.force) {
        out.add(',');
        add_cell(force);
      }
    for (const ToolLoad& load : sample.tools)
      for (const double value : {load.force.x(), load.force.y(), load.force.z(), load.deepest, load.torque.x(),
                                 load.torque.y(), load.torque.z(), load.normal}) {
        out.add(',');
        add_cell(value);
      }
    for (const auto& pair : pairs) {
      const PairLoad load = load_between(sample.pairs, pair);
      const auto add_value = [&](double value) {
        out.add(',');
        add_cell(value);
      };
      for (int k = 0; k < 3 && pair[0] != pair[1]; ++k) add_value(load.force[k]);
      add_value(load.normal);
      add_value(load.deepest);
    }
    out.add('\n');
  }
  write_file(path, out.take());
}

std::uint32_t tip_vertex(const Model& model) {
  // Number of supports examined, evenly distributed: enough to distinguish a tip from a root on any mesh
  constexpr std::size_t kMostSupports = 256;
  const std::vector<char> held = model.held();
  std::vector<Eigen::Vector3d> supports;
  for (std::size_t v = 0; v < held.size(); ++v)
    if (held[v]) supports.push_back(model.rest_positions[v]);
  const std::size_t stride = supports.size() / kMostSupports + 1;
  std::vector<char> used(held.size(), 0);
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    for (const std::uint32_t v : model.element(t)) used[v] = 1;
  std::uint32_t tip = 0;
  double farthest = -1;
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v] || !used[v]) continue;
    double nearest = supports.empty() ? model.rest_positions[v].squaredNorm() : 1e300;
    for (std::size_t s = 0; s < supports.size(); s += stride)
      nearest = std::min(nearest, (supports[s] - model.rest_positions[v]).squaredNorm());
    if (nearest <= farthest) continue;
    farthest = nearest;
    tip = static_cast<std::uint32_t>(v);
  }
  return tip;
}

}  // namespace fascia
