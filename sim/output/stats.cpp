#include "sim/output/stats.h"
#include "sim/contact/pair_search.h"
#include "sim/contact/tissue/penetration.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/file.h"

namespace fascia {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json to_json(const Percentiles& p) { return {{"median", p.median}, {"p95", p.p95}, {"max", p.max}}; }

Json contact_forces(const Model& model, const std::vector<ToolLoad>& loads) {
  Json contact = Json::object();
  for (std::size_t t = 0; t < loads.size(); ++t)
    contact[model.tools[t].name] = {{"force_N", to_json(loads[t].force)},
                                    {"torque_Nm", to_json(loads[t].torque)},
                                    {"normal_N", loads[t].normal},
                                    {"points", loads[t].points},
                                    {"deepest_m", loads[t].deepest}};
  return contact;
}

Json tissue_contact(const Model& model, const RunStats& stats, const State& last) {
  Json between = Json::array();
  for (const PairLoad& load : stats.pair_loads)
    between.push_back({{"bodies", {model.bodies[load.bodies[0]].name, model.bodies[load.bodies[1]].name}},
                       {"force_N", to_json(load.force)},
                       {"normal_N", load.normal},
                       {"points", load.pairs},
                       {"deepest_m", load.deepest}});
  return {{"skin_m", PairSearch(model).skin()},
          {"between", between},
          {"steps_taken_back", stats.taken_back},
          {"search_ms_per_step", stats.steps > 0 ? stats.pair_search_ms / static_cast<double>(stats.steps) : 0},
          {"penetrating_triangles", penetrating_triangles(model, last.displacement)}};
}

// The grabs that pull at the end: those of a scene by their index in its "grabs", those of the mouse or a replay in the
// order in which they began.
Json grab_forces(const Simulation& simulation, const State& last) {
  Eigen::Vector3d total(0, 0, 0);
  Json grabs = Json::array();
  for (const GrabForce& f : forces_of_grabs(simulation.springs(), last.displacement)) {
    total += f.force;
    const bool scripted = f.grab >= kFirstScriptedGrab;
    grabs.push_back(
        {{scripted ? "grabs" : "hand", scripted ? f.grab - kFirstScriptedGrab : f.grab}, {"force", to_json(f.force)}});
  }
  return {{"total", to_json(total)}, {"hands", grabs}};
}

Json supports_of(const Model& model, const State& last, const std::vector<Eigen::Vector3d>& contact) {
  Json supports = Json::array();
  for (const reference::Support& support : reference::support_forces(model, last, contact)) {
    Json entry{{"body", model.bodies[support.body].name}};
    if (support.motion)
      entry["prescribed"] = *support.motion;
    else
      entry["fixed"] = true;
    entry["force"] = to_json(support.force);
    supports.push_back(std::move(entry));
  }
  return supports;
}

Json to_json(const Errors& errors) {
  Json json = Json::object();
  if (errors.solver) {
    json["solver"] = *errors.solver;
    if (errors.solver_over_run) json["solver_over_run"] = *errors.solver_over_run;
    json["solver_step"] = errors.solver_step;
    json["solver_worst_s"] = errors.solver_time;
    json["solver_steps"] = errors.solver_steps;
  }
  if (errors.time) {
    json["time"] = errors.time->relative;
    json["time_over_run"] = errors.time->over_run;
    json["time_order"] = errors.time->order;
    json["time_resolved"] = errors.time->resolved;
  }
  json["mesh"] = errors.mesh;
  json["mesh_state"] = errors.mesh_state;
  if (errors.mesh_over_run) json["mesh_over_run"] = *errors.mesh_over_run;
  Json& peak = json["peak_stress"] = Json::object();
  if (errors.peak_stress.solver) peak["solver"] = *errors.peak_stress.solver;
  if (errors.time) peak["time"] = errors.time->peak_stress;
  peak["mesh"] = errors.peak_stress.mesh;
  peak["recovered_Pa"] = errors.peak_recovered;
  peak["tets_Pa"] = errors.peak_of_tets;
  return json;
}

}  // namespace

