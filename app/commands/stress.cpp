// fascia stress: the stress suite as CSV and Markdown, and for every failure a replay and a picture.
#include <algorithm>
#include <iostream>
#include <map>

#include "app/bench/bench.h"
#include "app/cli/command_line.h"
#include "app/cli/discretization.h"
#include "app/cli/name_pattern.h"
#include "app/commands/command.h"
#include "app/stress/stress.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/material/tissues.h"
#include "sim/scene/scene_carry.h"

namespace fascia {
namespace {

namespace fs = std::filesystem;

struct StressOptions : BenchOptions {
  std::string only, model;
  Discretization discretization;
};

struct Row {
  SolverChoice pair;
  StressCase made;
  StressResult result;
  fs::path replay;  // of a failure, relative to the output folder
  bool passed() const { return result.failures.empty(); }
};

std::string full_name(const StressCase& made, const SolverChoice& pair) {
  return made.group + "/" + made.name + "/" + name_of(pair);
}

std::string file_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  return name;
}

std::string joined(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

// Writes the replay, and a picture of its last state.
void keep_failure(Bench& bench, Row& row) {
  const std::string name = file_name(full_name(row.made, row.pair));
  Replay replay = row.made.replay;
  replay.steps = row.result.steps;
  row.replay = fs::path("failures") / (name + ".fascia");
  std::error_code ec;
  fs::create_directories(bench.folder / "failures", ec);
  Session session(bench.graphics, replay.scene, false);
  replay.scene = self_contained_if_possible(std::move(replay.scene), session.simulation.model.files);
  write_replay(bench.folder / row.replay, replay);
  session.simulation.play(std::move(replay));
  for (long step = 0; step < row.result.steps; ++step) session.simulation.step();
  Framebuffer framebuffer(bench.options.width, bench.options.height, 1);
  session.settle_range();
  session.draw(framebuffer);
  bench.write("failures/" + name, framebuffer.read(), session, row.result.steps);
}

Table table_of(const std::vector<Row>& rows) {
  Table table;
  table.columns = {"group",    "case",        "method",    "acceleration",   "passed",        "failures",
                   "steps",    "recovered_s", "rms_sizes", "farthest_sizes", "energy_growth", "momentum_growth",
                   "inverted", "least_J",     "elastic_J", "model",          "integrator",    "elements",
                   "replay"};
  for (const Row& row : rows) {
    const StressResult& r = row.result;
    const Scene& scene = row.made.replay.scene;
    table.rows.push_back({row.made.group, row.made.name, name_of(row.pair.method), name_of(row.pair.acceleration),
                          row.passed() ? 1 : 0, joined(r.failures, "; "), r.steps,
                          r.recovered_after >= 0 ? Cell(r.recovered_after) : Cell(), r.rms, r.farthest, r.energy_growth,
                          r.momentum_growth, r.inverted, r.least_volume_ratio, r.elastic,
                          name_of(scene.bodies[0].material.model), name_of(scene.solver.integrator),
                          name_of(scene.bodies[0].elements), row.replay.string()});
  }
  return table;
}

// Solver choices by groups: the number of cases that passed; then every failure on a line.
std::string summary_of(const Bench& bench, const std::vector<Row>& rows) {
  std::vector<std::string> groups;
  std::vector<SolverChoice> pairs;
  std::map<std::pair<std::size_t, std::string>, std::pair<int, int>> counts;  // passed, total
  for (const Row& row : rows) {
    if (std::find(groups.begin(), groups.end(), row.made.group) == groups.end()) groups.push_back(row.made.group);
    if (std::find(pairs.begin(), pairs.end(), row.pair) == pairs.end()) pairs.push_back(row.pair);
    const auto p = static_cast<std::size_t>(std::find(pairs.begin(), pairs.end(), row.pair) - pairs.begin());
    for (const std::string& group : {row.made.group, std::string()}) {
      auto& [passed, all] = counts[{p, group}];
      passed += row.passed();
      ++all;
    }
  }
  std::string text = "# fascia stress\n\n";
  for (const std::string& note : bench.notes()) text += "- " + note + "\n";
  text += "\nCases passed:\n\n| method + acceleration |";
  groups.push_back("");
  for (const std::string& group : groups) text += " " + (group.empty() ? "all" : group) + " |";
  text += "\n|---|";
  for (std::size_t g = 0; g < groups.size(); ++g) text += "---|";
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    text += "\n| " + name_of(pairs[p]) + " |";
    for (const std::string& group : groups) {
      const auto found = counts.find({p, group});
      text += found == counts.end()
                  ? " |"
                  : " " + std::to_string(found->second.first) + " / " + std::to_string(found->second.second) + " |";
    }
  }
  text += "\n\nFailures:\n\n| case | pair | what | replay |\n|---|---|---|---|\n";
  for (const Row& row : rows)
    if (!row.passed())
      text += "| " + row.made.group + ": " + row.made.name + " | " + name_of(row.pair) + " | " +
              joined(row.result.failures, "; ") + " | " + row.replay.string() + " |\n";
  return text;
}

// Without a model the tissue law, or that of Material with methods that do not carry it.
MaterialModel model_for(Method method, const std::string& model) {
  if (!model.empty()) return *find_material_model(model);
  return carries(method, kTissueLaw) ? kTissueLaw : Material().model;
}

int run_stress(const StressOptions& options) {
  const Integrator integrator = *options.discretization.integrator();
  const ElementOrder elements = *options.discretization.elements();
  std::vector<Row> rows;
  bool stopped = false;
  Bench bench(options, "stress");
  try {
    bench.say(describe(bench.graphics));
    for (const SolverChoice& pair : solver_choices()) {
      const MaterialModel model = model_for(pair.method, options.model);
      if (!can_run(pair.method, model, elements)) continue;
      for (StressCase& made : stress_cases(pair, model, integrator, elements, bench.folder, options.quick)) {
        const std::string name = full_name(made, pair);
        if (!matches(name, options.only)) continue;
        bench.stop_if_interrupted();
        Row& row = rows.emplace_back(Row{pair, std::move(made), {}, {}});
        {
          Simulation simulation(row.made.replay.scene, bench.graphics.programs.get(), false);
          simulation.play(row.made.replay);
          row.result = run_stress_case(simulation, row.made.criteria);
        }
        if (row.passed()) continue;
        keep_failure(bench, row);
        bench.say("FAILED " + name + ": " + joined(row.result.failures, "; "));
      }
    }
  } catch (const Interrupted&) {
    stopped = true;
  }
  if (rows.empty() && !stopped)
    throw Error("--only " + options.only, "matches no case", "expected a part of group/case/method + acceleration");
  bench.write("stress", table_of(rows));
  write_file(bench.folder / "summary.md", summary_of(bench, rows));
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return !row.passed(); });
  if (!options.quiet)
    std::cerr << "fascia: " << rows.size() << " cases, " << failed
              << " failed: " << (bench.folder / "summary.md").string() << '\n';
  return stopped ? exit_interrupted : failed > 0 ? exit_failed : exit_done;
}

}  // namespace

