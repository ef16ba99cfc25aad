// Files and devices under faults: a process killed while it writes, a full disk, read-only folders, two writers of one
// file, a file larger than memory, a graphics card without a driver. FASCIA_KILLS: the number of kills; scripts/kill.sh
// sets it.
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>

#include "base/file.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_generate.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;
using Arguments = std::vector<std::string>;

int kills() {
  const char* const asked = std::getenv("FASCIA_KILLS");
  return asked ? std::atoi(asked) : 20;
}

/// Starts fascia with its output discarded.
pid_t start_fascia(const Arguments& arguments, const fs::path& folder) {
  std::vector<char*> argv{const_cast<char*>(FASCIA_BINARY)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  if (chdir(folder.c_str()) != 0 || !std::freopen("/dev/null", "w", stderr)) _exit(126);
  execv(argv[0], argv.data());
  _exit(127);
}

int wait_for(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Kills runs of fascia at random times within their duration, which is adapted to the number of runs that end before:
/// the load of a machine varies.
class Killer {
 public:
  explicit Killer(Clock::duration whole) : whole_(whole) {}
  void run(const Arguments& arguments, const fs::path& folder) {
    const pid_t child = start_fascia(arguments, folder);
    std::this_thread::sleep_for(whole_ * (random_() % 1100) / 1000);
    kill(child, SIGKILL);
    const bool ended = wait_for(child) == 0;
    finished_ += ended;
    whole_ = ended ? whole_ * 3 / 4 : whole_ * 4 / 3;
  }
  int finished() const { return finished_; }  // runs that ended before they could be killed

 private:
  Clock::duration whole_;
  std::mt19937 random_{4711};
  int finished_ = 0;
};

std::size_t temporary_files(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                    [](const auto& entry) { return entry.path().filename().string()[0] == '.'; }));
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

/// Two meshes and their conversions to .vtk.
struct TwoMeshes {
  TemporaryFolder folder;
  std::string texts[2];
  Clock::duration longest{};

  explicit TwoMeshes(int cells) {
    for (int i = 0; i < 2; ++i) {
      write_mesh(mesh(i), make_box(cells + i, cells, cells, {1, 1, 1}));
      const Clock::time_point start = Clock::now();
      const CommandResult result = run_fascia({"convert", mesh(i), (folder / "whole.vtk").string()});
      longest = std::max(longest, Clock::now() - start);
      INFO(result.err);
      REQUIRE(result.exit_code == 0);
      texts[i] = read_file(folder / "whole.vtk");
    }
    REQUIRE(texts[0] != texts[1]);
  }
  std::string mesh(int i) const { return (folder / (i == 0 ? "a.msh" : "b.msh")).string(); }
};

/// The prefix of a command with its own mount namespace: its mounts disappear with the command. Empty if mounting is
/// not permitted.
Arguments in_own_mounts() {
  for (const Arguments& own :
       {Arguments{"unshare", "--mount"}, Arguments{"unshare", "--user", "--map-root-user", "--mount"}}) {
    Arguments probe = own;
    probe.insert(probe.end(), {"sh", "-c", "mount -t tmpfs -o size=64k none /mnt"});
    if (run_command(probe).exit_code == 0) return own;
  }
  return {};
}

/// Runs a shell script with $1 = fascia, $2 = a folder, $3 = a mesh in its own mounts. None if mounting is not
/// permitted.
std::optional<CommandResult> run_in_own_mounts(const std::string& script, const fs::path& folder,
                                               const fs::path& mesh) {
  Arguments arguments = in_own_mounts();
  if (arguments.empty()) {
    WARN("skipped: this user may mount nothing, not even in a namespace of its own");
    return std::nullopt;
  }
  arguments.insert(arguments.end(), {"sh", "-c", script, "sh", FASCIA_BINARY, folder.string(), mesh.string()});
  return run_command(arguments);
}

void check_one_line(const CommandResult& result, const std::string& text) {
  INFO("stderr: " << result.err);
  CHECK(result.exit_code == 1);
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  CHECK(result.err.find("; expected ") != std::string::npos);
  CHECK(result.err.find(text) != std::string::npos);
}

const fs::path& small_mesh() {
  static const fs::path path = source_dir() / "tests/reference/01_cantilever_small/mesh.msh";
  return path;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool memory_can_be_limited = false;  // the sanitizer itself reserves terabytes of addresses
#else
constexpr bool memory_can_be_limited = true;
#endif

}  // namespace

TEST_CASE("a killed conversion leaves the old file or the new one", "[faults][kill]") {
  const TwoMeshes meshes(20);
  const fs::path out = meshes.folder / "out.vtk";
  write_file(out, meshes.texts[0]);
  Killer killer(meshes.longest);
  int now = 0, old = 0, fresh = 0, half = 0;
  std::size_t left = 0;
  for (int i = 0; i < kills(); ++i) {
    killer.run({"convert", meshes.mesh(1 - now), out.string()}, meshes.folder.path());
    const std::string text = read_file(out);
    ++(text == meshes.texts[now] ? old : text == meshes.texts[1 - now] ? fresh : half);
    if (text == meshes.texts[1 - now]) now = 1 - now;
    left = std::max(left, temporary_files(meshes.folder.path()));
  }
  std::printf("convert, %d kills: %d old, %d new, %d half; %d ended before; at most %zu temporary files left\n",
              kills(), old, fresh, half, killer.finished(), left);
  CHECK(half == 0);
  CHECK(old > 0);
  CHECK(run_fascia({"convert", meshes.mesh(0), out.string()}).exit_code == 0);
  CHECK(temporary_files(meshes.folder.path()) == 0);  // of the killed processes
}

TEST_CASE("a killed run leaves complete exports and statistics", "[faults][kill]") {
  const TemporaryFolder whole, killed;
  const Arguments arguments{"run",      (source_dir() / "assets/scenes/cube.json").string(),
                            "--quiet",  "--reference",
                            "--steps",  "10",
                            "--every",  "1",
                            "--export", "out.vtu",
                            "--stats",  "stats.json"};
  const Clock::time_point start = Clock::now();
  const CommandResult result = run_fascia(arguments, whole.path());
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  Killer killer(Clock::now() - start);
  int files = 0, half = 0;
  std::size_t left = 0;
  for (int i = 0; i < kills(); ++i) {
    killer.run(arguments, killed.path());
    for (const auto& entry : fs::directory_iterator(killed.path())) {
      const std::string name = entry.path().filename();
      if (name[0] == '.') continue;
      const std::string text = read_file(entry.path());
      ++files;
      half += name == "stats.json"                 ? !nlohmann::json::accept(text)
              : entry.path().extension() == ".pvd" ? !text.ends_with("</VTKFile>\n")
                                                   : text != read_file(whole / name);
    }
    left = std::max(left, temporary_files(killed.path()));
  }
  std::printf("run, %d kills: %d files looked at, %d half; %d runs ended before; at most %zu temporary files left\n",
              kills(), files, half, killer.finished(), left);
  CHECK(half == 0);
  CHECK(files > 0);
  CHECK(run_fascia(arguments, killed.path()).exit_code == 0);
  CHECK(names_in(killed.path()) == names_in(whole.path()));
}

TEST_CASE("two programs that write the same file leave the file of one of them", "[faults]") {
  const TwoMeshes meshes(6);
  const fs::path out = meshes.folder / "out.vtk";
  int of[2] = {0, 0};
  constexpr int times = 50;
  for (int i = 0; i < times; ++i) {
    const pid_t first = start_fascia({"convert", meshes.mesh(0), out.string()}, meshes.folder.path());
    const pid_t second = start_fascia({"convert", meshes.mesh(1), out.string()}, meshes.folder.path());
    CHECK(wait_for(first) == 0);
    CHECK(wait_for(second) == 0);
    const std::string text = read_file(out);
    for (int k = 0; k < 2; ++k) of[k] += text == meshes.texts[k];
  }
  std::printf("two writers, %d times: %d of the first, %d of the second, %d neither\n", times, of[0], of[1],
              times - of[0] - of[1]);
  CHECK(of[0] + of[1] == times);
  CHECK(temporary_files(meshes.folder.path()) == 0);
}

TEST_CASE("a full disk leaves only the old file", "[faults]") {
  const TemporaryFolder folder;
  const auto result = run_in_own_mounts(
      "mount -t tmpfs -o size=64k none \"$2\" && cd \"$2\" && printf old >out.vtk && { \"$1\" convert \"$3\" out.vtk; "
      "code=$?; ls -A; cat out.vtk; exit $code; }",
      folder.path(), small_mesh());
  if (!result) return;
  check_one_line(*result, "out.vtk: writing failed: No space left on device");
  CHECK(result->out == "out.vtk\nold");
}

TEST_CASE("a full device behind a report or a file is an error", "[faults]") {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "out.vtk");
  check_one_line(run_fascia({"convert", small_mesh().string(), (folder / "out.vtk").string()}),
                 "No space left on device");
  check_one_line(run_command({"sh", "-c", "\"$1\" info \"$2\" >/dev/full", "sh", FASCIA_BINARY, small_mesh().string()}),
                 "standard output: writing failed");
}

