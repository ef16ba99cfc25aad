// fascia bench figures: measures and draws what the poster shows in its four figures, and what colorings cost.
// fascia bench accuracy: error against iterations and time, every method and acceleration.
// fascia bench speed and skip: what steps cost, and what features cost that are off.
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>

#include "app/bench/accuracy/accuracy.h"
#include "app/bench/bench.h"
#include "app/bench/gnuplot.h"
#include "app/bench/skip.h"
#include "app/bench/speed.h"
#include "app/commands/command.h"
#include "base/error.h"

namespace fascia {
namespace {

// `measure` returns what it found wrong, a line each.
int run_bench(const BenchOptions& options, const std::string& name,
              const std::function<std::vector<std::string>(Bench&)>& measure) {
  const auto start = std::chrono::steady_clock::now();
  try {
    Bench bench(options, name);
    bench.say(describe(bench.graphics));
    const std::vector<std::string> failures = measure(bench);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    bench.say(options.out + ", after " + std::to_string(std::lround(elapsed.count())) + " s");
    for (const std::string& failure : failures) std::cerr << "fascia: " << failure << '\n';
    return failures.empty() ? exit_done : exit_failed;
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
}

int run_bench_with_charts(const BenchOptions& options, const std::string& name, const std::string& without_gnuplot,
                          const std::function<void(Bench&)>& measure) {
  return run_bench(options, name, [&](Bench& bench) {
    if (!bench.has_gnuplot) bench.say("no gnuplot: " + without_gnuplot + " only");
    measure(bench);
    if (!bench.has_gnuplot) throw Error(options.out, "no charts without gnuplot", kGnuplotPackage);
    return std::vector<std::string>();
  });
}

}  // namespace

int command_bench_figures(const BenchOptions& options) {
  return run_bench_with_charts(options, "figures", "tables and pictures", [](Bench& bench) {
    bench_scenes(bench);
    bench_stiff_beam(bench);
    bench_convergence(bench);
    bench_colorings(bench);
  });
}

int command_bench_accuracy(const BenchOptions& options, bool fresh) {
  return run_bench_with_charts(options, "accuracy", "tables",
                               [&](Bench& bench) { bench_accuracy(bench, accuracy_grid(options.quick), fresh); });
}

int command_bench_speed(const BenchOptions& options, const std::string& against) {
  if (!against.empty()) read_speeds(against);  // what cannot be read is said before an hour is spent
  return run_bench(options, "speed", [&](Bench& bench) {
    const std::vector<SpeedRow> now = bench_speed(bench);
    return against.empty() ? std::vector<std::string>() : compare_with(bench, against, now);
  });
}

int command_bench_skip(const BenchOptions& options) { return run_bench(options, "skip", bench_skip); }

}  // namespace fascia
