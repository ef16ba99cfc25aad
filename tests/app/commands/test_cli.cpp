// The program as a user's script runs it: exit codes, one-line errors, files that appear complete or not at all.
// Covers: render, run, app/video/recorder, sim/output/run_provenance, sim/output/stats
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/provenance.h"
#include "render/target/image.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

// Checks the exit code, and that the error is one line that contains every given text.
void expect_failure(const std::vector<std::string>& arguments, const std::vector<std::string>& texts,
                    const fs::path& folder = ".", int exit_code = 1) {
  const CommandResult result = run_fascia(arguments, folder);
  INFO("stderr: " << result.err);
  CHECK(result.exit_code == exit_code);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(result.err.find("; ") != std::string::npos);  // the expected value
  for (const std::string& text : texts) {
    CAPTURE(text);
    CHECK(result.err.find(text) != std::string::npos);
  }
}

void expect_refusal(const std::string& set, const std::vector<std::string>& texts) {
  expect_failure({"run", cube_path(), "--quiet", "--steps", "1", "--set", set}, texts, ".", 2);
}

}  // namespace

TEST_CASE("usage errors exit with 2", "[cli]") {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"render", "--no-such-option"},
                                             {"run", "--steps", "-1"},
                                             {"run", "--context", "vulkan"},
                                             {"render", "--size", "12by7"},
                                             {"render", cube_path()},
                                             {"run", "--every", "2"},
                                             {"render", "--out", "x.png", "--fps", "30"},
                                             {"render", "--out", "x.png", "--slow", "2"},
                                             {"view", "--context", "osmesa"},
                                             {"run", "a.json", "--replay", "b.fascia"},
                                             {"render", "--color", "blue", "--out", "x.png"},
                                             {"info"},
                                             {"convert", "one.msh"},
                                             {"run", "--steps", "5", "--time", "1"}}) {
    const CommandResult result = run_fascia(arguments);
    CAPTURE(arguments, result.err);
    CHECK(result.exit_code == 2);
    CHECK(!result.err.empty());
  }
}

TEST_CASE("the number of worker threads changes no bit, with every method", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string method : {"jacobi", "mass_splitting", "gauss_seidel"}) {
    std::vector<std::string> states;
    for (const char* threads : {"0", "1", "2"}) {
      const fs::path out = folder / (method + threads + ".csv");
      const CommandResult result =
          run_command({"/usr/bin/env", std::string("LP_NUM_THREADS=") + threads, FASCIA_BINARY, "run", cube_path(),
                       "--quiet", "--context", "osmesa", "--steps", "5", "--set", "solver.method=" + method, "--set",
                       "solver.acceleration=anderson_positions", "--set",
                       "materials.default.model=signed_st_venant_kirchhoff", "--export", out.string()});
      CAPTURE(method, threads, result.err);
      REQUIRE(result.exit_code == 0);
      states.push_back(read_file(out));
    }
    CAPTURE(method);
    CHECK(states[0].size() > 1000);
    CHECK(states[0] == states[1]);
    CHECK(states[0] == states[2]);
  }
}

TEST_CASE("info reports colors and their balance", "[cli]") {
  const CommandResult result = run_fascia({"info", cube_path(), "--set", "solver.colors=5"});
  CAPTURE(result.out);
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("coloring     plain: ") != std::string::npos);
  CHECK(result.out.find("coloring     solver.colors 5: 5 colors of ") != std::string::npos);
  CHECK(result.out.find(" phantoms") != std::string::npos);
}

TEST_CASE("info names the tools of a scene", "[cli]") {
  const std::string scene = (source_dir() / "assets/scenes/kidney_lifted.json").string();
  const CommandResult result = run_fascia({"info", scene});
  CAPTURE(result.out);
  CHECK(result.exit_code == 0);
  CHECK(result.out.find("  tool         ground: plane, friction 0.5\n") != std::string::npos);
  CHECK(result.out.find("  tool         forceps: box as jaws, friction 0.9, moves until 4.8 s\n") != std::string::npos);
}

