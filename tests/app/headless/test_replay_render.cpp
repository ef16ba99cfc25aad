// Replays drawn again: the same pictures every time, in other sizes, slower, and with other cameras.
// Covers: headless, interpolated_frames, render_camera, video_render, app/session/file_provenance
// Covers: render/supersampler
#include <catch2/catch.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "render/target/image.h"
#include "sim/grab/build_model.h"
#include "sim/replay/replay.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

constexpr long kSteps = 12;  // of 1/60 s

// A cube that is pulled while the view rotates and its colors change.
struct Pulled {
  TemporaryFolder folder;
  Pulled() {
    Replay replay{open_scene(source_dir() / "assets/scenes/cube.json"), std::nullopt, {}, kSteps};
    const Model model = build_model(replay.scene);
    GrabInput springs;
    for (std::uint32_t v = 0; v < model.rest_positions.size(); v += 7) springs.push_back({v, {0.02, 0.01, 0}, 50});
    replay.inputs.push_back({0, springs});
    for (long step = 2; step < 9; ++step) {
      replay.inputs.push_back({step, GrabMove{{{springs.size(), {0.01 * static_cast<double>(step), 0, 0}}}}});
      replay.inputs.push_back(
          {step, CameraSettings{{0.2 * static_cast<double>(step), 0.3, 1}, {0, 0.05, 0}, {0, 1, 0}, 40}});
    }
    DisplaySettings shown;
    shown.color = ColorBy::strain;
    shown.range = Eigen::Vector2d(0, 0.5);
    shown.wireframe = true;
    replay.inputs.push_back({9, shown});
    write_replay(folder / "pulled.fascia", replay);
  }
  CommandResult run(const std::string& command, std::vector<std::string> more) const {
    more.insert(more.begin(), {command, "--replay", "pulled.fascia", "--context", "osmesa", "--quiet", "--hash"});
    if (command == "render") more.insert(more.end(), {"--size", "96x64"});
    CommandResult result = run_fascia(more, folder.path());
    CAPTURE(more, result.err);
    CHECK(result.exit_code == 0);
    return result;
  }
};

std::string line(const CommandResult& result, const std::string& begin) {
  const std::size_t at = result.out.find(begin);
  CAPTURE(result.out);
  REQUIRE(at != std::string::npos);
  return result.out.substr(at, result.out.find('\n', at) - at);
}

std::string frames_of(const fs::path& video) {
  return run_command({"ffprobe", "-v", "error", "-select_streams", "v:0", "-count_frames", "-show_entries",
                      "stream=width,height,nb_read_frames,r_frame_rate", "-of", "csv=p=0", video.string()})
      .out;
}

}  // namespace

TEST_CASE("a replay that is drawn twice gives the same frames and the same video, and the same state as run",
          "[session]") {
  const Pulled pulled;
  const CommandResult first = pulled.run("render", {"--video", "out.mp4", "--fps", "60"});
  const std::string video = read_file(pulled.folder / "out.mp4");
  const CommandResult second = pulled.run("render", {"--video", "out.mp4", "--fps", "60"});
  CHECK(first.out == second.out);
  CHECK((read_file(pulled.folder / "out.mp4") == video));
  CHECK(line(first, "frames ").ends_with(" 12"));
  CHECK(frames_of(pulled.folder / "out.mp4") == "96,64,60/1,12\n");
  CHECK(line(pulled.run("run", {}), "state ") == line(first, "state "));
}

