// The common part of the tests that need OpenGL: their contexts, and a shader folder for each test.
#pragma once
#include <catch2/catch.hpp>

#include <fstream>
#include <memory>
#include <string>

#include "base/error.h"
#include "gl/loader.h"
#include "render/context/context.h"
#include "tests/support/support.h"

namespace fascia::test {

/// Runs the rest of the test case once on each of context_names().
inline std::unique_ptr<Context> each_context() {
  const auto name = GENERATE(from_range(context_names()));
  INFO(name);
  auto context = make_context({.name = name, .title = ""});
  REQUIRE(context->name() == name);
  return context;
}

/// Whether passes are fused in the current context (gl/fused_pass.h); prints a message if not.
inline bool fuses_here() {
  if (gl::device().vector_width > 0) return true;
  WARN("passes are fused on llvmpipe only, not on " << gl::device().renderer);
  return false;
}

/// A temporary folder that contains the project's common/io.glsl.
class ShaderFolder {
 public:
  ShaderFolder() {
    std::filesystem::create_directory(folder_ / "common");
    for (const char* file : {"common/io.glsl", "common/last_group.glsl"})
      std::filesystem::copy(source_dir() / "shaders" / file, folder_ / file);
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

/// The message of the Error that `action` must throw.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  FAIL("no Error was thrown");
  return "";
}

}  // namespace fascia::test
