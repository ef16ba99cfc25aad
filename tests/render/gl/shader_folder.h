// A shader folder of a test's own, with the project's common/io.glsl in it, and the contexts that tests run
// on.
#pragma once
#include <fstream>
#include <memory>

#include "render/context.h"
#include "tests/support/support.h"

namespace fascia::test {

class ShaderFolder {
 public:
  ShaderFolder() {
    std::filesystem::create_directory(folder_ / "common");
    std::filesystem::copy(source_dir() / "shaders/common/io.glsl", folder_ / "common/io.glsl");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

inline std::unique_ptr<Context> make_test_context(const std::string& name) {
  return name == "osmesa" ? make_osmesa_context({}) : make_egl_context({}, EglDevices::any);
}

}  // namespace fascia::test
