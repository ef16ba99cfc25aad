// The brush in the real window: fixed vertices and painted regions, by mouse and keys.
#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "base/file.h"
#include "sim/grab/build_model.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kX = kLargeMiddle, kY = kLargeHeight / 2;  // the middle of the tissue

// In the panel Brush, of which the lowest row is always at the bottom of the window:
constexpr std::pair kBrush{230, 91};   // the icon above it, which takes the brush in hand
constexpr std::pair kPaint{199, 657};  // above the row Lasso
constexpr std::pair kName{220, 658};   // above the row Tissue
constexpr std::pair kLasso{35, 658};   // above the row Region, once the region is known

class BrushWindow {
 public:
  BrushWindow() {
    write_file(file(), cube_scene("Cube", 2e4));
    window_.emplace(std::vector<std::string>{file().string(), "--size",
                                             std::to_string(kLargeWidth) + "x" + std::to_string(kLargeHeight)},
                    folder_.path());
    window_->screenshot();
  }

  std::filesystem::path file() const { return folder_ / "cube.json"; }
  std::filesystem::path folder() const { return folder_.path(); }
  std::filesystem::path sessions() const { return display_.state() / "sessions"; }
  FasciaWindow& window() { return *window_; }

  void click(std::pair<int, int> at) {
    window_->move(at.first, at.second);
    window_->press();
    window_->release();
    window_->screenshot();
  }
  void drag(const std::vector<std::pair<int, int>>& places) {
    window_->move(places.front().first, places.front().second);
    window_->press();
    for (const auto& [x, y] : places) window_->move(x, y);
    window_->release();
    window_->screenshot();
  }
  /// The scene that Ctrl+S saves, read and built.
  Model saved() {
    std::filesystem::remove(file());
    window_->key("ctrl+s");
    window_->key("Return");
    REQUIRE(eventually([&] { return std::filesystem::exists(file()); }));
    return build_model(open_scene(file()));
  }

 private:
  TemporaryFolder folder_;
  VirtualDisplay display_{kLargeWidth, kLargeHeight};
  std::optional<FasciaWindow> window_;
};

std::size_t tumour_in(const TetMesh& mesh) {
  const auto named = std::find_if(mesh.region_names.begin(), mesh.region_names.end(),
                                  [](const auto& region) { return region.second == "tumour"; });
  if (named == mesh.region_names.end()) return 0;
  return static_cast<std::size_t>(std::count(mesh.regions.begin(), mesh.regions.end(), named->first));
}

}  // namespace

TEST_CASE("vertices are fixed with the brush in the window, taken back and saved") {
  BrushWindow brush;
  const std::size_t before = brush.saved().fixed.size();
  REQUIRE(before > 0);
  brush.click(kBrush);
  brush.drag({{kX, kY}, {kX + 40, kY}});
  const std::size_t after = brush.saved().fixed.size();
  CHECK(after > before);
  brush.window().key("ctrl+z");
  brush.window().screenshot();
  CHECK(brush.saved().fixed.size() == before);
  brush.window().key("ctrl+y");
  brush.window().screenshot();
  CHECK(brush.saved().fixed.size() == after);
  brush.window().key("ctrl+q");
  CHECK(brush.window().wait() == 0);
}

TEST_CASE("a region is painted in the window by strokes and a lasso, taken back, saved, exported and replayed") {
  BrushWindow brush;
  FasciaWindow& window = brush.window();
  brush.click(kBrush);
  brush.click(kPaint);
  window.move(kName.first, kName.second);
  window.press();
  window.pause();
  window.release();
  window.pause();  // a screenshot would type its key
  window.key("ctrl+a");
  window.type("tumour");
  window.key("Return");
  window.move(kX, 60);  // beside the tissue
  const Screenshot plain = window.screenshot();
  brush.drag({{kX, kY}, {kX + 40, kY}});
  window.move(kX, 60);
  const Image painted = window.screenshot().image;
  INFO("the new tissue looks otherwise");
  CHECK(difference(right_part(plain.image, kPanels), right_part(painted, kPanels)).share > 0.002);
  const Model stroke = brush.saved();
  const std::size_t by_stroke = tumour_in(stroke.file_mesh);
  REQUIRE(by_stroke > 0);
  REQUIRE(stroke.materials.size() == 2);
  CHECK(stroke.materials[1].young_modulus == 42500);  // that of the tissue in the panel

  brush.click(kLasso);
  brush.drag({{kX - 90, kY - 90}, {kX + 90, kY - 90}, {kX + 90, kY + 90}, {kX - 90, kY + 90}});
  const std::size_t by_lasso = tumour_in(brush.saved().file_mesh);
  CHECK(by_lasso > by_stroke);

  window.key("ctrl+z");
  window.screenshot();
  CHECK(tumour_in(brush.saved().file_mesh) == by_stroke);
  window.key("ctrl+z");
  window.screenshot();
  const Model undone = brush.saved();
  CHECK(tumour_in(undone.file_mesh) == 0);
  CHECK(undone.materials.size() == 1);
  window.key("ctrl+y");
  window.screenshot();
  window.key("ctrl+y");
  window.screenshot();
  CHECK(tumour_in(brush.saved().file_mesh) == by_lasso);

  window.key("Escape");  // the brush is put away: the next drag is a grab
  brush.drag({{kX, kY}, {kX + 60, kY - 30}});
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
  CHECK(run_fascia({"run", "cube.json", "--steps", "1", "--export", "cube.vtu", "--context", "osmesa"}, brush.folder())
            .exit_code == 0);
  CHECK(tumour_in(read_mesh(brush.folder() / "cube.vtu").mesh) == by_lasso);
  std::filesystem::path session;
  for (const auto& entry : std::filesystem::directory_iterator(brush.sessions()))
    session = std::max(session, entry.path());
  REQUIRE_FALSE(session.empty());
  CHECK(tumour_in(build_model(read_replay(session).scene).file_mesh) == by_lasso);
  const CommandResult again = run_fascia({"run", "--replay", session.string()}, brush.folder());
  CAPTURE(again.err);
  CHECK(again.err.find("fascia: the state is the recorded one to the bit") != std::string::npos);
}