TEST_CASE("a replay in slow motion has frames between the steps and ends in the same state", "[session]") {
  const Pulled pulled;
  const CommandResult slow = pulled.run("render", {"--video", "slow/%03d.png", "--slow", "4"});
  CHECK(line(slow, "frames ").ends_with(" 48"));
  CHECK(line(slow, "state ") == line(pulled.run("run", {}), "state "));
  // Every frame differs from the one before: the tissue moves between steps while the grab pulls.
  for (int k = 12; k < 40; ++k) {
    const auto name = [](int number) { return "slow/0" + std::to_string(number) + ".png"; };
    CAPTURE(k);
    CHECK(difference(read_png(pulled.folder / name(k)), read_png(pulled.folder / name(k + 1))).mean > 0);
  }
  // A frame on a step is the frame of that step at full speed.
  pulled.run("render", {"--video", "life/%d.png"});
  CHECK(difference(read_png(pulled.folder / "slow/024.png"), read_png(pulled.folder / "life/6.png")).mean == 0);
}

TEST_CASE("a video keeps its speed when the session changes its time step, with and without frames between steps",
          "[session]") {
  const Pulled pulled;
  Replay replay = read_replay(pulled.folder / "pulled.fascia");
  SolverSettings finer = replay.scene.solver;
  finer.time_step /= 2;
  const auto later =
      std::find_if(replay.inputs.begin(), replay.inputs.end(), [](const Input& input) { return input.step >= 4; });
  replay.inputs.insert(later, {4, finer});
  write_replay(pulled.folder / "pulled.fascia", replay);
  // 4 steps of 1/60 s, 8 of 1/120 s.
  CHECK(line(pulled.run("render", {"--video", "life/%d.png", "--fps", "60"}), "frames ").ends_with(" 8"));
  CHECK(
      line(pulled.run("render", {"--video", "slow/%d.png", "--fps", "60", "--slow", "2"}), "frames ").ends_with(" 16"));
  // Every second frame equals one at full speed. (Before the first step there is no grab yet; slow motion marks the
  // vertices that are grabbed at present.)
  for (int k = 1; k < 8; ++k) {
    CAPTURE(k);
    CHECK(difference(read_png(pulled.folder / ("life/" + std::to_string(k) + ".png")),
                     read_png(pulled.folder / ("slow/" + std::to_string(2 * k) + ".png")))
              .mean == 0);
  }
  CHECK(run_fascia({"info", "pulled.fascia"}, pulled.folder.path()).out.find("12 steps, 0.133333333 s") !=
        std::string::npos);
  CHECK(line(pulled.run("run", {"--time", "0.1"}), "state ") == line(pulled.run("run", {"--steps", "8"}), "state "));
  const CommandResult split =
      run_fascia({"render", "--replay", "pulled.fascia", "--context", "osmesa", "--size", "96x64", "--video",
                  "split.mp4", "--fps", "120", "--split", "solver.iterations=3"},
                 pulled.folder.path());
  CHECK(split.exit_code == 1);
  CHECK(split.err.find("--split: has no pictures between its steps") != std::string::npos);
}

TEST_CASE("a scene with a long list of vertices gets its video, and a name may look like a URL", "[session]") {
  const TemporaryFolder folder;
  nlohmann::json scene = nlohmann::json::parse(read_file(source_dir() / "assets/scenes/cube.json"));
  scene["bodies"][0]["mesh"] = (source_dir() / "assets/meshes/cube.msh").string();
  std::vector<int> vertices(40000);
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i] = static_cast<int>(i % 25);
  scene["bodies"][0]["fixed"] = {{{"vertices", vertices}}};
  scene["title"] = "a=b;c#d\\e";
  write_file(folder / "long.json", scene.dump());
  const CommandResult result = run_fascia({"render", "long.json", "--context", "osmesa", "--quiet", "--size", "96x64",
                                           "--steps", "3", "--video", "take:1.mp4"},
                                          folder.path());
  CAPTURE(result.err);
  REQUIRE(result.exit_code == 0);
  const CommandResult info = run_fascia({"info", "take:1.mp4"}, folder.path());
  CHECK(info.out.find("a=b;c#d\\e") != std::string::npos);
  CHECK(info.out.size() > 100000);
  CHECK(info.out.find("step 0") == std::string::npos);  // without a time
  CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 2);
}

