// The messages for wrong scenes: the exact line for every kind of error.
// Covers: scene_read_body
#include "base/json/json_document.h"
#include "tests/sim/scene/scene_test.h"

using namespace fascia;
using namespace fascia::test;

namespace {

/// The error of opening `text` as s.json.
std::string error_of(const std::string& text) { return SceneFile(text).open_error(); }
/// With `keys` in the first body.
std::string body_error(const std::string& keys) { return error_of(scene_text(keys)); }
/// With `keys` at the top level.
std::string top_error(const std::string& keys) { return error_of(scene_text("", keys)); }

}  // namespace

TEST_CASE("files that are neither scene nor mesh") {
  const SceneFile file("", "empty.json");
  CHECK(file.open_error() == "empty.json: is empty; expected a scene (JSON) or a tet mesh");
  write_file(file / "blank", " \n\t\n");
  CHECK(file.error_of([&] { open_scene(file / "blank"); }) == "blank: is empty; expected a scene (JSON) or a tet mesh");
  CHECK(file.error_of([&] { open_scene(file / "nowhere.json"); }) ==
        "nowhere.json: no such file; expected a readable file");
  std::filesystem::create_directory(file / "folder");
  CHECK(file.error_of([&] { open_scene(file / "folder"); }) == "folder: is a directory; expected a file");
}

TEST_CASE("a syntax error has its line and column") {
  // The words after the position are the parser's own, so only the reported word is compared.
  const auto check = [](const std::string& text, const std::string& position, const std::string& word) {
    const std::string error = error_of(text);
    CAPTURE(text, error);
    CHECK(error.find("s.json:" + position + ": ") == 0);
    CHECK(error.find(word) != std::string::npos);
  };
  check("{", "1:2", "end of input");
  check("{\"fascia_scene\": 1,}", "1:20", "'}'");
  check("{\n  \"fascia_scene\": 1\n  \"title\": \"x\"}", "3:9", "string literal");
  check("{\n\n \"duration\": 2.5.1}", "3:17", "'2.5.'");
  check("{\"title\": \"a\nb\"}", "1:13", "control character");
  check("{\"title\": \"\xff\"}", "1:12", "UTF-8");
  check("{\"duration\": 1e999}", "1:14", "1e999");
  check("{\"duration\": NaN}", "1:14", "N");
  check(scene_text() + "}", "1:51", "end of input");
  check("{\"title\": \"" + std::string(100000, 'x'), "1:100012", "missing closing quote");
  CHECK(error_of("{\"title\": \"" + std::string(100000, 'x')).size() < 300);
}

TEST_CASE("every truncation of a scene is an error of one line") {
  const std::string text = scene_text(R"("fixed": [{"box": [[0, 0, 0], [1, 1, 1]]}], "name": "\u00e4")");
  for (std::size_t length = 0; length < text.size(); ++length) {
    CAPTURE(length);
    CHECK(!error_of(text.substr(0, length)).empty());
  }
}

TEST_CASE("nesting is limited") {
  const std::string expected = "s.json: is nested deeper than 32 levels; expected a scene";
  CHECK(error_of("{\"a\": " + std::string(100000, '[')) == expected);
  std::string objects;
  for (int depth = 0; depth < 100000; ++depth) objects += "{\"a\":";
  CHECK(error_of(objects) == expected);
}

TEST_CASE("a repeated key is refused with its place") {
  CHECK(error_of(R"({"title": "a", "title": "b"})") == "s.json: title: is given twice; expected each key once");
  CHECK(body_error(R"("name": "a", "name": "b")") == "s.json: bodies[0].name: is given twice; expected each key once");
  CHECK(
      error_of(R"({"bodies": [{"mesh": "a"}, {"fixed": [{"lowest": 1}, {"sphere": {"radius": 1, "radius": 1}}]}]})") ==
      "s.json: bodies[1].fixed[1].sphere.radius: is given twice; expected each key once");
  CHECK(body_error(R"("materials": {"2": {}, "2": {}})") ==
        "s.json: bodies[0].materials.2: is given twice; expected each key once");
  CHECK(error_of(R"({"a\nb": 1, "a\nb": 1})") == "s.json: \"a\\nb\": is given twice; expected each key once");
}

