// The range of every number of a scene, and the message beyond it.
#include <functional>

#include "base/json/json_document.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

struct RangedKey {
  std::string path;  // as errors print it
  std::string range;
  double min, max;
  std::function<std::string(const std::string&)> scene;  // a scene with the value
};

std::vector<RangedKey> ranged_keys() {
  const auto top = [](const std::string& before, const std::string& after) {
    return [=](const std::string& value) { return scene_text("", before + value + after); };
  };
  const auto body = [](const std::string& before, const std::string& after) {
    return [=](const std::string& value) { return scene_text(before + value + after); };
  };
  const std::string motion = "\"prescribed\": [{\"select\": {\"lowest\": 0}, ";
  const std::string whole = "a whole number, ";
  const std::string moved = "bodies[0].prescribed[0].";
  std::vector<RangedKey> keys = {
      {"gravity[0]", "-1e+06 to 1e+06 m/s^2", -1e6, 1e6, top("\"gravity\": [", ", 0, 0]")},
      {"duration", "0 to 1e+09 s", 0, 1e9, top("\"duration\": ", "")},
      {"camera.eye[0]", "-1e+09 to 1e+09 m", -1e9, 1e9, top("\"camera\": {\"eye\": [", ", 0, 1]}")},
      {"camera.target[0]", "-1e+09 to 1e+09 m", -1e9, 1e9,
       top("\"camera\": {\"eye\": [0, 0, 1], \"target\": [", ", 0, 0]}")},
      {"camera.up[1]", "-1e+09 to 1e+09", -1e9, 1e9, top("\"camera\": {\"eye\": [0, 0, 1], \"up\": [0, ", ", 0]}")},
      {"camera.fov_deg", "1 to 170 degrees", 1, 170, top("\"camera\": {\"eye\": [0, 0, 1], \"fov_deg\": ", "}")},
      {"display.range[0]", "-1e+30 to 1e+30", -1e30, 0, top("\"display\": {\"range\": [", ", 1]}")},
      {"display.section.offset", "-1e+09 to 1e+09 m", -1e9, 1e9, top("\"display\": {\"section\": {\"offset\": ", "}}")},
      {"display.tets.shrink", "0.01 to 1", 0.01, 1, top("\"display\": {\"tets\": {\"shrink\": ", "}}")},
      {"display.tets.spread", "0 to 10", 0, 10, top("\"display\": {\"tets\": {\"spread\": ", "}}")},
      {"display.ambient_occlusion", "0 to 1", 0, 1, top("\"display\": {\"ambient_occlusion\": ", "}")},
      {"display.depth_cue", "0 to 1", 0, 1, top("\"display\": {\"depth_cue\": ", "}")},
      {"bodies[0].transform.scale", "1e-09 to 1e+09", 1e-9, 1e9, body("\"transform\": {\"scale\": ", "}")},
      {"bodies[0].transform.rotate_deg[2]", "-36000 to 36000 degrees", -36000, 36000,
       body("\"transform\": {\"rotate_deg\": [0, 0, ", "]}")},
      {"bodies[0].transform.translate[2]", "-1e+06 to 1e+06 m", -1e6, 1e6,
       body("\"transform\": {\"translate\": [0, 0, ", "]}")},
      {"bodies[0].initial_velocity[1]", "-1e+06 to 1e+06 m/s", -1e6, 1e6, body("\"initial_velocity\": [0, ", ", 0]")},
      {"bodies[0].fixed[0].lowest", "0 to 1 of the height", 0, 1, body("\"fixed\": [{\"lowest\": ", "}]")},
      {"bodies[0].fixed[0].sphere.radius", "0 to 1e+30 m", 0, 1e30,
       body("\"fixed\": [{\"sphere\": {\"center\": [0, 0, 0], \"radius\": ", "}}]")},
      {"bodies[0].fixed[0].box[0][0]", "-1e+30 to 1e+30 m", -1e30, 1e30,
       body("\"fixed\": [{\"box\": [[", ", 0, 0], [1e30, 0, 0]]}]")},
      {moved + "start", "0 to 1e+09 s", 0, 1e9, body(motion + "\"start\": ", "}]")},
      {moved + "duration", "0 to 1e+09 s", 0, 1e9, body(motion + "\"duration\": ", "}]")},
      {moved + "scale", "0.001 to 1000", 1e-3, 1e3, body(motion + "\"scale\": ", "}]")},
      {moved + "translate[0]", "-1e+06 to 1e+06 m", -1e6, 1e6, body(motion + "\"translate\": [", ", 0, 0]}]")},
      {moved + "rotate_deg.angle", "-36000 to 36000 degrees", -36000, 36000,
       body(motion + "\"rotate_deg\": {\"angle\": ", "}}]")},
      {moved + "rotate_deg.axis[0]", "-1e+06 to 1e+06", -1e6, 1e6,
       body(motion + "\"rotate_deg\": {\"axis\": [", ", 0, 0]}}]")},
      {moved + "rotate_deg.center[0]", "-1e+06 to 1e+06 m", -1e6, 1e6,
       body(motion + "\"rotate_deg\": {\"center\": [", ", 0, 0]}}]")},
      {"solver.iterations", whole + "1 to 10000", 1, 10000, top("\"solver\": {\"iterations\": ", "}")},
      {"solver.substeps", whole + "1 to 1000", 1, 1000, top("\"solver\": {\"substeps\": ", "}")},
      {"solver.tolerance", "0 to 1", 0, 1, top("\"solver\": {\"tolerance\": ", "}")},
      {"solver.time_step", "1e-06 to 1 s", 1e-6, 1, top("\"solver\": {\"time_step\": ", "}")},
  };
  for (const std::string region : {"default", "2"}) {
    const std::string path = "bodies[0].materials." + region + ".";
    const auto material = [&](const std::string& key) {
      return body("\"materials\": {\"" + region + "\": {\"" + key + "\": ", "}}");
    };
    keys.push_back({path + "young_modulus", "0.001 to 1e+14 Pa", 1e-3, 1e14, material("young_modulus")});
    keys.push_back({path + "poisson_ratio", "-0.9 to 0.499", -0.9, 0.499, material("poisson_ratio")});
    keys.push_back({path + "density", "0.001 to 1e+06 kg/m^3", 1e-3, 1e6, material("density")});
    keys.push_back({path + "damping", "0 to 10 s", 0, 10, material("damping")});
  }
  return keys;
}

}  // namespace

TEST_CASE("every number is accepted at the ends of its range and refused beyond them") {
  for (const RangedKey& key : ranged_keys()) {
    CAPTURE(key.path);
    for (const double value : {key.min, key.max}) {
      const std::string text = nlohmann::json(value).dump();
      CAPTURE(text);
      CHECK_NOTHROW(SceneFile(key.scene(text)).open());
    }
    const bool is_whole = key.range.find("whole") != std::string::npos;
    const double step = is_whole ? 1 : 1e-3 * std::max({std::abs(key.min), std::abs(key.max), 1e-6});
    std::vector<double> outside = {key.min - step};
    if (key.path != "display.range[0]") outside.push_back(key.max + step);  // its upper limit is the other number
    for (const double value : outside) {
      const std::string text = nlohmann::json(value).dump();
      CHECK(SceneFile(key.scene(text)).open_error() ==
            "s.json: " + key.path + ": is " + text + "; expected " + key.range);
    }
    CHECK(SceneFile(key.scene("null")).open_error().find("s.json: " + key.path + ": is null; expected a") == 0);
  }
}