TEST_CASE("a graphics card that cannot be used is named before the software renderer takes its place", "[faults]") {
  const TemporaryFolder folder;
  const auto result = run_in_own_mounts(
      "mount -t tmpfs none /dev && mkdir /dev/dri && : >/dev/dri/card0 && \"$1\" run \"$3\" --steps 1", folder.path(),
      small_mesh());
  if (!result) return;
  INFO(result->err);
  CHECK(result->exit_code == 0);
  CHECK(result->err.find("\nfascia: no GPU is used: egl: no GPU; found ") != std::string::npos);
}

TEST_CASE("a read-only folder", "[faults]") {
  const TemporaryFolder folder;
  write_file(folder / "old.vtk", "old");
  const std::string mount = "mount --bind \"$2\" \"$2\" && mount -o remount,ro,bind \"$2\" && ";
  for (const std::string name : {"old.vtk", "new.vtk"}) {
    const auto result = run_in_own_mounts(mount + "\"$1\" convert \"$3\" \"$2\"/" + name, folder.path(), small_mesh());
    if (!result) return;
    check_one_line(*result, name + ": cannot be written: Read-only file system");
  }
  CHECK(names_in(folder.path()) == std::vector<std::string>{"old.vtk"});
  CHECK(read_file(folder / "old.vtk") == "old");
}