TEST_CASE("an unknown key is named with the nearest known one, at every level") {
  CHECK(top_error(R"("gravty": [0, 0, 0])") ==
        "s.json: gravty: unknown key \"gravty\", perhaps \"gravity\"; expected one of fascia_scene, title, gravity, "
        "bodies, grabs, contact, ground, obstacles, instruments, solver, camera, display, duration, files");
  CHECK(top_error(R"("solver": {"iters": 3})") ==
        "s.json: solver.iters: unknown key \"iters\", perhaps \"iterations\"; expected one of method, acceleration, "
        "integrator, "
        "iterations, tolerance, time_step, substeps, frame_budget, colors, spectral_radius, window, rest_speed");
  CHECK(top_error(R"("camera": {"eye": [0, 0, 1], "fov": 40})") ==
        "s.json: camera.fov: unknown key \"fov\"; expected one of eye, target, up, fov_deg, keys, smooth");
  CHECK(top_error(R"("display": {"colour": "none"})") ==
        "s.json: display.colour: unknown key \"colour\", perhaps \"color\"; expected one of color, range, color_map, "
        "wireframe, section, tets, shadow, ground, ambient_occlusion, depth_cue, background, marks, legend");
  CHECK(body_error(R"("fixd": [])") ==
        "s.json: bodies[0].fixd: unknown key \"fixd\", perhaps \"fixed\"; expected one of name, mesh, resolution, "
        "elements, unit, up, transform, materials, regions, fixed, prescribed, initial_velocity, surface");
  CHECK(body_error(R"("transform": {"rotate": [0, 0, 0]})") ==
        "s.json: bodies[0].transform.rotate: unknown key \"rotate\", perhaps \"rotate_deg\"; expected one of scale, "
        "rotate_deg, translate");
  CHECK(
      body_error(R"("materials": {"default": {"youngs_modulus": 1}})") ==
      "s.json: bodies[0].materials.default.youngs_modulus: unknown key \"youngs_modulus\", perhaps \"young_modulus\"; "
      "expected one of model, preset, young_modulus, poisson_ratio, density, damping, mooney_ratio, look, color");
  CHECK(body_error(R"("materials": {"7": {"E": 1}})") ==
        "s.json: bodies[0].materials.7.E: unknown key \"E\"; expected one of model, preset, young_modulus, "
        "poisson_ratio, density, damping, mooney_ratio, look, color");
  CHECK(body_error(R"("fixed": [{"boxx": 1}])") ==
        "s.json: bodies[0].fixed[0].boxx: unknown key \"boxx\", perhaps \"box\"; expected one of box, sphere, "
        "vertices, group, lowest, highest, each_piece");
  CHECK(body_error(R"("fixed": [{"sphere": {"centre": [0, 0, 0], "radius": 1}}])") ==
        "s.json: bodies[0].fixed[0].sphere.centre: unknown key \"centre\", perhaps \"center\"; expected one of center, "
        "radius");
  CHECK(body_error(R"("prescribed": [{"target": "a.csv"}])") ==
        "s.json: bodies[0].prescribed[0].target: unknown key \"target\", perhaps \"targets\"; expected one of select, "
        "translate, rotate_deg, scale, targets, start, duration");
  CHECK(body_error(R"("prescribed": [{"select": {"lowest": 0}, "rotate_deg": {"angel": 90}}])") ==
        "s.json: bodies[0].prescribed[0].rotate_deg.angel: unknown key \"angel\", perhaps \"angle\"; expected one of "
        "axis, angle, center");
}