TEST_CASE("the singular is used for one item", "[cli]") {
  const TemporaryFolder folder;
  write_file(
      folder / "one.vtk",
      "# vtk DataFile Version 3.0\none\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0 .1 0 0 0 .1 0 0 0 .1\n"
      "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
  const std::string mesh = (folder / "one.vtk").string();
  const CommandResult info = run_fascia({"info", mesh}),
                      run = run_fascia({"run", mesh, "--steps", "1", "--context", "osmesa"});
  CAPTURE(info.out, run.err);
  CHECK(info.out.find("plain: 1 color of 1 tet, 0 phantoms") != std::string::npos);
  CHECK(run.err.find("fascia: 1 step, ") != std::string::npos);
}

TEST_CASE("help and version", "[cli]") {
  CHECK(run_fascia({"--version"}).out.rfind("fascia ", 0) == 0);
  for (const char* command : {"view", "render", "run", "info", "convert"}) {
    const CommandResult result = run_fascia({command, "--help"});
    CAPTURE(command);
    CHECK(result.exit_code == 0);
    CHECK(result.out.find("--help") != std::string::npos);
  }
}

TEST_CASE("bad input is one line and exit 1, or 2 if the option is wrong", "[cli]") {
  const TemporaryFolder folder;
  write_file(folder / "empty.msh", "");
  write_file(folder / "rubbish.msh", std::string("\x7f\x45\x4c\x46\0\1\2\3 not a mesh", 19));
  write_file(folder / "typo.json", "{\n  \"fascia_scene\": 1,\n  \"bodies\": [,]\n}\n");
  const std::string mesh = (source_dir() / "tests/reference/01_cantilever_small/mesh.msh").string();
  write_file(folder / "unknown_key.json", R"({"fascia_scene": 1, "bodies": [{"mesh": ")" + mesh +
                                              R"(", "materials": {"default": {"young_modulos": 1e5}}}]})");

  expect_failure({"run", (folder / "missing.msh").string()}, {"missing.msh", "no such file"});
  expect_failure({"run", folder.path().string()}, {"directory"});
  expect_failure({"run", (folder / "empty.msh").string()}, {"empty.msh"});
  expect_failure({"run", (folder / "rubbish.msh").string()}, {"rubbish.msh"});
  expect_failure({"run", (folder / "typo.json").string()}, {"typo.json:3:"});
  expect_failure({"run", (folder / "unknown_key.json").string()}, {"young_modulos", "young_modulus"});
  expect_refusal("materials.default.young_modulus=0", {"young_modulus"});
  expect_refusal("materials.default.poisson_ratio=0.5", {"poisson_ratio", "0.499"});
  expect_refusal("materials.default.density=-1", {"density"});
  expect_refusal("solver.iteratons=4", {"iteratons", "iterations"});
  expect_refusal("solver.method=three_level", {"three_level", "two_level", "jacobi"});
  expect_failure({"run", cube_path(), "--set", "fixed=[{\"sphere\":{\"center\":[9,9,9],\"radius\":0.1}}]"}, {"fixed"});
  expect_failure({"info", (folder / "missing.msh").string()}, {"no such file"});
  expect_failure({"convert", (folder / "missing.msh").string(), (folder / "out.vtk").string()}, {"no such file"});
  expect_failure({"convert", mesh, (folder / "out.stl").string()}, {"out.stl", ".vtk"}, ".", 2);
  expect_failure({"run", cube_path(), "--quiet", "--data-dir", folder.path().string()}, {"shaders"});
}