void add_stress(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<StressOptions>();
  options->width = 640;
  options->height = 360;
  std::vector<std::string> models;
  for (const MaterialModel m : material_models()) models.push_back(name_of(m));
  CLI::App& command = *program.add_subcommand("stress", "the stress suite: cases that every solver choice must pass");
  command
      .add_option("--out", options->out,
                  "folder for the table, its summary, and a replay and a picture of every failure")
      ->type_name("DIR")
      ->required();
  command.add_flag("--quick", options->quick, "small meshes");
  command
      .add_option("--only", options->only,
                  "cases whose group/case/method + acceleration has such a part; * and ? as in file names")
      ->type_name("PATTERN");
  add_choice(command, "--model", options->model, models,
             std::string("material model of all bodies (default: ") + name_of(kTissueLaw) + ", or " +
                 name_of(Material().model) + " with methods that do not carry it)");
  options->discretization = {name_of(SolverSettings().integrator), name_of(Body().elements)};
  add_discretization(command, options->discretization, "of all cases");
  add_size(command, options->width, options->height);
  add_graphics(command, *options);
  add_examples(command, {"fascia stress --quick --out stress", "fascia stress --only 'start/*two_level' --out stress"},
               "a case fails");
  command.callback([&invocation, options] { invocation.run = [options] { return run_stress(*options); }; });
}

}  // namespace fascia
