// fascia bench accuracy on a beam of 48 tets: its table, the continuation of a first run by a second, and the
// evaluation of the numbers.
// Covers: accuracy, charts, grid, problem, results, summary
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <sstream>

#include "app/bench/accuracy/accuracy.h"
#include "app/bench/accuracy/results.h"
#include "app/bench/accuracy/summary.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
const std::string kColumns =
    "scenario,tets,young_modulus,poisson_ratio,time_step,substeps,method,acceleration,iterations,error,ms_median,ms_"
    "min";

AccuracyGrid tiny_grid() {
  AccuracyGrid grid;
  grid.pairs = {SolverSettings().choice()};
  for (const AccuracyScenario scenario :
       {AccuracyScenario::one_step, AccuracyScenario::grabbed, AccuracyScenario::pressed, AccuracyScenario::settled})
    grid.cases.push_back({scenario, {8, 1, 1}, 1e6, 0.3, 1});
  grid.cases.front().substeps = 2;
  grid.iterations = {1, 4, 16};
  grid.settled_iterations = {1, 8};
  grid.settled_steps = 4;
  grid.repetitions = 2;
  return grid;
}

// Returns the number of measurements.
int run(const fs::path& folder, const AccuracyGrid& grid, bool fresh = false) {
  BenchOptions options;
  options.out = folder.string();
  options.context = "osmesa";
  options.quiet = true;
  Bench bench(options, "accuracy");
  return bench_accuracy(bench, grid, fresh);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line + ",");
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

CaseAccuracy known_case() {
  const auto pair = [](Method method, Acceleration acceleration, std::vector<AccuracyPoint> points) {
    return PairAccuracy{{method, acceleration}, std::move(points)};
  };
  return {
      {},
      {pair(Method::two_level, Acceleration::nonlinear_cg, {{1, 0.5, 1.5, 1}, {5, 0.009, 4, 3}, {10, 0.0009, 8, 7}}),
       pair(Method::two_level, Acceleration::none, {{1, 0.6, 1.4, 1}, {5, 0.2, 4.5, 3}, {10, 0.1, 8.5, 7}}),
       pair(Method::jacobi, Acceleration::none, {{1, 0.9, 0.5, 0.4}, {5, 0.8, 2, 1}, {10, 0.7, 5, 4}}),
       pair(Method::jacobi, Acceleration::anderson_positions,
            {{1, 0.9, 0.6, 0.5}, {5, kNotANumber, kNotANumber, kNotANumber}})}};
}

}  // namespace

TEST_CASE("bench accuracy measures once, and continues", "[bench]") {
  const TemporaryFolder folder;
  AccuracyGrid grid = tiny_grid();
  REQUIRE(run(folder.path(), grid) == 4);
  const std::string table = read_file(folder / "accuracy.csv");
  INFO(table);

  std::vector<std::string> lines = lines_of(table);
  lines.erase(lines.begin(),
              std::find_if(lines.begin(), lines.end(), [](const std::string& l) { return l.rfind("# ", 0) != 0; }));
  for (const char* fact : {"# fascia ", "# renderer: ", "# machine: ", "# LP_NUM_THREADS: "})
    CHECK(table.find(fact) != std::string::npos);
  REQUIRE(lines.size() == 1 + 3 + 3 + 3 + 2);
  CHECK(lines.front() == kColumns);
  CHECK(lines[1].rfind("one_step,48,1000000,0.3,0.01666667,2,two_level,subspace,1,", 0) == 0);
  for (std::size_t row = 1; row < lines.size(); ++row) {
    const std::vector<std::string> cells = cells_of(lines[row]);
    REQUIRE(cells.size() == 12);
    const double error = std::stod(cells[9]);
    CHECK(error > 0);
    CHECK(std::stod(cells[11]) > 0);
    CHECK(std::stod(cells[10]) >= std::stod(cells[11]));
    const std::vector<std::string> before = cells_of(lines[row - 1]);
    if (row > 1 && before[0] == cells[0]) CHECK(error < std::stod(before[9]));
  }
  const std::string summary = read_file(folder / "accuracy.md");
  CHECK(summary.find("| two_level + subspace |") != std::string::npos);
  CHECK(std::count(summary.begin(), summary.end(), '\n') > 20);
  const std::string chart = file_name_of(grid.cases.front());
  for (const char* ending : {"_iterations.svg", "_iterations.png", "_time.svg", "_time.png"}) {
    CAPTURE(chart, ending);
    CHECK(fs::file_size(folder / (chart + ending)) > 1000);
  }

  CHECK(run(folder.path(), grid) == 0);
  CHECK(read_file(folder / "accuracy.csv") == table);

  // Missing entries are measured, existing ones are kept.
  grid.pairs.push_back({Method::jacobi, Acceleration::none});
  grid.cases.pop_back();
  CHECK(run(folder.path(), grid) == 2);
  const std::string more = read_file(folder / "accuracy.csv");
  CHECK(more.find("one_step,48,1000000,0.3,0.01666667,2,jacobi,none,16,") != std::string::npos);
  for (const std::size_t row : {1, 2, 3, 4, 5, 6}) CHECK(more.find(lines[row]) != std::string::npos);

  grid.repetitions = 1;
  CHECK_THROWS_WITH(run(folder.path(), grid), Catch::Contains("accuracy.csv: ") && Catch::Contains("--fresh"));
  CHECK(read_file(folder / "accuracy.csv") == more);
  CHECK(run(folder.path(), grid, true) == 5);
}