TEST_CASE("outputs that cannot be written", "[cli]") {
  const TemporaryFolder folder;
  expect_failure({"render", cube_path(), "--quiet", "--steps", "0", "--out", (folder / "no/such/shot.png").string()},
                 {"shot.png", "no such folder"});
  expect_failure({"run", cube_path(), "--quiet", "--steps", "1", "--export", (folder / "no/out.vtu").string()},
                 {"out.vtu"});
  expect_failure({"run", cube_path(), "--quiet", "--steps", "1", "--export", (folder / "out.txt").string()},
                 {"out.txt"}, ".", 2);
  CHECK(fs::is_empty(folder.path()));

  // A limit on file size simulates a full disk: the write fails in the same place.
  write_file(folder / "state.csv", "old");
  const CommandResult full =
      run_command({"/bin/sh", "-c", "ulimit -f 2; exec \"$@\"", "sh", FASCIA_BINARY, "run", cube_path(), "--quiet",
                   "--context", "osmesa", "--steps", "1", "--export", (folder / "state.csv").string()});
  INFO(full.err);
  CHECK(full.exit_code == 1);
  CHECK(full.err.find("state.csv: writing failed") != std::string::npos);
  CHECK(read_file(folder / "state.csv") == "old");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("ffmpeg missing or failing midway leaves no partial video", "[cli]") {
  const TemporaryFolder folder, tools;
  const auto render = [&](const std::string& path) {
    return run_command({"/usr/bin/env", "PATH=" + path, FASCIA_BINARY, "render", cube_path(), "--quiet", "--context",
                        "osmesa", "--size", "320x240", "--time", "1", "--video", (folder / "out.mp4").string()});
  };
  const CommandResult missing = render(tools.path().string());
  INFO(missing.err);
  CHECK(missing.exit_code == 1);
  CHECK(missing.err.find("ffmpeg") != std::string::npos);
  CHECK(fs::is_empty(folder.path()));

  const std::string first_frames = "#!/bin/sh\nhead -c 1000000 >/dev/null\n";
  struct {
    std::string end, said;
  } cases[] = {{"echo 'No space left on device' >&2\nexit 1\n", "(No space left on device)"},
               {"kill -9 $$\n", "ffmpeg stopped after "}};
  for (const auto& [end, said] : cases) {
    write_file(tools / "ffmpeg", first_frames + end);
    chmod((tools / "ffmpeg").c_str(), 0755);
    const CommandResult failing = render(tools.path().string() + ":/usr/bin:/bin");
    INFO(failing.err);
    CHECK(failing.exit_code == 1);
    CHECK(failing.err.find(said) != std::string::npos);
    CHECK(std::count(failing.err.begin(), failing.err.end(), '\n') == 1);
    CHECK(fs::is_empty(folder.path()));
  }
}

TEST_CASE("a picture carries its provenance", "[cli]") {
  const TemporaryFolder folder;
  const CommandResult result = run_fascia({"render", cube_path(), "--quiet", "--context", "osmesa", "--size", "160x120",
                                           "--steps", "3", "--out", (folder / "shot.png").string()});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(result.err.empty());
  const Image image = read_png(folder / "shot.png");
  CHECK(image.width == 160);
  CHECK(image.height == 120);
  const Metadata metadata = read_png_metadata(folder / "shot.png");
  const auto value = [&](const std::string& key) {
    for (const auto& [k, text] : metadata)
      if (k == key) return text;
    return std::string();
  };
  CHECK(value("Software").rfind("fascia ", 0) == 0);
  CHECK(value("Renderer").find("llvmpipe") != std::string::npos);
  CHECK(value("Mesh hash").size() == 16);
  CHECK(value("Moment").rfind("step 3", 0) == 0);
  CHECK(value("Command line").find("render") != std::string::npos);
  CHECK(nlohmann::json::parse(value("Parameters")).contains("solver"));
}

TEST_CASE("a video has the requested frames and size", "[cli]") {
  const TemporaryFolder folder;
  const std::string video = folder / "out.mp4";
  const CommandResult result = run_fascia({"render", cube_path(), "--quiet", "--context", "osmesa", "--size", "160x120",
                                           "--time", "0.5", "--fps", "30", "--video", video});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  const CommandResult probe =
      run_command({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                   "stream=width,height,nb_read_frames,r_frame_rate,codec_name", "-of", "csv=p=0", video});
  CHECK(probe.out == "h264,160,120,30/1,15\n");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("an animated GIF has the requested frames and size", "[cli]") {
  const TemporaryFolder folder;
  const std::string video = folder / "out.gif";
  const CommandResult result = run_fascia({"render", cube_path(), "--quiet", "--context", "osmesa", "--size", "160x120",
                                           "--time", "0.4", "--fps", "25", "--video", video});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(read_file(video).starts_with("GIF89a"));
  const CommandResult probe =
      run_command({"ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries",
                   "stream=codec_name,width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", video});
  CHECK(probe.out == "gif,160,120,25/1,10\n");
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("run exports a series and statistics", "[cli]") {
  const TemporaryFolder folder;
  const CommandResult result = run_fascia(
      {"run", cube_path(), "--quiet", "--steps", "6", "--export", "out.vtu", "--every", "3", "--stats", "stats.json"},
      folder.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(fs::exists(folder / "out.pvd"));
  int series = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) series += entry.path().extension() == ".vtu";
  CHECK(series == 3);  // rest, step 3, step 6
  const Provenance last = find_provenance(read_file(folder / "out_000002.vtu"));
  const auto moment = std::find_if(last.begin(), last.end(), [](const auto& entry) { return entry.first == "Moment"; });
  REQUIRE(moment != last.end());
  CHECK(moment->second.starts_with("step 6, "));
  const auto stats = nlohmann::json::parse(read_file(folder / "stats.json"));
  for (const char* key : {"version",
                          "renderer",
                          "vertices",
                          "tets",
                          "steps",
                          "time_step",
                          "iterations_per_step",
                          "wall_s",
                          "ms_per_step",
                          "solve_ms_per_step",
                          "residual",
                          "nan",
                          "inverted",
                          "kinetic_J",
                          "elastic_J",
                          "momentum",
                          "angular_momentum",
                          "reaction_N",
                          "dispatches_per_step",
                          "gpu_bytes",
                          "steps_asleep",
                          "kernels",
                          "gpu_buffers",
                          "tets_solved",
                          "share_solved",
                          "bytes_per_iteration"}) {
    CAPTURE(key);
    CHECK(stats.contains(key));
  }
  CHECK(stats["steps"] == 6);
  CHECK(stats["nan"] == false);
  CHECK(stats["ms_per_step"].contains("median"));
  CHECK(stats["steps_asleep"] == 0);
  std::size_t bytes = 0;
  for (const auto& [name, buffer] : stats["gpu_buffers"].items()) bytes += buffer.get<std::size_t>();
  CHECK(bytes == stats["gpu_bytes"]);
}

TEST_CASE("the same run gives the same state file, on every context", "[cli]") {
  const TemporaryFolder folder;
  std::string first;
  for (const std::vector<std::string>& how :
       std::vector<std::vector<std::string>>{{"--context", "osmesa"}, {"--context", "osmesa"}, {"--context", "egl"}}) {
    std::vector<std::string> arguments{
        "run", cube_path(), "--quiet", "--steps", "20", "--export", (folder / "state.csv").string()};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const CommandResult result = run_fascia(arguments);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    const std::string state = read_file(folder / "state.csv");
    if (first.empty()) first = state;
    CAPTURE(how);
    CHECK(state == first);
  }
}

TEST_CASE("a step within a frame budget gets the iterations that fit, at least one", "[cli]") {
  const TemporaryFolder folder;
  const auto iterations = [&](const std::string& milliseconds) {
    const std::string stats = (folder / "stats.json").string();
    const CommandResult result = run_fascia({"run", cube_path(), "--quiet", "--steps", "3", "--context", "osmesa",
                                             "--stats", stats, "--set", "solver.frame_budget=" + milliseconds});
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return nlohmann::json::parse(read_file(stats)).at("iterations_per_step").get<int>();
  };
  CHECK(iterations("0") == 10);
  CHECK(iterations("0.000001") == 1);
  CHECK(iterations("10000") == 10);
}

TEST_CASE("a mesh on its own opens, and info examines it", "[cli]") {
  const std::string mesh = (source_dir() / "tests/reference/01_cantilever_small/mesh.msh").string();
  CHECK(run_fascia({"run", mesh, "--quiet", "--steps", "2"}).exit_code == 0);
  const CommandResult info = run_fascia({"info", mesh});
  INFO(info.out << info.err);
  CHECK(info.exit_code == 0);
  CHECK(info.out.find("2069") != std::string::npos);
  CHECK(info.out.find("mat1") != std::string::npos);
}

TEST_CASE("a step kernel by kernel makes the bits of fused kernels with more dispatches") {
  const TemporaryFolder folder;
  const std::string scene = (source_dir() / "assets/scenes/cube.json").string();
  const auto run = [&](const std::string& kernels) {
    const std::string stats = (folder / (kernels + ".json")).string();
    const CommandResult result = run_fascia({"run", scene, "--steps", "4", "--context", "osmesa", "--kernels", kernels,
                                             "--hash", "--stats", stats, "--quiet"});
    CAPTURE(kernels, result.err);
    CHECK(result.exit_code == 0);
    return std::pair(result.out, nlohmann::json::parse(read_file(stats)).at("dispatches_per_step").get<long>());
  };
  const auto [fused_state, fused_dispatches] = run("auto");
  const auto [single_state, single_dispatches] = run("single");
  CAPTURE(fused_state, single_state, fused_dispatches, single_dispatches);
  CHECK(fused_state == single_state);
  CHECK(fused_dispatches * 3 < single_dispatches);
}
