// Charts through gnuplot: all formats, every text in them, and errors when gnuplot is missing or fails.
// Covers: gnuplot
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <functional>
#include <limits>

#include "app/charts/chart.h"
#include "app/charts/gnuplot.h"
#include "base/error.h"
#include "base/file.h"
#include "render/target/image.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

Chart example() {
  Chart chart;
  chart.title = "Strain_of 'a' beam";
  chart.x = {"iterations", true, {}};
  chart.y = {"strain [-]", false, Eigen::Vector2d(0, 2)};
  Series line, marks, nothing;
  line.name = "a_line";
  line.points = {{0, 1}, {1, 1}, {10, std::numeric_limits<double>::quiet_NaN()}, {20, 0.5}, {30, 0.4}};
  marks.name = "some marks";
  marks.color = marks.dash = 1;
  marks.line = false;
  marks.marks = true;
  marks.points = {{2, 1.5}, {5, 1.2}};
  nothing.name = "no number at all";
  nothing.points = {{3, std::numeric_limits<double>::infinity()}};
  chart.series = {line, marks, nothing};
  chart.levels = {{"exact", 0.3}};
  return chart;
}

// The text of the Error that the function throws.
std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

// Sets PATH during a test.
class Path {
 public:
  explicit Path(const std::string& path) : before_(std::getenv("PATH")) { setenv("PATH", path.c_str(), 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

}  // namespace

TEST_CASE("a chart is an SVG, a PNG or a PDF by its ending, with all its texts", "[chart]") {
  const TemporaryFolder folder;
  CHECK(chart_endings() == std::vector<std::string>{".svg", ".png", ".pdf"});
  for (const std::string& ending : chart_endings()) write_chart(folder / ("a'chart" + ending), example());
  const std::string svg = read_file(folder / "a'chart.svg");
  for (const char* text :
       {"Strain_of ", "iterations", "strain [-]", "a_line", "some marks", "no number at all", "exact"}) {
    CAPTURE(text);
    CHECK(svg.find(text) != std::string::npos);
  }
  const Image png = read_png(folder / "a'chart.png");
  CHECK(png.width == 1440);
  CHECK(png.height == 960);
  CHECK(read_file(folder / "a'chart.pdf").starts_with("%PDF-"));
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 3);
  CHECK(error_of([&] { write_chart(folder / "chart.jpg", example()); }).find("expected .svg, .png or .pdf") !=
        std::string::npos);
}

TEST_CASE("ticks of an axis of many decades are powers of ten, and an underscore in a text stays one", "[chart]") {
  const TemporaryFolder folder;
  Chart chart = example();
  chart.y = {"error", true, Eigen::Vector2d(1e-7, 10)};
  write_chart(folder / "chart.svg", chart);
  const std::string svg = read_file(folder / "chart.svg");
  CHECK(svg.find("1e-05") == std::string::npos);
  CHECK(svg.find("0.001") == std::string::npos);
  CHECK(svg.find("a_line") != std::string::npos);  // not a subscript
}

TEST_CASE("a logarithmic axis of less than two decades has numbers at 1, 2 and 5", "[chart]") {
  const TemporaryFolder folder;
  Chart chart = example();
  chart.y = {"error", true, Eigen::Vector2d(0.03, 0.7)};
  write_chart(folder / "short.svg", chart);
  chart.y = {"error", true, Eigen::Vector2d(0.003, 0.7)};
  write_chart(folder / "long.svg", chart);
  const auto has = [&](const char* file, const char* number) {
    return read_file(folder / file).find(">" + std::string(number) + "<") != std::string::npos;
  };
  for (const char* number : {"0.05", "0.1", "0.2", "0.5"}) {
    CAPTURE(number);
    CHECK(has("short.svg", number));
  }
  CHECK(has("long.svg", "0.1"));
  CHECK(!has("long.svg", "0.2"));
}

TEST_CASE("the same chart gives the same files", "[chart]") {
  const TemporaryFolder folder;
  for (const std::string ending : {".svg", ".png"}) {
    write_chart(folder / ("one" + ending), example());
    write_chart(folder / ("two" + ending), example());
    CAPTURE(ending);
    CHECK(read_file(folder / ("one" + ending)) == read_file(folder / ("two" + ending)));
  }
}

TEST_CASE("without gnuplot a chart names its package", "[chart]") {
  const TemporaryFolder folder, tools;
  const Path path(tools.path().string());
  CHECK(!gnuplot_installed());
  CHECK(error_of([&] { write_chart(folder / "chart.svg", example()); }).find("gnuplot-nox") != std::string::npos);
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a gnuplot that fails leaves the old chart in place", "[chart]") {
  const TemporaryFolder folder, tools;
  write_file(folder / "chart.svg", "old");
  write_file(tools / "gnuplot", "#!/bin/sh\necho half a chart\necho 'line 1: out of ink' >&2\nexit 1\n");
  chmod((tools / "gnuplot").c_str(), 0755);
  const Path path(tools.path().string() + ":/usr/bin:/bin");
  CHECK(gnuplot_installed());
  const std::string error = error_of([&] { write_chart(folder / "chart.svg", example()); });
  CAPTURE(error);
  CHECK(error.find("chart.svg: gnuplot ended with status 1") != std::string::npos);
  CHECK(error.find("out of ink") != std::string::npos);
  CHECK(read_file(folder / "chart.svg") == "old");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a script that gnuplot does not understand is an error", "[chart]") {
  const TemporaryFolder folder;
  const std::string error = error_of([&] { run_gnuplot(folder / "chart.png", "set terminal png\nplotte x\n"); });
  CAPTURE(error);
  CHECK(error.find("invalid command") != std::string::npos);
  CHECK(fs::is_empty(folder.path()));
}