Percentiles percentiles(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * (values.size() - 1)))];
  };
  return {at(0.5), at(0.95), values.back()};
}

void count_work(RunStats& stats, Simulation& simulation) {
  stats.dispatches_per_step = simulation.gpu()->dispatches_per_step();
  stats.kernels = simulation.programs()->size();
  stats.gpu_bytes = gl::allocated_bytes();
  stats.gpu_buffers = gl::bytes_by_buffer();
  stats.taken_back = simulation.taken_back();
  stats.pair_search_ms = simulation.gpu()->pair_search_ms();
}

void write_stats(const std::filesystem::path& path, const RunStats& stats, const Simulation& simulation,
                 const State& last) {
  const std::vector<Eigen::Vector3d> contact = simulation.contact_forces();
  const reference::Measures measures = reference::measure(simulation.model, last, contact);
  const Json supports = supports_of(simulation.model, last, contact);
  Json json{{"version", FASCIA_VERSION},
            {"renderer", stats.renderer},
            {"method", simulation.uses_reference() ? "newton" : name_of(simulation.scene.solver.method)},
            {"acceleration", simulation.uses_reference() ? "none" : name_of(simulation.scene.solver.acceleration)},
            {"integrator", name_of(simulation.scene.solver.integrator)},
            {"vertices", simulation.model.rest_positions.size()},
            {"tets", simulation.model.tets.size()},
            {"steps", stats.steps},
            {"steps_asleep", simulation.steps_asleep()},
            {"time_step", simulation.scene.solver.time_step},
            {"substeps", simulation.scene.solver.substeps},
            {"time", last.time},
            {"iterations_per_step", simulation.mean_iterations() * simulation.scene.solver.substeps},
            {"wall_s", stats.wall_s},
            {"ms_per_step", to_json(percentiles(stats.step_ms))},
            {"solve_ms_per_step", to_json(percentiles(stats.solve_ms))},
            {"residual", stats.residual},
            {"nan", !is_finite(last)},
            {"inverted", measures.inverted},
            {"J", {measures.min_det_f, measures.max_det_f}},
            {"max_von_mises_Pa", measures.max_von_mises},
            {"kinetic_J", measures.kinetic},
            {"elastic_J", measures.elastic},
            {"gravitational_J", measures.gravitational},
            {"volume_ratio", measures.volume_ratio},
            {"momentum", to_json(measures.momentum)},
            {"angular_momentum", to_json(measures.angular_momentum)},
            {"reaction_N", {{"fixed", to_json(measures.fixed_reaction)}, {"supports", supports}}},
            {"grab_N", grab_forces(simulation, last)},
            {"dispatches_per_step", stats.dispatches_per_step},
            {"kernels", stats.kernels},
            {"gpu_bytes", stats.gpu_bytes},
            {"gpu_buffers", stats.gpu_buffers}};
  if (const GpuSolver* gpu = simulation.gpu(); gpu && !simulation.uses_reference()) {
    json["tets_solved"] = gpu->buffers().tet_count;
    json["share_solved"] = gpu->share_solved();
    json["bytes_per_iteration"] = gpu->bytes_per_iteration();
  }
  if (!stats.tool_loads.empty()) json["contact"] = contact_forces(simulation.model, stats.tool_loads);
  if (simulation.model.touches_tissue()) json["tissue_contact"] = tissue_contact(simulation.model, stats, last);
  if (stats.recovered) {
    json["max_recovered_von_mises_Pa"] = stats.recovered->max;
    json["p99_recovered_von_mises_Pa"] = stats.recovered->p99;
  }
  if (stats.imbalance) json["imbalance"] = *stats.imbalance;
  if (stats.error) json["error"] = *stats.error;
  if (stats.errors) json["errors"] = to_json(*stats.errors);
  for (const auto& [keyword, text] : stats.provenance) json["provenance"][keyword] = text;
  write_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace fascia
