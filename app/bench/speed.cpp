#include "app/bench/speed.h"

#include "app/bench/beam.h"
#include "app/bench/box.h"
#include "app/bench/device.h"
#include "app/bench/timing.h"
#include "app/system/process_memory.h"
#include "render/target/framebuffer.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"

namespace fascia {
namespace {

constexpr int kIterations = 10;
constexpr std::size_t kFewPairs = 500'000;  // tets, above which only the best choice of every method is measured

std::vector<std::size_t> sizes_of(const Bench& bench) {
  return bench.full_or_quick<std::vector<std::size_t>>({500, 5'000, 20'000, 100'000, 1'000'000}, {500, 5'000});
}

SolverSettings settings_of(const SolverChoice& pair) {
  SolverSettings settings;
  settings.method = pair.method;
  settings.acceleration = pair.acceleration;
  settings.iterations = kIterations;
  return settings;
}

int repetitions_for(const Bench& bench, std::size_t tets) {
  return bench.full_or_quick(tets < 50'000 ? 15 : tets < kFewPairs ? 7 : 3, 3);
}

Table speed_table() {
  Table table;
  table.notes = {"boxes of cells cut into 6 tets, one end held, E = 1e6 Pa, nu = 0.3, from a bend and twist at rest; " +
                     std::to_string(kIterations) + " iterations a step of 1/60 s",
                 "the pairs take turns; ms_per_step: medians, prediction and velocities included; _low, _high: a tenth "
                 "is below, above",
                 "bytes_per_iteration: every buffer that a kernel uses, once; gigabytes_per_s: that over the time; "
                 "share_of_copy: of what copying a buffer reaches (device.csv)"};
  table.columns = {"tets",
                   "vertices",
                   "method",
                   "acceleration",
                   "repetitions",
                   "dispatches_per_step",
                   "gpu_bytes",
                   "bytes_per_iteration",
                   "ms_per_step",
                   "ms_per_step_low",
                   "ms_per_step_high",
                   "ns_per_tet_iteration",
                   "gigabytes_per_s",
                   "share_of_copy"};
  return table;
}

// Measures every choice on one mesh; adds to both tables.
void measure_pairs(Bench& bench, const Model& model, const DeviceSpeed& device, Table& table,
                   std::vector<SpeedRow>& rows) {
  const bool one_of_each = bench.options.quick || model.tets.size() >= kFewPairs;
  std::vector<SolverChoice> pairs;
  const int repetitions = repetitions_for(bench, model.tets.size());
  const State start = bent_beam(model);
  std::vector<std::unique_ptr<GpuSolver>> solvers;
  std::vector<GpuSolver*> timed;
  std::vector<std::size_t> bytes;
  for (const SolverChoice& pair : solver_choices()) {
    bench.stop_if_interrupted();
    if (one_of_each &&
        std::any_of(pairs.begin(), pairs.end(), [&](const SolverChoice& other) { return other.method == pair.method; }))
      continue;
    const std::size_t before = gl::allocated_bytes();
    try {
      solvers.push_back(std::make_unique<GpuSolver>(*bench.graphics.programs, model, settings_of(pair)));
    } catch (const Error& error) {  // too large for the device's blocks
      bench.say("left out, " + name_of(pair) + ": " + error.what());
      continue;
    }
    pairs.push_back(pair);
    bytes.push_back(gl::allocated_bytes() - before);
    timed.push_back(solvers.back().get());
  }
  const std::vector<Spread> spreads = time_iterations(timed, start, repetitions);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    Spread ms = spreads[i];
    for (double* value : {&ms.median, &ms.low, &ms.high}) *value *= kIterations;
    const double ns = 1e6 * spreads[i].median / static_cast<double>(model.tets.size()),
                 moved = timed[i]->bytes_per_iteration();
    const double gigabytes_per_s = moved / (1e6 * spreads[i].median);
    const std::string method = name_of(pairs[i].method), acceleration = name_of(pairs[i].acceleration);
    table.rows.push_back({model.tets.size(), model.rest_positions.size(), method, acceleration, repetitions,
                          timed[i]->dispatches_per_step(), bytes[i], moved, ms.median, ms.low, ms.high, ns,
                          gigabytes_per_s, gigabytes_per_s / device.copy_gigabytes_per_s});
    rows.push_back({std::to_string(model.tets.size()) + " tets, " + method + " + " + acceleration, ms});
  }
}

// Measures the kernels of a step, with the default choice.
void measure_kernels(Bench& bench, const Model& model, const DeviceSpeed& device, Table& table) {
  GpuSolver solver(*bench.graphics.programs, model, settings_of(solver_choices().front()));
  const State start = bent_beam(model);
  std::map<std::string, std::vector<double>> times;
  std::vector<double> whole;
  warm_up([&] { solver.step(); });
  std::map<std::string, KernelTime> last;
  for (int turn = 0; turn <= repetitions_for(bench, model.tets.size()); ++turn) {
    bench.stop_if_interrupted();
    solver.upload(start);
    for (auto& [kernel, time] : solver.timed_step()) {
      if (turn > 0) times[kernel].push_back(time.ms);
      last[kernel] = time;
    }
    solver.upload(start);
    if (const double ms = milliseconds_of([&] { solver.step(); }); turn > 0) whole.push_back(ms);
  }
  const double whole_ms = spread_of(std::move(whole)).median;
  double sum_ms = 0, sum_bytes = 0;
  int sum_runs = 0;
  const auto add = [&](const std::string& kernel, int runs, double bytes, double ms) {
    std::vector<Cell> row{model.tets.size(), kernel, runs, ms,
                          1e6 * ms / static_cast<double>(std::max(runs, 1)) / static_cast<double>(model.tets.size())};
    if (bytes > 0) {
      const double gigabytes_per_s = 1e-6 * bytes / ms;
      row.insert(row.end(), {bytes / runs, gigabytes_per_s, gigabytes_per_s / device.copy_gigabytes_per_s});
    } else {
      row.resize(row.size() + 3);
    }
    table.rows.push_back(std::move(row));
  };
  for (auto& [kernel, values] : times) {
    const double ms = spread_of(std::move(values)).median;
    add(kernel, last[kernel].runs, last[kernel].bytes, ms);
    sum_ms += ms;
    sum_bytes += last[kernel].bytes;
    sum_runs += last[kernel].runs;
  }
  add("the whole step, untimed", 1, sum_bytes, whole_ms);
  // Of a GPU, on which a pass waits for the one before it. Software renderers run fused programs of several kernels.
  if (gl::device().timestamp_bits > 0) add("gaps between kernels", sum_runs, 0, std::max(0.0, whole_ms - sum_ms));
}

// Measures the time from a file to the first steps and pictures, once.
void measure_opening(Bench& bench, const Eigen::Vector3i& cells, Table& table) {
  const std::filesystem::path mesh = bench.folder / "speed.msh";
  write_mesh(mesh, make_box(cells.x(), cells.y(), cells.z(), {1, 0.25, 0.25}));
  const std::size_t file_bytes = std::filesystem::file_size(mesh);
  std::optional<Scene> scene;
  std::optional<Model> model;
  const double read_ms = milliseconds_of([&] {
    scene = open_scene(mesh);
    model = settled_model(*scene);
  });
  std::error_code ignored;
  std::filesystem::remove(mesh, ignored);
  const std::size_t bytes_before = gl::allocated_bytes();
  std::unique_ptr<Session> session;
  const double session_ms = milliseconds_of([&] {
    session = std::make_unique<Session>(bench.graphics, std::move(*scene), std::move(*model), false);
    session->simulation.gpu()->finish_background();
  });
  Framebuffer framebuffer(bench.options.width, bench.options.height, gl::device().software ? 1 : 4);
  const double first_ms = milliseconds_of([&] {
    session->simulation.step();
    session->draw(framebuffer);
  });
  std::vector<double> step_ms, draw_ms;
  for (int turn = 0; turn < repetitions_for(bench, 6u * static_cast<std::size_t>(cells.prod())); ++turn) {
    bench.stop_if_interrupted();
    step_ms.push_back(milliseconds_of([&] { session->simulation.step(); }));
    draw_ms.push_back(milliseconds_of([&] { session->draw(framebuffer); }));
  }
  const Model& opened = session->simulation.model;
  table.rows.push_back({opened.tets.size(), opened.rest_positions.size(), file_bytes, read_ms, session_ms, first_ms,
                        spread_of(step_ms).median, spread_of(draw_ms).median, gl::allocated_bytes() - bytes_before,
                        resident_bytes()});
}

}  // namespace

std::vector<SpeedRow> bench_speed(Bench& bench) {
  Table speed = speed_table(), meshes, kernels;
  meshes.notes = {
      "a mesh file opened as the window opens it, with the default material and solver; read_ms: file to model; "
      "open_ms: model to a scene that can step and be drawn",
      "first_ms: the first step and picture; step_ms, draw_ms: medians of those after it, " +
          std::to_string(bench.options.width) + "x" + std::to_string(bench.options.height) + " pixels"};
  meshes.columns = {"tets",     "vertices", "file_bytes", "read_ms",   "open_ms",
                    "first_ms", "step_ms",  "draw_ms",    "gpu_bytes", "resident_bytes"};
  kernels.notes = {
      "one step with " + name_of(solver_choices().front()) + "; ms: of all runs of the step, median; " +
          (gl::device().timestamp_bits == 0 ? "every pass waited for" : "between timestamps of the device"),
      "bytes_per_run: every buffer that the kernel uses, once; share_of_copy: of what copying a buffer "
      "reaches (device.csv)"};
  kernels.columns = {"tets",          "kernel",          "runs",         "ms", "ns_per_tet_run",
                     "bytes_per_run", "gigabytes_per_s", "share_of_copy"};
  std::vector<SpeedRow> rows;
  bench.say("speed: the device");
  const DeviceSpeed device = measure_device(*bench.graphics.programs, bench.full_or_quick<std::size_t>(256, 64) << 20);
  bench.write("device", table_of(device));
  for (const std::size_t tets : sizes_of(bench)) {
    const Eigen::Vector3i cells = cells_of(tets);
    bench.say("speed: " + std::to_string(6 * cells.prod()) + " tets");
    {
      const Model model = box_model(cells);
      measure_pairs(bench, model, device, speed, rows);
      measure_kernels(bench, model, device, kernels);
    }
    bench.write("speed", speed);
    bench.write("kernels", kernels);
    measure_opening(bench, cells, meshes);
    bench.write("meshes", meshes);
  }
  return rows;
}

std::vector<std::string> compare_with(Bench& bench, const std::filesystem::path& against,
                                      const std::vector<SpeedRow>& now) {
  Table table;
  table.notes = {"against: " + against.string(), "ratio: median now over median then"};
  table.columns = {"what", "ratio", "slower"};
  std::vector<std::string> slower;
  for (const SpeedChange& change : compare_speeds(read_speeds(against), now)) {
    table.rows.push_back({"\"" + change.name + "\"", change.ratio, change.slower ? "yes" : "no"});
    char ratio[32];
    std::snprintf(ratio, sizeof ratio, "%.2f", change.ratio);
    if (change.slower) slower.push_back(change.name + ": " + ratio + " times the time it took");
  }
  bench.write("compared", std::move(table));
  return slower;
}

}  // namespace fascia
