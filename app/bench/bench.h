// The common part of the benchmarks of `fascia bench`: graphics, output folder, and a description of the machine.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/bench/table.h"
#include "app/charts/chart.h"
#include "app/session/graphics.h"
#include "app/session/session.h"
#include "sim/output/run_provenance.h"

namespace fascia {

struct Interrupted {};  // thrown between work items after Ctrl-C

class Bench {
 public:
  /// Creates the output folder and the context. `name` is that of the command, "figures". Throws Error.
  Bench(const BenchOptions& options, const std::string& name);

  const BenchOptions& options;
  std::filesystem::path folder;
  Graphics graphics;
  const bool has_gnuplot;

  template <class T>
  T full_or_quick(T full, T quick) const {
    return options.quick ? quick : full;
  }
  /// Prints one line on stderr, unless quiet. Throws Interrupted after Ctrl-C, as does stop_if_interrupted().
  void say(const std::string& line) const;
  void stop_if_interrupted() const;

  /// The head of every table: version, renderer, machine.
  const std::vector<std::string>& notes() const { return notes_; }
  /// Writes NAME.csv, with the notes of every table.
  void write(const std::string& name, Table table) const;
  void write(const std::string& name, const Image& picture, Session& session, long step) const;  // NAME.png
  void draw(const std::string& name,
            const Chart& chart) const;  // NAME.svg, ... as asked for; no effect without gnuplot

 private:
  std::vector<std::string> notes_;
};

std::string name_of(const SolverChoice& pair);   // "jacobi + chebyshev", as in scene files
std::string label_of(const SolverChoice& pair);  // for legends

/// The parts, in the order of the I3D 2019 paper. Each writes its files and throws Error or Interrupted.
void bench_scenes(Bench& bench);       // figure 1: the two scenes and their times
void bench_stiff_beam(Bench& bench);   // figure 2: a stiff beam after half a second
void bench_convergence(Bench& bench);  // figures 3 and 4: strain against iterations and time
void bench_colorings(Bench& bench);    // colors, their balance and their cost

}  // namespace fascia