TEST_CASE("a missing key is named") {
  CHECK(error_of("{}") == "s.json: fascia_scene: is missing; expected 1, the version of the format");
  CHECK(error_of(R"({"fascia_scene": 2, "bodies": []})") == "s.json: fascia_scene: is 2; expected 1");
  CHECK(error_of(R"({"fascia_scene": 1})") == "s.json: bodies: is missing; expected a list of at least one body");
  CHECK(error_of(R"({"fascia_scene": 1, "bodies": []})") ==
        "s.json: bodies: is []; expected a list of at least one body");
  CHECK(error_of(R"({"fascia_scene": 1, "bodies": [{}]})") ==
        "s.json: bodies[0].mesh: is missing; expected the path of a tet mesh or of a closed surface");
  CHECK(error_of(R"({"fascia_scene": 1, "bodies": [{"mesh": ""}]})") ==
        "s.json: bodies[0].mesh: is \"\"; expected the path of a tet mesh or of a closed surface");
  CHECK(top_error(R"("camera": {})") ==
        "s.json: camera.eye: is missing; expected a list of 3 numbers [m] (without a camera the view is framed on the "
        "bodies)");
  CHECK(body_error(R"("fixed": [{"sphere": {"radius": 1}}])") ==
        "s.json: bodies[0].fixed[0].sphere.center: is missing; expected a list of 3 numbers [m]");
  CHECK(body_error(R"("fixed": [{"sphere": {"center": [0, 0, 0]}}])") ==
        "s.json: bodies[0].fixed[0].sphere.radius: is missing; expected a radius [m]");
}