TEST_CASE("the camera of a replay can be followed, ignored or replaced", "[session]") {
  const Pulled pulled;
  const auto picture = [&](const std::string& camera, const std::string& sets) {
    std::vector<std::string> more{"--out", "shot.png", "--camera", camera};
    if (!sets.empty()) more.insert(more.end(), {"--set", sets});
    pulled.run("render", more);
    return read_png(pulled.folder / "shot.png");
  };
  const Image followed = picture("follow", ""), still = picture("scene", ""), other = picture("0,0.3,-1,0,0.05,0", "");
  CHECK(difference(followed, still).mean > 0.001);
  CHECK(difference(followed, other).mean > 0.001);
  CHECK(difference(still, other).mean > 0.001);
  CHECK(difference(picture("pulled.fascia", ""), followed).mean == 0);
  // A chosen display overrides the recorded one.
  CHECK(difference(picture("scene", "display.color=none"), still).mean > 0.001);
  const CommandResult bad =
      run_fascia({"render", "--replay", "pulled.fascia", "--context", "osmesa", "--out", "x.png", "--camera", "1,2,3"},
                 pulled.folder.path());
  CHECK(bad.exit_code == 2);
  CHECK(bad.err.find("--camera 1,2,3: is not a camera; expected follow, scene,") != std::string::npos);
}

TEST_CASE("more samples than the renderer provides are averaged from shifted pictures", "[session]") {
  const Pulled pulled;
  const auto picture = [&](const std::string& samples) {
    pulled.run("render", {"--out", "shot.png", "--samples", samples});
    return read_png(pulled.folder / "shot.png");
  };
  const Image four = picture("4"), sixteen = picture("16"), many = picture("64");
  const double far = difference(four, many).mean, near = difference(sixteen, many).mean;
  CAPTURE(far, near);
  CHECK(near > 0);
  CHECK(near < far);  // it converges
  CHECK(far < 0.02);  // to the same picture
}

TEST_CASE("files of fascia contain their provenance", "[session]") {
  const Pulled pulled;
  pulled.run("render", {"--out", "shot.png", "--video", "film.mp4", "--set", "title=it's two words"});
  pulled.run("render", {"--video", "film.webm", "--fps", "30"});
  CHECK(frames_of(pulled.folder / "film.webm").starts_with("96,64,30/1,6"));
  pulled.run("run", {"--export", "state.csv", "--stats", "stats.json"});
  pulled.run("run", {"--export", "state.vtu"});
  pulled.run("run", {"--export", "state.msh"});
  pulled.run("run", {"--export", "state.obj"});
  CHECK(read_file(pulled.folder / "state.csv").starts_with("index,x,y,z\n"));
  for (const char* file :
       {"shot.png", "film.mp4", "film.webm", "state.csv", "stats.json", "state.vtu", "state.msh", "state.obj"}) {
    const CommandResult info = run_fascia({"info", file}, pulled.folder.path());
    CAPTURE(file, info.out, info.err);
    CHECK(info.exit_code == 0);
    CHECK(info.out.find("fascia 0.") != std::string::npos);
    CHECK(info.out.find("--replay pulled.fascia") != std::string::npos);
    CHECK(info.out.find("llvmpipe") != std::string::npos);
    CHECK(info.out.find("young_modulus") != std::string::npos);
  }
  CHECK(run_fascia({"info", "shot.png"}, pulled.folder.path()).out.find(R"(--set 'title=it'\''s two words')") !=
        std::string::npos);
  const CommandResult replay = run_fascia({"info", "pulled.fascia"}, pulled.folder.path());
  CHECK(replay.out.find("12 steps, 0.2 s") != std::string::npos);
  // Exports are still meshes.
  CHECK(run_fascia({"run", "state.vtu", "--steps", "0", "--quiet", "--context", "osmesa"}, pulled.folder.path())
            .exit_code == 0);
  CHECK(run_fascia({"info", "state.msh"}, pulled.folder.path()).out.find("coloring") != std::string::npos);
}
