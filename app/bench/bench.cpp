#include "app/bench/bench.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <system_error>
#include <thread>

#include "app/charts/gnuplot.h"
#include "base/byte_hash.h"
#include "base/error.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "sim/replay/replay.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

fs::path made_folder(const std::string& name) {
  std::error_code ec;
  fs::create_directories(name, ec);
  if (ec || !fs::is_directory(name, ec))
    throw Error(name, "cannot be made: " + ec.message(), "expected a folder for the output");
  return name;
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown processor";
}

// Hash of the program and its kernels: an interrupted benchmark continues only with the same build.
std::string build_hash(const fs::path& shaders) {
  std::vector<fs::path> files{fs::read_symlink("/proc/self/exe")};
  for (const auto& entry : fs::recursive_directory_iterator(shaders))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin() + 1, files.end());
  ByteHash hash;
  for (const fs::path& file : files) {
    const std::string bytes = read_file(file);
    hash.add({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  }
  return hash_text(hash.value());
}

}  // namespace

Bench::Bench(const BenchOptions& o, const std::string& name)
    : options(o), folder(made_folder(o.out)), graphics(open_graphics(o, false)), has_gnuplot(gnuplot_installed()) {
  const char* threads = std::getenv("LP_NUM_THREADS");
  notes_ = {std::string("fascia ") + FASCIA_VERSION + ", bench " + name + (options.quick ? " --quick" : ""),
            "build: " + build_hash(graphics.data_dir / "shaders"), "renderer: " + describe(graphics),
            "machine: " + processor() + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores",
            std::string("LP_NUM_THREADS: ") + (threads ? threads : "not set")};
}

void Bench::stop_if_interrupted() const {
  if (interrupted()) throw Interrupted{};
}

void Bench::say(const std::string& line) const {
  stop_if_interrupted();
  if (!options.quiet) std::cerr << "fascia: " << line << '\n';
}

void Bench::write(const std::string& name, Table table) const {
  table.notes.insert(table.notes.begin(), notes_.begin(), notes_.end());
  write_table(folder / (name + ".csv"), table);
}

void Bench::write(const std::string& name, const Image& picture, Session& session, long step) const {
  const Simulation& simulation = session.simulation;
  // Without --out: these pictures are meant for publication and must not contain the user's paths.
  const std::string command = std::string("fascia bench figures") + (options.quick ? " --quick" : "");
  write_png(folder / (name + ".png"), picture,
            provenance_of(simulation.scene, simulation.model, session.renderer_description(), command, step,
                          simulation.time()));
}

void Bench::draw(const std::string& name, const Chart& chart) const {
  for (const std::string& ending : options.charts)
    if (has_gnuplot) write_chart(folder / (name + ending), chart);
}

std::string name_of(const SolverChoice& pair) {
  return std::string(name_of(pair.method)) + " + " + name_of(pair.acceleration);
}

std::string label_of(const SolverChoice& pair) {
  const std::string method = label_of(pair.method);
  return pair.acceleration == Acceleration::none ? method : method + " + " + label_of(pair.acceleration);
}

}  // namespace fascia