TEST_CASE("a wrong type reports the value found and the one expected") {
  CHECK(error_of(R"({"fascia_scene": "1"})") == "s.json: fascia_scene: is \"1\"; expected a number, 1");
  CHECK(top_error(R"("title": 5)") == "s.json: title: is 5; expected a text");
  CHECK(top_error(R"("gravity": -9.81)") == "s.json: gravity: is -9.81; expected a list of 3 numbers [m/s^2]");
  CHECK(top_error(R"("gravity": [0, -9.81])") == "s.json: gravity: is [0,-9.81]; expected a list of 3 numbers [m/s^2]");
  CHECK(top_error(R"("gravity": [0, "down", 0])") ==
        "s.json: gravity[1]: is \"down\"; expected a number, -1e+06 to 1e+06 m/s^2");
  CHECK(top_error(R"("solver": [])") ==
        "s.json: solver: is []; expected an object with method, acceleration, integrator, iterations, tolerance, "
        "time_step, "
        "substeps, frame_budget, colors, spectral_radius, window, rest_speed");
  CHECK(top_error(R"("solver": {"iterations": 2.5})") ==
        "s.json: solver.iterations: is 2.5; expected a whole number, 1 to 10000");
  CHECK(top_error(R"("solver": {"iterations": true})") ==
        "s.json: solver.iterations: is true; expected a whole number, 1 to 10000");
  CHECK(top_error(R"("display": {"wireframe": 1})") == "s.json: display.wireframe: is 1; expected true or false");
  CHECK(top_error(R"("display": {"color": "red"})") ==
        "s.json: display.color: is \"red\"; expected one of none, region, strain, von_mises, displacement, velocity, "
        "volume_ratio, largest_stress, smallest_stress, error, contact_pressure, mesh_error, recovered_von_mises");
  CHECK(top_error(R"("display": {"color": "mises"})") ==
        "s.json: display.color: is \"mises\", perhaps \"von_mises\"; expected one of none, region, strain, von_mises, "
        "displacement, velocity, volume_ratio, largest_stress, smallest_stress, error, contact_pressure, mesh_error, "
        "recovered_von_mises");
  CHECK(top_error(R"("display": {"color_map": "rainbow"})") ==
        "s.json: display.color_map: is \"rainbow\"; expected one of automatic, dusk, ember, polar, grey");
  CHECK(top_error(R"("display": {"background": "whit"})") ==
        "s.json: display.background: is \"whit\", perhaps \"white\"; expected one of gradient, white, black, "
        "transparent");
  CHECK(top_error(R"("display": {"section": {"normal": [0, 0, 0]}})") ==
        "s.json: display.section: normal has no length; expected a vector across the plane");
  CHECK(top_error(R"("display": {"section": true})") ==
        "s.json: display.section: is true; expected an object with normal, offset");
  CHECK(top_error(R"("display": {"tets": {"gap": 1}})") ==
        "s.json: display.tets.gap: unknown key \"gap\"; expected one of shrink, spread");
  CHECK(top_error(R"("display": {"range": [0]})") ==
        "s.json: display.range: is [0]; expected a list of 2 numbers, the lower one first");
  CHECK(top_error(R"("display": {"range": [1, 1]})") ==
        "s.json: display.range: is [1,1]; expected a list of 2 numbers, the lower one first");
  CHECK(top_error(R"("display": {"marks": "fixed"})") ==
        "s.json: display.marks: is \"fixed\"; expected true, false, or a list of fixed, grabs, forces");
  CHECK(top_error(R"("display": {"marks": ["grab"]})") ==
        "s.json: display.marks[0]: is \"grab\", perhaps \"grabs\"; expected one of fixed, grabs, forces");
  CHECK(top_error(R"("display": {"marks": ["fixed", "fixed"]})") ==
        "s.json: display.marks[1]: is \"fixed\" again; expected each name once");
  CHECK(top_error(R"("display": {"legend": "off"})") ==
        "s.json: display.legend: is \"off\"; expected an object with side, font_size, plate");
  CHECK(top_error(R"("display": {"legend": {"side": "top"}})") ==
        "s.json: display.legend.side: is \"top\"; expected one of right, left, off");
  CHECK(top_error(R"("display": {"legend": {"font_size": 3}})") ==
        "s.json: display.legend.font_size: is 3; expected 6 to 60 points");
  CHECK(top_error(R"("display": {"legend": {"plate": 0}})") ==
        "s.json: display.legend.plate: is 0; expected true or false");
  CHECK(error_of(R"({"fascia_scene": 1, "bodies": {}})") ==
        "s.json: bodies: is {}; expected a list of at least one body");
  CHECK(error_of(R"({"fascia_scene": 1, "bodies": ["m.msh"]})") ==
        "s.json: bodies[0]: is \"m.msh\"; expected an object with name, mesh, resolution, elements, unit, up, "
        "transform, materials, regions, fixed, prescribed, initial_velocity, surface");
  CHECK(body_error(R"("name": 1)") == "s.json: bodies[0].name: is 1; expected a text");
  CHECK(body_error(R"("surface": 1)") == "s.json: bodies[0].surface: is 1; expected the path of a surface");
  CHECK(body_error(R"("initial_velocity": 1)") ==
        "s.json: bodies[0].initial_velocity: is 1; expected a list of 3 numbers [m/s] or the path of a CSV file");
  CHECK(body_error(R"("initial_velocity": "")") ==
        "s.json: bodies[0].initial_velocity: is \"\"; expected a list of 3 numbers [m/s] or the path of a CSV file");
  CHECK(body_error(R"("materials": [])") ==
        "s.json: bodies[0].materials: is []; expected an object of materials: \"default\", region numbers or group "
        "names");
  CHECK(body_error(R"("materials": {"young_modulus": 1})") ==
        "s.json: bodies[0].materials.young_modulus: is 1; expected an object such as {\"young_modulus\": 1e5}, under "
        "\"default\", a region number or a group name");
  CHECK(body_error(R"("fixed": {"lowest": 0})") ==
        "s.json: bodies[0].fixed: is {\"lowest\":0}; expected a list of selections");
  CHECK(body_error(R"("prescribed": 1)") == "s.json: bodies[0].prescribed: is 1; expected a list of motions");
  CHECK(body_error("\"name\": [" + std::string(200, '1').insert(100, ",") + "]") ==
        "s.json: bodies[0].name: is [1.111111111111111e+99,1.111111111111111e+99]; expected a text");
}

