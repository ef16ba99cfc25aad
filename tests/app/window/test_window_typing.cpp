// Numbers typed at the sliders of the real window, with any part of the input between two pictures, as at a low frame
// rate.
#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "sim/replay/replay.h"
#include "tests/support/window/window_fixture.h"

using namespace fascia;
using namespace fascia::test;

namespace {

constexpr int kSlider = 214, kYoung = 280,
              kDensity = 338;  // near the right end of the slider; rows of the panel Material

struct TypingDesk {
  TemporaryFolder folder;
  VirtualDisplay display{1000, 700};
  FasciaWindow window{{scene(), "--size", "1000x700"}, folder.path()};

  std::string scene() const {
    write_file(folder / "cube.json", cube_scene("Test cube", 2e4));
    return (folder / "cube.json").string();
  }
  /// All materials that were set, in order, from the recorded session.
  std::vector<Material> materials() const {
    std::vector<Material> all;
    for (const auto& entry : std::filesystem::directory_iterator(display.state() / "sessions"))
      for (const Input& input : read_replay(entry.path()).inputs)
        if (const auto* material = std::get_if<MaterialInput>(&input.change)) all.push_back(material->material);
    return all;
  }
};

}  // namespace

TEST_CASE("a slider accepts only the number that is typed, for any timing of pictures between click and keys",
          "[typing]") {
  TypingDesk desk;
  FasciaWindow& window = desk.window;
  window.screenshot();
  std::string text;
  const std::vector<std::function<void()>> input = {[&] { window.key_down("ctrl"); }, [&] { window.press(); },
                                                    [&] { window.release(); },        [&] { window.key_up("ctrl"); },
                                                    [&] { window.type(text); },       [&] { window.key("Return"); }};
  std::vector<double> typed;
  for (const int row : {kYoung, kDensity}) {
    const bool young = row == kYoung;
    for (std::size_t cut = 0; cut < input.size(); ++cut) {
      const int number = 30 + static_cast<int>(10 * cut);
      text = young ? std::to_string(number) + " kPa" : std::to_string(1000 + number);
      typed.push_back(young ? 1e3 * number : 1000 + number);
      window.move(kSlider, row);
      window.hold();
      for (std::size_t i = 0; i < cut; ++i) input[i]();
      window.go_on();
      window.pause();  // pictures or none: the result must be the same
      window.hold();
      for (std::size_t i = cut; i < input.size(); ++i) input[i]();
      window.go_on();
      const auto value = [&] {
        const std::vector<Material> all = desk.materials();
        return all.empty() ? 0 : young ? all.back().young_modulus : all.back().density;
      };
      INFO("after " << cut << " inputs a picture; typed " << text);
      CHECK(eventually([&] { return value() == typed.back() || !window.running(); }));
    }
  }
  std::vector<double> set;
  for (const Material& material : desk.materials())
    set.push_back(set.size() < input.size() ? material.young_modulus : material.density);
  CAPTURE(typed, set);
  CHECK(set == typed);
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("a click and a drag act where they were made, however far the mouse is at the next picture", "[typing]") {
  TypingDesk desk;
  FasciaWindow& window = desk.window;
  const Screenshot rest = window.screenshot();
  CHECK_FALSE(rest.wireframe);
  window.hold();
  window.move(278, kYoung);  // the number
  window.press();
  window.release();
  window.move(700, 300);
  window.type("40 kPa");
  window.key("Return");
  window.go_on();
  CHECK(eventually([&] { return window.screenshot().young_modulus == 4e4; }));

  INFO("a drag of the knob, all of it between two pictures");
  window.hold();
  window.move(kSlider, kYoung);
  window.press();
  window.move(kSlider - 20, kYoung);
  window.release();
  window.move(700, 300);
  window.go_on();
  double dragged = 0;
  CHECK(eventually([&] { return (dragged = window.screenshot().young_modulus) != 4e4; }));
  window.move(kSlider - 20, kYoung);
  window.press();
  window.release();
  window.move(700, 300);
  window.screenshot();
  CAPTURE(dragged, window.screenshot().young_modulus);
  CHECK(window.screenshot().young_modulus == dragged);

  INFO("a double click leaves the value as it was");
  window.move(kSlider, kYoung);
  window.hold();
  for (int i = 0; i < 2; ++i) {
    window.press();
    window.release();
  }
  window.key("Escape");
  window.go_on();
  CHECK(window.screenshot().young_modulus == dragged);
}

TEST_CASE("Young's modulus below 1 Pa and numbers beyond a slider's range are refused, and the value is kept",
          "[typing]") {
  TypingDesk desk;
  FasciaWindow& window = desk.window;
  window.screenshot();
  for (const char* refused : {"0.5 Pa", "0", "1 mPa", "-3 kPa", "1e15"}) {
    window.move(278, kYoung);
    window.press();
    window.release();
    window.type(refused);
    window.key("Return");
    window.key("Escape");
    const Screenshot shot = window.screenshot();
    CAPTURE(refused, shot.young_modulus);
    CHECK(shot.young_modulus == 2e4);
  }
  window.move(278, kYoung);
  window.press();
  window.release();
  window.type("1 Pa");
  window.key("Return");
  CHECK(eventually([&] { return window.screenshot().young_modulus == 1; }));
  for (const Material& material : desk.materials()) CHECK(material.young_modulus >= 1);
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("off is taken for 0 where 0 means off", "[typing]") {
  TypingDesk desk;
  FasciaWindow& window = desk.window;
  window.screenshot();
  constexpr int kDamping = kYoung + 87;  // three rows below
  for (const auto& [text, expected] : {std::pair{"20 ms", 0.02}, {"off", 0.0}}) {
    window.move(278, kDamping);
    window.press();
    window.release();
    window.type(text);
    window.key("Return");
    CAPTURE(text);
    CHECK(eventually([&, value = expected] {
      window.pause();
      const std::vector<Material> all = desk.materials();
      return !all.empty() && all.back().damping == value;
    }));
  }
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}

TEST_CASE("text for a dialog may arrive together with the keys that open it", "[typing]") {
  TypingDesk desk;
  FasciaWindow& window = desk.window;
  write_file(desk.folder / "second.json", cube_scene("Second", 3e4));
  window.screenshot();
  window.hold();
  window.key("ctrl+o");
  window.type((desk.folder / "second.json").string());
  window.key("Return");
  window.go_on();
  CHECK(eventually([&] { return window.screenshot().title == "Second"; }));
  window.key("ctrl+q");
  CHECK(window.wait() == 0);
}
