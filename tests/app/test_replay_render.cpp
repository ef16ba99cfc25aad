// Replays that are drawn again: the same pictures every time, in other sizes, slower, from elsewhere.
#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include "render/image.h"
#include "sim/file.h"
#include "sim/replay.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

constexpr long kSteps = 12;  // of 1/60 s

// A cube that is pulled while the view turns and its colors change.
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
      replay.inputs.push_back({step, CameraSettings{{0.2 * static_cast<double>(step), 0.3, 1}, {0, 0.05, 0}, {0, 1, 0}, 40}});
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

TEST_CASE("a replay that is drawn twice gives the same frames and the same video, and the state that run gives", "[session]") {
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
  // Every frame differs from the one before: nothing stands still between two steps while the hand pulls.
  for (int k = 12; k < 40; ++k) {
    const auto name = [](int number) { return "slow/0" + std::to_string(number) + ".png"; };
    CAPTURE(k);
    CHECK(difference(read_png(pulled.folder / name(k)), read_png(pulled.folder / name(k + 1))).mean > 0);
  }
  // A frame on a step is the frame of that step at full speed.
  pulled.run("render", {"--video", "life/%d.png"});
  CHECK(difference(read_png(pulled.folder / "slow/024.png"), read_png(pulled.folder / "life/6.png")).mean == 0);
}

TEST_CASE("the camera of a replay can be followed, left or replaced", "[session]") {
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
  // A chosen display holds against the recorded one.
  CHECK(difference(picture("follow", "display.color=none"), followed).mean > 0.001);
  const CommandResult bad =
      run_fascia({"render", "--replay", "pulled.fascia", "--context", "osmesa", "--out", "x.png", "--camera", "1,2,3"}, pulled.folder.path());
  CHECK(bad.exit_code == 1);
  CHECK(bad.err.find("--camera 1,2,3: is no camera; expected follow, scene,") != std::string::npos);
}

TEST_CASE("more samples than the renderer has are averaged from shifted pictures", "[session]") {
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

TEST_CASE("what fascia wrote says what made it", "[session]") {
  const Pulled pulled;
  pulled.run("render", {"--out", "shot.png", "--video", "film.mp4"});
  pulled.run("render", {"--video", "film.webm", "--fps", "30"});
  CHECK(frames_of(pulled.folder / "film.webm").starts_with("96,64,30/1,6"));
  pulled.run("run", {"--export", "state.csv", "--stats", "stats.json"});
  pulled.run("run", {"--export", "state.vtu"});
  pulled.run("run", {"--export", "state.msh"});
  pulled.run("run", {"--export", "state.obj"});
  CHECK(read_file(pulled.folder / "state.csv").starts_with("index,x,y,z\n"));
  for (const char* file : {"shot.png", "film.mp4", "film.webm", "state.csv", "stats.json", "state.vtu", "state.msh", "state.obj"}) {
    const CommandResult info = run_fascia({"info", file}, pulled.folder.path());
    CAPTURE(file, info.out, info.err);
    CHECK(info.exit_code == 0);
    CHECK(info.out.find("fascia 0.") != std::string::npos);
    CHECK(info.out.find("--replay pulled.fascia") != std::string::npos);
    CHECK(info.out.find("llvmpipe") != std::string::npos);
    CHECK(info.out.find("young_modulus") != std::string::npos);
  }
  const CommandResult replay = run_fascia({"info", "pulled.fascia"}, pulled.folder.path());
  CHECK(replay.out.find("12 steps, 0.2 s") != std::string::npos);
  // Exports are meshes as before.
  CHECK(run_fascia({"run", "state.vtu", "--steps", "0", "--quiet", "--context", "osmesa"}, pulled.folder.path()).exit_code == 0);
  CHECK(run_fascia({"info", "state.msh"}, pulled.folder.path()).out.find("coloring") != std::string::npos);
}
