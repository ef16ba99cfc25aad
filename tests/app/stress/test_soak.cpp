// fascia soak: what two runs of a small mesh report, and which differences are failures.
#include "app/stress/soak.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("a soak runs a scene twice with the integrator and the elements that are asked for, or its own") {
  TemporaryFolder folder;
  write_mesh(folder / "box.msh", make_box(1, 1, 1, {0.1, 0.1, 0.1}));
  write_file(folder / "box.json", R"({"fascia_scene": 1, "solver": {"integrator": "sdirk2"}, "bodies": [
    {"mesh": "box.msh", "fixed": [{"box": [[-1, -1, -1], [1, 1, 0.001]]}]}]})");
  BenchOptions options;
  options.out = (folder / "out").string();
  options.context = "osmesa";
  options.quiet = true;
  Bench bench(options, "soak");
  const auto rows_of = [&](const Discretization& discretization) {
    soak_scenes(bench, {folder / "box.json"}, 10, discretization);
    return read_file(folder.path() / "out" / "soak.csv");
  };
  const std::string own = rows_of({}), asked = rows_of({"bdf2", "quadratic"});
  CHECK_THAT(own, Catch::Contains("\nbox,6,linear,sdirk2,10,1,") && Catch::Contains("\nbox,6,linear,sdirk2,10,2,"));
  CHECK_THAT(asked, Catch::Contains("\nbox,6,quadratic,bdf2,10,1,"));
  const auto hash_in = [](const std::string& table) { return table.substr(table.find(",10,1,") + 6, 16); };
  CHECK(hash_in(own) != hash_in(asked));
}

TEST_CASE("a soak fails where something drifts, grows or does not repeat") {
  SoakRun good;
  good.hash = 1;
  good.elastic_first = good.elastic_last = 0.5;
  good.strained = 1;
  good.gpu_first = good.gpu_last = good.memory_first = good.memory_last = 1000;
  CHECK(soak_failures(good, good).empty());
  const auto failure_of = [&](const std::function<void(SoakRun&)>& change) {
    SoakRun bad = good;
    change(bad);
    const std::vector<std::string> failures = soak_failures(good, bad);
    REQUIRE(failures.size() == 1);
    return failures[0];
  };
  CHECK(failure_of([](SoakRun& run) { run.hash = 2; }) == "two runs end in different states");
  CHECK(failure_of([](SoakRun& run) { run.elastic_last = 0.502; }) == "the elastic energy at rest drifts");
  CHECK(failure_of([](SoakRun& run) { run.kinetic_last = 0.002; }) == "the body does not come to rest");
  CHECK(failure_of([](SoakRun& run) { run.gpu_last = 1001; }) == "GPU memory grows");
  CHECK(failure_of([](SoakRun& run) { run.memory_last = 6u << 20; }) == "memory grows");
}
