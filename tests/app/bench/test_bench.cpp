// fascia bench figures in its quick form: every file exists, and the tables are readable and consistent.
// Covers: app/bench/figures/beam_step, app/bench/figures/colorings, app/bench/figures/convergence
// Covers: app/bench/figures/picture_grid, app/bench/figures/scenes, app/bench/figures/stiff_beam, app/commands/bench
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "base/file.h"
#include "render/target/image.h"
#include "sim/scene/settings/solver_settings.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

using Row = std::map<std::string, std::string>;  // column, cell

struct CsvFile {
  std::string notes;
  std::vector<Row> rows;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

CsvFile read_csv(const fs::path& path) {
  CsvFile csv;
  std::istringstream in(read_file(path));
  std::vector<std::string> columns;
  for (std::string line; std::getline(in, line);) {
    CAPTURE(path, line);
    if (line.rfind("# ", 0) == 0) {
      CHECK(columns.empty());
      csv.notes += line + "\n";
    } else if (columns.empty()) {
      columns = cells_of(line);
    } else {
      const std::vector<std::string> cells = cells_of(line);
      REQUIRE(cells.size() == columns.size());
      Row row;
      for (std::size_t c = 0; c < cells.size(); ++c) row[columns[c]] = cells[c];
      csv.rows.push_back(row);
    }
  }
  REQUIRE(!csv.rows.empty());
  for (const char* fact : {"# fascia ", "# renderer: ", "# machine: ", "# LP_NUM_THREADS: "}) {
    CAPTURE(path, fact);
    CHECK(csv.notes.find(fact) != std::string::npos);
  }
  return csv;
}

double number(const Row& row, const std::string& column) {
  CAPTURE(column);
  REQUIRE(row.count(column) == 1);
  std::size_t end = 0;
  const double value = std::stod(row.at(column), &end);
  CHECK(end == row.at(column).size());
  return value;
}

std::vector<Row> rows_of(const CsvFile& csv, const SolverChoice& pair) {
  std::vector<Row> rows;
  std::copy_if(csv.rows.begin(), csv.rows.end(), std::back_inserter(rows), [&](const Row& row) {
    return row.at("method") == name_of(pair.method) && row.at("acceleration") == name_of(pair.acceleration);
  });
  return rows;
}

CommandResult run_figures(const fs::path& folder, const std::string& path = std::getenv("PATH")) {
  return run_command({"/usr/bin/env", "PATH=" + path, FASCIA_BINARY, "bench", "figures", "--quick", "--quiet",
                      "--context", "osmesa", "--size", "320x180", "--out", folder.string()});
}

}  // namespace

TEST_CASE("bench figures, quick form", "[bench]") {
  const TemporaryFolder parent;
  const fs::path folder = parent / "new/figures";
  const CommandResult result = run_figures(folder);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  for (const auto& entry : fs::directory_iterator(folder)) CHECK(entry.path().filename().string().front() != '.');

  for (const char* scene : {"fig1_liver.png", "fig1_ligament.png"}) {
    const Image picture = read_png(folder / scene);
    CHECK(picture.width == 320);
    CHECK(picture.height == 180);
  }
  for (const char* picture : {"fig2.png", "fig2_exact.png", "fig2_jacobi_none.png", "fig3_iterations.png",
                              "fig3_time.png", "fig4.png", "colorings.png"}) {
    CAPTURE(picture);
    CHECK(read_png(folder / picture).width > 100);
  }
  for (const char* chart : {"fig3_iterations.svg", "fig3_time.svg", "fig4.svg", "colorings.svg"}) {
    CAPTURE(chart);
    const std::string svg = read_file(folder / chart);
    CHECK(svg.find("</svg>") != std::string::npos);
    if (chart != std::string("colorings.svg")) CHECK(svg.find("Exact step") != std::string::npos);
  }

  for (const Row& row : read_csv(folder / "fig1.csv").rows) {
    CHECK(number(row, "solve_ms") > 0);
    CHECK(number(row, "draw_ms_low") <= number(row, "draw_ms"));
    CHECK(number(row, "frames_per_second") == Approx(1000 / number(row, "frame_ms")).epsilon(1e-3));
  }
  const CsvFile beams = read_csv(folder / "fig2.csv");
  CHECK(beams.rows.back().at("method") == "exact");
  CHECK(number(beams.rows.back(), "relative_error") == 0);
  CHECK(number(beams.rows.back(), "tip_deflection_m") > 0);

  for (const auto& [traces_name, last_name] :
       {std::pair("fig3.csv", "fig3_target.csv"), std::pair("fig4.csv", "fig4_last.csv")}) {
    CAPTURE(traces_name);
    const CsvFile traces = read_csv(folder / traces_name), last = read_csv(folder / last_name);
    CHECK(traces.notes.find("rms_strain of the exact step: ") != std::string::npos);
    const double start = number(traces.rows.front(), "rms_strain");
    CHECK(start == Approx(0.1).epsilon(0.3));
    for (const SolverChoice& pair : i3d2019_choices()) {
      CAPTURE(name_of(pair.method), name_of(pair.acceleration));
      const std::vector<Row> trace = rows_of(traces, pair), of_last = rows_of(last, pair);
      REQUIRE(trace.size() > 10);
      REQUIRE(of_last.size() == 1);
      CHECK(trace.front().at("iteration") == "0");
      // Sums in another order of tets have different rounding.
      CHECK(number(trace.front(), "rms_strain") == Approx(start).epsilon(1e-5));
      CHECK(trace.back().at("rms_strain") == of_last.front().at("last_rms_strain"));
    }
  }

  for (const Row& row : read_csv(folder / "colorings.csv").rows) {
    const bool plain = row.at("colors_asked") == "0";
    const double colors = number(row, "colors");
    CHECK(number(row, "smallest_color") <= number(row, "largest_color"));
    CHECK(number(row, "smallest_color") * colors <= number(row, "tets"));
    CHECK(number(row, "largest_color") * colors >= number(row, "tets"));
    CHECK((plain || colors <= number(row, "colors_asked")));
    CHECK((number(row, "phantoms") == 0 || !plain));
    CHECK(number(row, "dispatches") == 1);  // fused
  }
}

TEST_CASE("bench figures without gnuplot writes the tables and names the package", "[bench]") {
  const TemporaryFolder folder, no_tools;
  const CommandResult result = run_figures(folder.path(), no_tools.path().string());
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("gnuplot-nox") != std::string::npos);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  for (const char* table :
       {"fig1.csv", "fig2.csv", "fig3.csv", "fig3_target.csv", "fig4.csv", "fig4_last.csv", "colorings.csv"}) {
    CAPTURE(table);
    CHECK(fs::exists(folder / table));
  }
  CHECK(fs::exists(folder / "fig2_exact.png"));
  CHECK(!fs::exists(folder / "fig4.png"));
}

TEST_CASE("bench figures needs a folder", "[bench]") {
  CHECK(run_fascia({"bench"}).exit_code == 2);
  CHECK(run_fascia({"bench", "figures"}).exit_code == 2);
  const TemporaryFolder folder;
  write_file(folder / "file", "not a folder");
  const CommandResult result = run_fascia({"bench", "figures", "--quick", "--out", (folder / "file").string()});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("file: ") != std::string::npos);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
}
