// What tests of every folder share.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace fascia::test {

std::filesystem::path test_dir();    // tests/ in the source tree
std::filesystem::path source_dir();  // the source tree: assets/, shaders/

/// Where the tests of OpenGL run: on OSMesa and on EGL, or, with FASCIA_TEST_CONTEXT=egl, on EGL alone, which takes a
/// graphics card first.
std::vector<std::string> context_names();

/// A fresh folder, removed at the end of the test.
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
/// Runs a program with arguments, no shell, and collects what it prints.
CommandResult run_command(const std::vector<std::string>& arguments, const std::filesystem::path& folder = ".");
CommandResult run_fascia(std::vector<std::string> arguments, const std::filesystem::path& folder = ".");

}  // namespace fascia::test
