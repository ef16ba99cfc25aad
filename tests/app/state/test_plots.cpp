// The data of plots: the samples kept, the ticks of an axis, the table.
// Covers: sim/output/sample_history
#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/output/sample_history.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

Sample at(double time) {
  Sample sample;
  sample.time = time;
  return sample;
}

}  // namespace

TEST_CASE("samples are in the order of time, and a step back in time discards later ones") {
  SampleHistory history;
  CHECK(history.nearest(1) == nullptr);
  for (int i = 0; i < 10; ++i) history.add(at(0.1 * i));
  history.add(at(0.45));
  REQUIRE(history.all().size() == 6);
  CHECK(history.all().back().time == 0.45);
  CHECK(history.nearest(0.21)->time == Approx(0.2));
  CHECK(history.nearest(-3)->time == 0);
  CHECK(history.nearest(3)->time == 0.45);
  const auto part = history.between(0.15, 0.25);  // 0.2, and one on each side
  REQUIRE(part.size() == 3);
  CHECK(part.front().time == Approx(0.1));
  CHECK(part.back().time == Approx(0.3));
  CHECK(history.between(5, 6).size() == 1);
  history.add(at(0));
  CHECK(history.all().size() == 1);
}

TEST_CASE("a long session discards its oldest samples") {
  SampleHistory history;
  const auto many = static_cast<int>(SampleHistory::kMost) + 5;
  for (int i = 0; i < many; ++i) history.add(at(i));
  CHECK(history.all().size() <= SampleHistory::kMost);
  CHECK(history.all().back().time == many - 1);
  CHECK(history.all().front().time == static_cast<double>(SampleHistory::kMost / 2));
}

TEST_CASE("a table of samples has notes, names with units, and empty cells for unknown values") {
  const TemporaryFolder folder;
  Sample sample = at(0.1);
  sample.kinetic = 1.0 / 3;
  write_samples(folder / "t.csv", std::vector<Sample>{sample}, Model(), {{"Title", "A\n  B"}}, 7);
  const std::string text = read_file(folder / "t.csv");
  CAPTURE(text);
  CHECK(text.rfind("# Title: AB\n# Probe: vertex 7\nstep,time_s,kinetic_J,", 0) == 0);
  CHECK_THAT(text, Catch::Contains("\n0,0.1,0.3333333333333333,0,0,0.3333333333333333,1,"));
  CHECK(text.substr(text.size() - 8) == ",,,,,,,\n");
}

TEST_CASE("a table of samples has the forces between all bodies that may touch") {
  const TemporaryFolder folder;
  Model model;
  model.contact.bodies = model.contact.self = true;
  for (const char* name : {"liver", "a, b"}) model.bodies.push_back({name, 0, 0, 0, 0, 0, 0, {}});
  Sample apart = at(0), touching = at(1);
  touching.pairs = {{{0, 1}, {1, 2, 3}, 4, 5, 0.25}};
  write_samples(folder / "t.csv", std::vector<Sample>{apart, touching}, model, {}, 7);
  const std::string text = read_file(folder / "t.csv");
  CAPTURE(text);
  CHECK_THAT(text,
             Catch::Contains(",contact_liver_liver_normal_N,contact_liver_liver_deepest_m,contact_liver_a_ b_x_N,"
                             "contact_liver_a_ b_y_N,contact_liver_a_ b_z_N,contact_liver_a_ b_normal_N,"
                             "contact_liver_a_ b_deepest_m,contact_a_ b_a_ b_normal_N,contact_a_ b_a_ b_deepest_m\n"));
  CHECK_THAT(text, Catch::Contains(",0,0,0,0,0,0,0,0,0\n"));
  CHECK_THAT(text, Catch::Contains(",0,0,1,2,3,4,0.25,0,0\n"));
}
