// A graphics device that is reset while a window is open.
// Covers: window
#include <catch2/catch.hpp>

#include "app/session/graphics.h"
#include "app/session/open_input.h"
#include "app/window/window.h"
#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("hidden: the device is reset", "[.]") {
  ViewOptions options;
  options.width = 320;
  options.height = 240;
  options.quiet = true;
  options.input = "cube.json";
  Graphics graphics = open_graphics(options, true, options.width, options.height);
  Window window(graphics, options, open_input(options, {}));
  static int asked = 0;
  gl::GetGraphicsResetStatus = [] { return ++asked < 20 ? GLenum(GL_NO_ERROR) : GLenum(GL_INNOCENT_CONTEXT_RESET); };
  std::string said;
  try {
    window.run();
  } catch (const gl::ContextLost& lost) {
    said = lost.what();
  }
  gl::GetGraphicsResetStatus = nullptr;
  CHECK_THAT(said, Catch::Contains("the device was reset, caused by another program") &&
                       Catch::Contains(". The scene is kept in fascia-"));
}

TEST_CASE("a window whose device is reset ends and leaves the scene as it was") {
  const TemporaryFolder folder;
  const VirtualDisplay display(kWidth, kHeight);
  write_file(folder / "cube.json", cube_scene("Cube", 2e5));
  const Scene scene = open_scene(folder / "cube.json");
  const CommandResult child = run_command(
      {std::filesystem::read_symlink("/proc/self/exe").string(), "hidden: the device is reset"}, folder.path());
  CAPTURE(child.out, child.err);
  CHECK(child.exit_code == 0);
  std::vector<Replay> kept;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() == ".fascia") kept.push_back(read_replay(entry.path()));
  REQUIRE(kept.size() == 1);
  CHECK(kept[0].scene.title == "Cube");
  CHECK(build_model(kept[0].scene).materials == build_model(scene).materials);
  CHECK(kept[0].scene.camera.has_value());  // from the window, since the file has none
  CHECK(kept[0].start.has_value());
}
