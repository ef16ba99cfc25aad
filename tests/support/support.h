// The common part of tests in all folders.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia::test {

std::filesystem::path test_dir();    // tests/ in the source tree
std::filesystem::path source_dir();  // the source tree: assets/, shaders/
std::string cube_path();             // of assets/scenes/cube.json

bool contains(const std::string& text, const std::string& part);

/// The contexts of the OpenGL tests: OSMesa and EGL, or, with FASCIA_TEST_CONTEXT=egl, only EGL, which prefers a
/// graphics card.
std::vector<std::string> context_names();

/// A new folder, removed at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

struct CommandResult {
  int exit_code;
  std::string out, err;
};
/// Runs a program with arguments, without a shell, and collects its output.
CommandResult run_command(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".");
CommandResult run_fascia(std::vector<std::string> arguments, const std::filesystem::path& folder = ".");

}  // namespace fascia::test
