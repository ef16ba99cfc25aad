// fascia bench figures: measures and draws what the poster shows in its four figures, and what colorings cost.
#include <chrono>
#include <cmath>
#include <iostream>

#include "app/bench.h"
#include "app/commands.h"
#include "app/gnuplot.h"
#include "sim/error.h"

namespace fascia {

int command_bench_figures(const BenchOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  try {
    Bench bench(options);
    bench.say(describe(bench.graphics));
    if (!bench.has_gnuplot) bench.say("no gnuplot: tables and pictures only");
    bench_scenes(bench);
    bench_stiff_beam(bench);
    bench_convergence(bench);
    bench_colorings(bench);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    bench.say(options.out + ", after " + std::to_string(std::lround(elapsed.count())) + " s");
    if (!bench.has_gnuplot) throw Error(options.out, "no charts without gnuplot", kGnuplotPackage);
  } catch (const Interrupted&) {
    return exit_interrupted;
  }
  return exit_done;
}

}  // namespace fascia
