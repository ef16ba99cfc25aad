// The commands of fascia. Each returns the exit code; Error and other exceptions are caught once, in main.
#pragma once
#include "app/cli/options.h"
#include "base/interrupt.h"
#include "sim/material/material.h"

namespace fascia {

struct CheckOptions;

inline constexpr int exit_done = 0, exit_failed = 1, exit_usage = 2;  // and exit_interrupted

int command_view(const ViewOptions& options);
int command_render(const RenderOptions& options);
/// Stdout gets a table.
int command_check(const CheckOptions& options);
int command_run(const RunOptions& options);
int command_bench_figures(const BenchOptions& options);
/// `fresh`: measures again what the folder holds.
int command_bench_accuracy(const BenchOptions& options, bool fresh);
/// `against`: an earlier speed.csv, or empty.
int command_bench_speed(const BenchOptions& options, const std::string& against);
int command_bench_skip(const BenchOptions& options);
/// The pairs' cases whose name has a part that matches `only` (empty: all), with that material model.
int command_stress(const BenchOptions& options, const std::string& only, MaterialModel model);
/// Without scenes: three shipped ones.
int command_soak(const BenchOptions& options, const std::vector<std::string>& scenes, long steps);
int command_info(const InfoOptions& options);
int command_convert(const ConvertOptions& options);

}  // namespace fascia