TEST_CASE("a table of accuracies with missing rows or invalid content", "[bench]") {
  const TemporaryFolder folder;
  AccuracyGrid grid = tiny_grid();
  grid.cases.resize(1);
  AccuracyResults results = empty_results(grid);
  const auto read_back = [&] {
    write_table(folder / "t.csv", table_of(results, {"a note"}));
    return read_results(folder / "t.csv", grid, {"a note"}).front().pairs.front().points;
  };
  CHECK(read_back().empty());
  std::vector<AccuracyPoint>& points = results.front().pairs.front().points;
  points = {{1, 0.5, 2, 1}, {4, 0.25, 3, 2}, {16, 0.125, 4, 3}};
  const std::vector<AccuracyPoint> same = read_back();
  REQUIRE(same.size() == 3);
  CHECK((same[1].iterations == 4 && same[1].error == 0.25 && same[1].ms_median == 3 && same[1].ms_min == 2));
  points.pop_back();  // not all of the grid's numbers of iterations
  CHECK(read_back().empty());
  points.back() = {4, kNotANumber, kNotANumber, kNotANumber};  // none were measured after this one
  REQUIRE(read_back().size() == 2);
  CHECK((std::isnan(read_back().back().error) && std::isnan(read_back().back().ms_min)));

  CHECK_THROWS_AS(read_results(folder / "t.csv", grid, {"another note"}), Error);
  write_file(folder / "t.csv",
             "# a note\n" + kColumns + "\none_step,48,1000000,0.3,0.01666667,2,two_level,nonlinear_cg,1,half,2,1\n");
  CHECK_THROWS_WITH(read_results(folder / "t.csv", grid, {"a note"}), Catch::Contains("t.csv:3: "));
  write_file(folder / "t.csv", "# a note\nx,y\n");
  CHECK_THROWS_WITH(read_results(folder / "t.csv", grid, {"a note"}), Catch::Contains("t.csv:2: "));
}

TEST_CASE("a Pareto frontier has the points that no other point dominates", "[bench]") {
  using Indices = std::vector<std::size_t>;
  CHECK(pareto_frontier({}).empty());
  CHECK(pareto_frontier({{3, 1}, {1, 3}, {2, 2}, {2.5, 2.5}, {4, 1}, {1, 4}}) == Indices{1, 2, 0});
  CHECK(pareto_frontier({{1, 1}, {1, 1}, {kNotANumber, 0.1}, {0.1, kNotANumber}}) == Indices{0});

  const std::vector<FrontierPoint> frontier = frontier_of(known_case());
  Indices pairs;
  for (const FrontierPoint& point : frontier) pairs.push_back(point.pair);
  CHECK(pairs == Indices{2, 1, 0, 0, 0});
  CHECK((frontier.front().ms == 0.5 && frontier.front().error == 0.9));
}

TEST_CASE("the summary of accuracies", "[bench]") {
  const CaseAccuracy result = known_case();
  CHECK(first_within(result.pairs[1], 0.1)->iterations == 10);
  CHECK(!first_within(result.pairs[3], 0.1));
  CHECK(pairs_to_draw(result) == std::vector<std::size_t>{0, 2, 3});  // the best of each method, and the paper's
  const std::string summary = summary_of({result, {{}, {{SolverSettings().choice(), {}}}}}, {"a note"});
  INFO(summary);
  for (const char* text :
       {"- a note\n", "| two_level + nonlinear_cg | 5 | 4 | 5 | 4 | 10 | 8 | 0.0009 |\n",
        "| two_level + none | 10 | 8.5 | - | - | - | - | 0.6 |\n", "| jacobi + none | - | - | - | - | - | - | 0.9 |\n",
        "| jacobi + anderson_positions | - | - | - | - | - | - | |\n"}) {
    CAPTURE(text);
    CHECK(summary.find(text) != std::string::npos);
  }
  std::size_t cases = 0;
  for (const std::string& line : lines_of(summary)) cases += line.rfind("## ", 0) == 0;
  CHECK(cases == 1);  // no case without measurements
}

TEST_CASE("every case of the accuracy grid has a unique name", "[bench]") {
  for (const bool quick : {false, true}) {
    std::vector<std::string> names;
    for (const AccuracyCase& c : accuracy_grid(quick).cases) names.push_back(file_name_of(c));
    std::sort(names.begin(), names.end());
    CHECK(names.size() >= 3);
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  }
  CHECK(file_name_of(AccuracyCase()) == "accuracy_one_step_5184_1MPa_nu0.3_s1");
}

TEST_CASE("bench accuracy on the command line", "[bench]") {
  const CommandResult help = run_fascia({"bench", "accuracy", "--help"});
  CHECK(help.exit_code == 0);
  for (const char* option : {"--out", "--quick", "--fresh"}) CHECK(help.out.find(option) != std::string::npos);
  CHECK(run_fascia({"bench", "accuracy"}).exit_code == 2);
  const TemporaryFolder folder;
  write_file(folder / "file", "not a folder");
  const CommandResult result = run_fascia({"bench", "accuracy", "--quick", "--out", (folder / "file").string()});
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(result.err.find("file: ") != std::string::npos);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
}