TEST_CASE("a value that does not fit on one line is abbreviated") {
  CHECK(excerpt(nlohmann::json(std::string(100, 'x'))) == "\"" + std::string(59, 'x') + "...");
}

TEST_CASE("selections") {
  const std::string corners = "; expected a list of two corners, [[xmin, ymin, zmin], [xmax, ymax, zmax]] [m]";
  const std::string tets = "; expected a tet, or the first and the last tet of a range",
                    name = "; expected the name of a region, not empty or \"default\"";
  CHECK(body_error(R"("regions": [{"name": "a", "tets": [[2, 3, 4]]}])") ==
        "s.json: bodies[0].regions[0].tets[0]: is [2,3,4]" + tets);
  CHECK(body_error(R"("regions": [{"name": "a", "tets": [5, [3, 2]]}])") ==
        "s.json: bodies[0].regions[0].tets[1]: ends before it begins" + tets);
  CHECK(body_error(R"("regions": [{"name": "a", "tets": [-1]}])") ==
        "s.json: bodies[0].regions[0].tets[0]: is -1; expected a whole number, 0 to 2.14748e+09");
  CHECK(body_error(R"("regions": [{"name": "a", "tets": []}])") ==
        "s.json: bodies[0].regions[0].tets: is []; expected at least one tet");
  CHECK(body_error(R"("regions": [{"name": "a"}])") ==
        "s.json: bodies[0].regions[0].tets: is missing; expected a list of tets and of ranges [first, last], the first "
        "tet is 0");
  CHECK(body_error(R"("regions": [{"name": "", "tets": [1]}])") == "s.json: bodies[0].regions[0].name: is \"\"" + name);
  CHECK(body_error(R"("regions": [{"name": "default", "tets": [1]}])") ==
        "s.json: bodies[0].regions[0].name: is \"default\"" + name);
  CHECK(body_error(R"("regions": [{"name": "a", "tets": [1]}, {"name": "a", "tets": [2]}])") ==
        "s.json: bodies[0].regions[1]: has the name \"a\" of an earlier one; expected one entry per region");
  CHECK(body_error(R"("regions": {"a": [1]})") ==
        "s.json: bodies[0].regions: is {\"a\":[1]}; expected a list of regions such as {\"name\": \"tumor\", \"tets\": "
        "[3, [8, 20]]}");
  CHECK(body_error(R"("regions": [{"name": "a", "tet": [1]}])") ==
        "s.json: bodies[0].regions[0].tet: unknown key \"tet\", perhaps \"tets\"; expected one of name, tets");
  CHECK(body_error(R"("fixed": [{}])") ==
        "s.json: bodies[0].fixed[0]: selects nothing; expected one of box, sphere, vertices, group, lowest, highest");
  CHECK(body_error(R"("fixed": [{"group": "a", "lowest": 0.1}])") ==
        "s.json: bodies[0].fixed[0]: has group and lowest; expected one of box, sphere, vertices, group, lowest, "
        "highest");
  CHECK(body_error(R"("fixed": [{"group": "a", "each_piece": true}])") ==
        "s.json: bodies[0].fixed[0].each_piece: is given beside group; expected it beside lowest or highest only");
  CHECK_THAT(body_error(R"("fixed": [{"lowest": 0.1, "each_piece": 1}])"),
             Catch::StartsWith("s.json: bodies[0].fixed[0].each_piece: is 1; expected "));
  CHECK(body_error(R"("unit": "ft")") == "s.json: bodies[0].unit: is \"ft\"; expected one of m, cm, mm, um, in");
  CHECK(body_error(R"("unit": 0.001)") == "s.json: bodies[0].unit: is 0.001; expected one of m, cm, mm, um, in");
  CHECK(body_error(R"("up": "w")") == "s.json: bodies[0].up: is \"w\"; expected one of x, y, z, -x, -y, -z");
  CHECK(body_error(R"("fixed": [{"box": 1}])") == "s.json: bodies[0].fixed[0].box: is 1" + corners);
  CHECK(body_error(R"("fixed": [{"box": [[0, 0, 0]]}])") == "s.json: bodies[0].fixed[0].box: is [[0,0,0]]" + corners);
  CHECK(body_error(R"("fixed": [{"box": [[0, 0, 1], [1, 1, 0]]}])") ==
        "s.json: bodies[0].fixed[0].box: has min > max along z (first corner 1, second corner 0)" + corners);
  CHECK(body_error(R"("fixed": [{"box": [[0.25, 0, 1e-3], [0.125, 1, -2]]}])") ==
        "s.json: bodies[0].fixed[0].box: has min > max along x (first corner 0.25, second corner 0.125) and along z "
        "(first corner 0.001, second corner -2)" +
            corners);
  CHECK(body_error(R"("fixed": [{"vertices": []}])") ==
        "s.json: bodies[0].fixed[0].vertices: is []; expected at least one vertex index");
  CHECK(body_error(R"("fixed": [{"vertices": [0, -1]}])") ==
        "s.json: bodies[0].fixed[0].vertices[1]: is -1; expected a whole number, 0 to 2.14748e+09");
  CHECK(body_error(R"("fixed": [{"group": 3}])") ==
        "s.json: bodies[0].fixed[0].group: is 3; expected the name of a group of the mesh");
}