TEST_CASE("a read-only file is kept, and so are permissions", "[faults]") {
  const TemporaryFolder folder;
  write_file(folder / "mesh.msh", read_file(small_mesh()));
  fs::permissions(folder.path(), fs::perms::all);
  write_file(folder / "out.vtk", "old");
  Arguments arguments;
  if (geteuid() == 0) {  // root may write everything
    arguments = {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"};
    Arguments probe = arguments;
    probe.insert(probe.end(), {FASCIA_BINARY, "--version"});
    if (run_command(probe).exit_code != 0) {
      WARN("skipped: run by root, and no other user can run " << FASCIA_BINARY);
      return;
    }
    REQUIRE(chown((folder / "out.vtk").c_str(), 65534, 65534) == 0);
  }
  arguments.insert(arguments.end(),
                   {FASCIA_BINARY, "convert", (folder / "mesh.msh").string(), (folder / "out.vtk").string()});
  fs::permissions(folder / "out.vtk", fs::perms::owner_read);
  check_one_line(run_command(arguments), "out.vtk: cannot be written: Permission denied");
  CHECK(read_file(folder / "out.vtk") == "old");

  fs::permissions(folder / "out.vtk", fs::perms::owner_read | fs::perms::owner_write);
  const CommandResult result = run_command(arguments);
  INFO(result.err);
  CHECK(result.exit_code == 0);
  CHECK(fs::status(folder / "out.vtk").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(names_in(folder.path()) == std::vector<std::string>{"mesh.msh", "out.vtk"});
}

TEST_CASE("a file larger than memory is a one-line error", "[faults]") {
  if (!memory_can_be_limited) {
    WARN("skipped: memory cannot be limited under the address sanitizer");
    return;
  }
  const TemporaryFolder folder;
  const auto info = [&](const std::string& name) {
    CommandResult result = run_command(
        {"sh", "-c", "ulimit -v 1000000; \"$1\" info \"$2\"", "sh", FASCIA_BINARY, (folder / name).string()});
    // Where reading takes long, its progress is reported before.
    for (std::size_t end; (end = result.err.find('\n')) != std::string::npos && result.err.find("Reading, ") < end;)
      result.err.erase(0, end + 1);
    return result;
  };
  write_file(folder / "large.msh", "$MeshFormat\n");
  fs::resize_file(folder / "large.msh", std::uintmax_t{2} << 30);  // sparse
  check_one_line(info("large.msh"), "large.msh: needs more than 2.1 GB of memory, ");

  // A file that can be read but whose vertices do not fit beside it: 28 bytes in the file, 24 more in memory each.
  constexpr std::uintmax_t vertices = 20000000;
  std::string head = "$MeshFormat\n2.2 1 8\n" + std::string("\1\0\0\0", 4) + "\n$EndMeshFormat\n$Nodes\n" +
                     std::to_string(vertices) + "\n";
  write_file(folder / "vertices.msh",
             [&](std::ostream& out) {  // half of it is stored: a file that is mostly a hole is not read at all
               out << head;
               const std::string million(1000000, '\1');
               for (std::uintmax_t written = 0; written < 15 * vertices; written += million.size()) out << million;
             });
  fs::resize_file(folder / "vertices.msh", head.size() + 28 * vertices + 100);
  check_one_line(info("vertices.msh"), "vertices.msh: needs more memory than there is");
}
