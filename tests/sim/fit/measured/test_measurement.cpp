#include <catch2/catch.hpp>

#include "base/error.h"
#include "base/file.h"
#include "sim/fit/measured/measurement.h"
#include "tests/sim/fit/block_scene.h"

namespace fascia {
namespace {

using test::BlockScene;
using Kind = Measurand::Kind;

struct Reading {
  BlockScene block;
  Model model = build_model(block.scene());
  MeasurementRead how{7, {"step", "elastic_J", "reaction_y_N"}, {}};

  Measurement operator()(const std::string& content, const std::string& name = "a.csv") const {
    write_file(block.folder / name, content);
    return read_measurement(block.folder / name, model, how);
  }
  std::string error_of(const std::string& content, const std::string& name = "a.csv") const {
    try {
      (*this)(content, name);
    } catch (const Error& error) {
      const std::string text = error.what(), folder = block.folder.path().string() + "/";
      return text.starts_with(folder) ? text.substr(folder.size()) : text;
    }
    return "";
  }
};

TEST_CASE("columns are read in their units", "[fit]") {
  const Reading read;
  const Measurement m = read("time_ms,support_1_x_mN,probe_y_mm,vertex_3_z_cm\n500,1500,2,1\n1000,3000,,2\n");
  REQUIRE(m.curves.size() == 3);
  CHECK(m.curves[0].name == "support_1_x");
  CHECK(m.curves[0].times == std::vector<double>{0.5, 1});
  CHECK(m.curves[0].values == std::vector<double>{1.5, 3});
  CHECK(m.curves[0].measurand.kind == Kind::support);
  CHECK(m.curves[0].measurand.index == 1);
  CHECK(m.curves[0].measurand.axis == 0);
  CHECK(m.curves[1].measurand.index == 7);  // the probe that is asked for
  CHECK(m.curves[1].times == std::vector<double>{0.5});
  CHECK(m.curves[1].values == std::vector<double>{2e-3});
  CHECK(m.curves[2].measurand.index == 3);
  CHECK(m.curves[2].values == std::vector<double>{0.01, 0.02});
  CHECK(read("# Probe: vertex 9\nprobe_x_m\n1e-3\n").curves[0].measurand.index == 9);
  CHECK(read("probe_x_m\n1e-3\n").curves[0].times.empty());
}

TEST_CASE("forces against displacement are at the times of what the scene moves", "[fit]") {
  const Reading read;  // 20 mm in a second
  const Measurement m = read("displacement_mm,support_1_x_N\n5,1\n20,2\n");
  CHECK(m.curves[0].times[0] == Approx(0.25));
  CHECK(m.curves[0].times[1] == Approx(1));
  CHECK(read.error_of("displacement_mm,support_1_x_N\n5,1\n21,2\n") ==
        "a.csv:1: row 2 has the displacement 0.021 m; expected 0 to 0.02 m, as far as the scene moves");
  CHECK(read.error_of("time_s,displacement_mm,support_1_x_N\n0,5,1\n") ==
        "a.csv:1: column displacement_mm is a second time; expected one");
  CHECK(read.error_of("displacement_s,support_1_x_N\n5,1\n") ==
        "a.csv:1: column displacement_s has the unit \"s\"; expected m, cm, mm, um at the end of its name");
}

TEST_CASE("a history is read without what is not measured", "[fit]") {
  Reading read;
  const std::string history = "step,time_s,elastic_J,reaction_y_N,grab_x_N,support_0_y_N,probe_y_m\n0,0,0,5,0,3,0.1\n";
  const Measurement m = read(history);
  REQUIRE(m.curves.size() == 2);  // the sum of the supports is left out, and the grab that pulls nothing
  CHECK(m.curves[0].name == "support_0_y");
  CHECK(m.notes == std::vector<std::string>{"not fitted: step, elastic_J, reaction_y, grab_x"});
  read.how.columns = {"reaction_y"};
  REQUIRE(read(history).curves.size() == 1);
  CHECK(read(history).curves[0].name == "reaction_y");
  read.how.columns = {"probe"};
  CHECK(read(history).curves[0].name == "probe_y");
}

TEST_CASE("forces between bodies in a history are not fitted", "[fit]") {
  Reading read;
  read.model.bodies.push_back(read.model.bodies[0]);
  read.model.bodies[0].name = "a";
  read.model.bodies[1].name = "b";
  read.model.contact.bodies = read.model.contact.self = true;
  const Measurement m =
      read("time_s,reaction_y_N,contact_a_a_normal_N,contact_a_b_x_N,contact_a_b_deepest_m\n0,5,1,2,3\n");
  CHECK(m.notes ==
        std::vector<std::string>{"not fitted: contact_a_a_normal_N, contact_a_b_x_N, contact_a_b_deepest_m"});
}

TEST_CASE("wrong units and columns are one line", "[fit]") {
  const Reading read;
  CHECK(read.error_of("time_s,reaction_y_lbf\n0,1\n") ==
        "a.csv:1: column reaction_y_lbf has the unit \"lbf\"; expected N, mN, kN at the end of its name");
  CHECK(read.error_of("time_s,reaction_y_mm\n0,1\n") ==
        "a.csv:1: column reaction_y_mm has the unit \"mm\"; expected N, mN, kN at the end of its name");
  CHECK(read.error_of("time_h,reaction_y_N\n0,1\n") ==
        "a.csv:1: column time_h has the unit \"h\"; expected s, ms, min at the end of its name");
  CHECK(read.error_of("time_s,force\n0,1\n")
            .starts_with("a.csv:1: column \"force\" is no measurement; expected time_s,"));
  CHECK(read.error_of("time_s,force_y_N\n0,1\n").starts_with("a.csv:1: column \"force_y_N\" is no measurement"));
  CHECK(read.error_of("time_s,support_2_x_N\n0,1\n") == "a.csv:1: support 2 does not exist; expected 0 to 1");
  CHECK(read.error_of("time_s,contact_probe_x_N\n0,1\n") ==
        "a.csv:1: column contact_probe_x_N names no tool of the scene; expected none in this scene");
  CHECK(read.error_of("reaction_y_N\n0\n1\n") ==
        "a.csv:1: has 2 rows and no times; expected a column time_s, or one row at the end");
  CHECK(read.error_of("time_s,reaction_y_N\n0,0\n").starts_with("a.csv:1: has no value other than 0 to fit"));
  CHECK(read.error_of("time_s,reaction_y_N\n,1\n") == "a.csv:1: row 1 has no time; expected 0 or more");
}

TEST_CASE("a shape is vertices, or points of a surface, in meters", "[fit]") {
  const Reading read;
  const std::size_t last = read.model.rest_positions.size() - 1;  // which is moved; vertex 1 is free
  const Measurement m = read("index,x_mm,y_mm,z_mm\n1,30,0,0\n" + std::to_string(last) + ",140,40,40\n");
  REQUIRE(m.shapes.size() == 1);
  CHECK(m.shapes[0].vertices == std::vector<std::uint32_t>{1});
  CHECK(m.shapes[0].positions[0] == Eigen::Vector3d(0.03, 0, 0));
  CHECK(m.shapes[0].value_count() == 3);
  CHECK(read.error_of("index,x_lb,y_lb,z_lb\n1,30,0,0\n") ==
        "a.csv:1: positions have the unit \"lb\"; expected m, cm, mm, um");
  const std::string triangle = "v 0 0 0\nv 140 0 0\nv 140 40 40\nf 1 2 3\n";
  CHECK(read.error_of(triangle, "a.obj") == "a.obj: is 1138 times as large as the scene; expected positions in meters");
  const Measurement surface = read("v 0 0 0\nv 0.14 0 0\nv 0.14 0.04 0.04\nf 1 2 3\n", "b.obj");
  REQUIRE(surface.shapes.size() == 1);
  CHECK(surface.shapes[0].vertices.empty());
  CHECK(surface.shapes[0].value_count() == 3);
}

TEST_CASE("noise is a share of the largest value of a vector, or an amount", "[fit]") {
  const Reading read;
  std::vector<Measurement> m{read("time_s,support_1_x_N,support_1_y_N,probe_y_mm\n1,4,-0.5,2\n")};
  assign_noise(m, {}, read.model);
  CHECK(m[0].curves[0].noise == Approx(0.04));
  CHECK(m[0].curves[1].noise == Approx(0.04));
  CHECK(m[0].curves[2].noise == Approx(2e-5));
  assign_noise(m, {{0.02, true, Dimension::force}, {1e-4, false, Dimension::length}}, read.model);
  CHECK(m[0].curves[0].noise == Approx(0.08));
  CHECK(m[0].curves[2].noise == Approx(1e-4));
}

}  // namespace
}  // namespace fascia