TEST_CASE("prescribed motions") {
  CHECK(body_error(R"("prescribed": [{}])") ==
        "s.json: bodies[0].prescribed[0]: moves nothing; expected a select, or targets");
  CHECK(body_error(R"("prescribed": [{"targets": "a.csv", "translate": [0, 0, 1]}])") ==
        "s.json: bodies[0].prescribed[0]: has targets and translate; expected one of them");
  CHECK(body_error(R"("prescribed": [{"targets": ""}])") ==
        "s.json: bodies[0].prescribed[0].targets: is \"\"; expected the path of a CSV file index,x,y,z");
  CHECK(body_error(R"("prescribed": [{"select": {"lowest": 0}, "rotate_deg": {"axis": [0, 0, 0], "angle": 1}}])") ==
        "s.json: bodies[0].prescribed[0].rotate_deg: axis has no direction; expected an axis of length 1e-06 or more");
}

TEST_CASE("cameras that see nothing") {
  CHECK(top_error(R"("camera": {"eye": [1, 2, 3], "target": [1, 2, 3]})") ==
        "s.json: camera: eye and target are the same point; expected two different points");
  CHECK(top_error(R"("camera": {"eye": [0, 5, 0]})") ==
        "s.json: camera: up has no part across the view from eye to target; expected an up vector across the view");
}

TEST_CASE("keys of a camera that cannot be followed") {
  const auto keys_error = [](const std::string& keys) { return top_error("\"camera\": {\"keys\": [" + keys + "]}"); };
  const std::string list = "expected a list of keys, times ascending, such as {\"time\": 4, \"orbit_deg\": 360}";
  CHECK(keys_error("") == "s.json: camera.keys: is []; " + list);
  CHECK(top_error(R"("camera": {"keys": {"time": 1}})") == "s.json: camera.keys: is {\"time\":1}; " + list);
  CHECK(keys_error(R"({"orbit_deg": 90})") == "s.json: camera.keys[0].time: is missing; expected seconds");
  CHECK(keys_error(R"({"time": -1})") == "s.json: camera.keys[0].time: is -1; expected 0 to 1e+09 s");
  CHECK(keys_error(R"({"time": 1}, {"time": 1})") ==
        "s.json: camera.keys[1]: time is 1.0; expected a later time than that of the key before");
  CHECK(keys_error(R"({"time": 0, "orbit": 90})") ==
        "s.json: camera.keys[0].orbit: unknown key \"orbit\", perhaps \"orbit_deg\"; expected one of time, eye, "
        "orbit_deg, elevation_deg, zoom, target, fov_deg");
  CHECK(keys_error(R"({"time": 0, "elevation_deg": 90})") ==
        "s.json: camera.keys[0].elevation_deg: is 90; expected -89 to 89 degrees");
  CHECK(keys_error(R"({"time": 0, "zoom": 0})") == "s.json: camera.keys[0].zoom: is 0; expected 0.001 to 1000");
  CHECK(keys_error(R"({"time": 0, "eye": [1, 0, 0], "zoom": 2})") ==
        "s.json: camera.keys[0]: has eye and orbit_deg, elevation_deg or zoom; expected eye alone, or the others");
  CHECK(keys_error(R"({"time": 0, "eye": [1, 0, 0], "target": [1, 0, 0]})") ==
        "s.json: camera.keys[0]: eye and target are the same point; expected two different points");
  CHECK(top_error(R"("camera": {"eye": [1, 0, 0], "smooth": false})") ==
        "s.json: camera.smooth: has no keys to go through; expected camera.keys beside it");
}

