// The common part of the tests of scenes and models: scene texts written to files, and the text of an error.
#pragma once
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene.h"
#include "tests/support/support.h"

namespace fascia::test {

/// A scene file in its own folder; errors are compared without the folder.
class SceneFile {
 public:
  explicit SceneFile(const std::string& text, const std::string& name = "s.json") : path_(folder_ / name) {
    write_file(path_, text);
  }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  Scene open(const std::vector<std::string>& overrides = {}) const { return open_scene(path_, overrides); }

  /// The error of `action`, one line, without the folder; "" and a failed check if there is none.
  template <class F>
  std::string error_of(F&& action) const {
    try {
      action();
    } catch (const Error& error) {
      std::string text = error.what();
      const std::string folder = folder_.path().string() + "/";
      for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
      CAPTURE(text);
      CHECK(text.find('\n') == std::string::npos);
      return text;
    }
    FAIL_CHECK("no error");
    return "";
  }
  std::string open_error(const std::vector<std::string>& overrides = {}) const {
    return error_of([&] { open(overrides); });
  }

 private:
  TemporaryFolder folder_;
  std::filesystem::path path_;
};

/// A scene of one body with `keys` in it ("\"fixed\": []") and `top` beside the bodies.
inline std::string scene_text(const std::string& keys = "", const std::string& top = "") {
  return "{\"fascia_scene\": 1, \"bodies\": [{\"mesh\": \"m.msh\"" + (keys.empty() ? "" : ", " + keys) + "}]" +
         (top.empty() ? "" : ", " + top) + "}";
}

/// A scene of one body with these materials.
inline std::string scene_with_materials(const std::string& materials) {
  return scene_text("\"materials\": " + materials);
}

}  // namespace fascia::test
