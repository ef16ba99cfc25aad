#include <catch2/catch.hpp>
#include <cmath>

#include "sim/output/measured_samples.h"

using namespace fascia;

TEST_CASE("a measurement becomes samples that know what was measured", "[output]") {
  using Kind = Measurand::Kind;
  Measurement measurement;
  measurement.curves = {{"reaction_y", {Kind::reaction, 0, 1}, Dimension::force, {1, 0.5}, {3, 2}, 0},
                        {"probe_x", {Kind::vertex, 7, 0}, Dimension::length, {1}, {0.01}, 0},
                        {"vertex_8_x", {Kind::vertex, 8, 0}, Dimension::length, {2}, {0.02}, 0},
                        {"contact_probe_z", {Kind::contact, 1, 2}, Dimension::force, {0.5}, {-4}, 0},
                        {"grab_x", {Kind::grab, 0, 0}, Dimension::force, {}, {5}, 0}};
  const std::vector<Sample> samples = measured_samples(measurement, 2, 7);
  REQUIRE(samples.size() == 2);
  CHECK(samples[0].time == 0.5);
  CHECK(samples[0].reaction == Eigen::Vector3d(0, 2, 0));
  CHECK(samples[0].tools[1].force.norm() == 4);
  CHECK(std::isnan(samples[0].tools[0].force.norm()));
  CHECK(std::isnan(samples[0].probe.x()));
  CHECK(samples[1].probe.x() == 0.01);
  CHECK(std::isnan(samples[1].probe.norm()));
  CHECK(std::isnan(samples[1].grab.norm()));
  for (const Sample& sample : samples) CHECK(std::isnan(sample.total()));
  // Nothing that a history has is known by default.
  std::size_t known = 0;
  for (const Column& column : sample_columns()) known += std::isfinite(column.value(samples[0]));
  CHECK(known == 5);  // step, time, and the three components of the reaction
}