TEST_CASE("methods, accelerations, integrators and material models that do not exist list those that do") {
  const std::string pairs = "; expected a method and acceleration that exist: " + list_of_choices();
  CHECK(top_error(R"("solver": {"method": "multigrid"})") == "s.json: solver.method: is \"multigrid\"" + pairs);
  CHECK(top_error(R"("solver": {"method": "jacoby"})") ==
        "s.json: solver.method: is \"jacoby\", perhaps \"jacobi\"" + pairs);
  CHECK(top_error(R"("solver": {"method": 1})") == "s.json: solver.method: is 1" + pairs);
  CHECK(top_error(R"("solver": {"acceleration": "quadratic_cg"})") ==
        "s.json: solver.acceleration: is \"quadratic_cg\"" + pairs);
  CHECK(top_error(R"("solver": {"integrator": "bdf"})") ==
        "s.json: solver.integrator: is \"bdf\", perhaps \"bdf2\"; expected implicit_euler, bdf2, sdirk2");
  CHECK(top_error(R"("solver": {"method": "jacobi", "acceleration": "chebychev"})") ==
        "s.json: solver.acceleration: is \"chebychev\", perhaps \"chebyshev\"" + pairs);
  const std::string models =
      "expected a model that exists: signed_st_venant_kirchhoff, st_venant_kirchhoff, stable_neo_hookean, neo_hookean, "
      "mooney_rivlin, squared";
  CHECK(body_error(R"("materials": {"default": {"model": "ogden"}})") ==
        "s.json: bodies[0].materials.default.model: is \"ogden\"; " + models);
  CHECK(body_error(R"("materials": {"2": {"model": "st_venant_kirchoff"}})") ==
        "s.json: bodies[0].materials.2.model: is \"st_venant_kirchoff\", perhaps \"st_venant_kirchhoff\"; " + models);
  CHECK(error_of(scene_text(R"("materials": {"2": {"model": "stable_neo_hookean"}})",
                            R"("solver": {"method": "jacobi"})")) ==
        "s.json: solver.method: jacobi does not support the material model stable_neo_hookean; expected one of the "
        "methods that do: two_level, vertex_descent");
}

TEST_CASE("values without physical meaning are refused") {
  CHECK(body_error(R"("materials": {"default": {"young_modulus": 0}})") ==
        "s.json: bodies[0].materials.default.young_modulus: is 0; expected 0.001 to 1e+14 Pa");
  CHECK(body_error(R"("materials": {"default": {"young_modulus": -5}})") ==
        "s.json: bodies[0].materials.default.young_modulus: is -5; expected 0.001 to 1e+14 Pa");
  CHECK(body_error(R"("materials": {"default": {"poisson_ratio": 0.5}})") ==
        "s.json: bodies[0].materials.default.poisson_ratio: is 0.5; expected -0.9 to 0.499");
  CHECK(body_error(R"("materials": {"tumour": {"density": 0}})") ==
        "s.json: bodies[0].materials.tumour.density: is 0; expected 0.001 to 1e+06 kg/m^3");
}
