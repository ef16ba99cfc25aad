// fascia bench figures: measures and draws what the poster shows in its four figures, and what colorings cost.
// fascia bench accuracy: error against iterations and time, every method and acceleration.
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>

#include "app/bench.h"
#include "app/bench_accuracy.h"
#include "app/commands.h"
#include "app/gnuplot.h"
#include "sim/error.h"

namespace fascia {
namespace {

int run_bench(const BenchOptions& options, const std::string& name, const std::string& without_gnuplot,
              const std::function<void(Bench&)>& measure) {
  const auto start = std::chrono::steady_clock::now();
  try {
    Bench bench(options, name);
    bench.say(describe(bench.graphics));
    if (!bench.has_gnuplot) bench.say("no gnuplot: " + without_gnuplot + " only");
    measure(bench);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    bench.say(options.out + ", after " + std::to_string(std::lround(elapsed.count())) + " s");
    if (!bench.has_gnuplot) throw Error(options.out, "no charts without gnuplot", kGnuplotPackage);
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
  return exit_done;
}

}  // namespace

int command_bench_figures(const BenchOptions& options) {
  return run_bench(options, "figures", "tables and pictures", [](Bench& bench) {
    bench_scenes(bench);
    bench_stiff_beam(bench);
    bench_convergence(bench);
    bench_colorings(bench);
  });
}

int command_bench_accuracy(const BenchOptions& options, bool fresh) {
  return run_bench(options, "accuracy", "tables",
                   [&](Bench& bench) { bench_accuracy(bench, accuracy_grid(options.quick), fresh); });
}

}  // namespace fascia
