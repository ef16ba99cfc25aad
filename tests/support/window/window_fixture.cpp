#include "tests/support/window/window_fixture.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "app/system/user_settings.h"

namespace fascia::test {

std::vector<std::string> with_size(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--size", std::to_string(kWidth) + "x" + std::to_string(kHeight)});
  return arguments;
}
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kLimit = std::chrono::seconds(240);
constexpr auto kPoll = std::chrono::milliseconds(50);

pid_t start(const std::vector<std::string>& arguments, const fs::path& folder, const fs::path& log) {
  std::vector<char*> argv;
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  if (chdir(folder.c_str()) != 0) _exit(126);
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, 1);
  dup2(out, 2);
  execvp(argv[0], argv.data());
  _exit(127);
}

void xdotool(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "xdotool");
  const CommandResult result = run_command(arguments);
  if (result.exit_code != 0) throw std::runtime_error("xdotool " + arguments[1] + ": " + result.err);
}

std::set<fs::path> pictures(const fs::path& folder) {
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png" && entry.path().filename().string().starts_with("fascia-"))
      found.insert(entry.path());
  return found;
}

}  // namespace

bool eventually(const std::function<bool()>& condition) {
  for (const auto end = Clock::now() + kLimit; Clock::now() < end; std::this_thread::sleep_for(kPoll))
    if (condition()) return true;
  return false;
}

VirtualDisplay::VirtualDisplay(int width, int height) : size_(std::to_string(width) + "x" + std::to_string(height)) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const std::string screen = size_ + "x24", fd = std::to_string(ends[1]);
  server_ = fork();
  if (server_ == 0) {
    close(ends[0]);
    const int null = open("/dev/null", O_WRONLY);
    dup2(null, 1);
    dup2(null, 2);
    execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp", "-noreset",
           nullptr);
    _exit(127);
  }
  close(ends[1]);
  std::string number;  // the server writes it when it is ready
  for (char c; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
  close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb did not start; is it installed?");
  setenv("DISPLAY", (":" + number).c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  for (const char* kind :
       {"config", "state"}) {  // not the cache: the driver's kernels would be compiled again for every window
    std::string variable = std::string("XDG_") + kind + "_HOME";
    for (char& c : variable) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    setenv(variable.c_str(), (home_ / kind).c_str(), 1);
  }
  UserSettings settings_of_an_old_grab;
  settings_of_an_old_grab.first_run_done = true;
  settings_of_an_old_grab.hints_done = {"grab", "orbit", "tune", "help"};
  write_user_settings(settings(), settings_of_an_old_grab);
  // A named display may not respond yet on a busy machine.
  if (!eventually([] { return run_command({"xdotool", "getdisplaygeometry"}).exit_code == 0; }))
    throw std::runtime_error("Xvfb does not answer");
}

std::vector<Image> VirtualDisplay::watch(int frames) const {
  const TemporaryFolder folder;
  const CommandResult grabbed =
      run_command({"ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "x11grab", "-draw_mouse", "0", "-framerate", "10",
                   "-video_size", size_, "-i", std::getenv("DISPLAY"), "-frames:v", std::to_string(frames),
                   (folder / "%03d.png").string()});
  if (grabbed.exit_code != 0) throw std::runtime_error("ffmpeg: " + grabbed.err);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Image> images;
  for (const std::filesystem::path& file : files) images.push_back(read_png(file));
  return images;
}

VirtualDisplay::~VirtualDisplay() {
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
  unsetenv("DISPLAY");
  for (const char* variable : {"XDG_CONFIG_HOME", "XDG_STATE_HOME"}) unsetenv(variable);
}

FasciaWindow::FasciaWindow(std::vector<std::string> arguments, fs::path folder)
    : folder_(std::move(folder)), log_(folder_ / "window.log") {
  arguments.insert(arguments.begin(), {FASCIA_BINARY, "view"});
  child_ = start(arguments, folder_, log_);
  const bool found = eventually([&] {
    if (!running()) return true;
    const CommandResult search = run_command({"xdotool", "search", "--onlyvisible", "--class", "fascia"});
    window_ = search.out.substr(0, search.out.find('\n'));
    return !window_.empty();
  });
  if (!found || !running()) throw std::runtime_error("no window: " + said());
  // Without a window manager only this call gives it the focus.
  eventually([&] { return run_command({"xdotool", "windowfocus", "--sync", window_}).exit_code == 0; });
}

FasciaWindow::~FasciaWindow() {
  if (!running()) return;
  go_on();
  ::kill(child_, SIGTERM);
  const auto end = Clock::now() + std::chrono::seconds(20);
  while (running() && Clock::now() < end) std::this_thread::sleep_for(kPoll);
  if (running()) {
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
}

bool FasciaWindow::running() {
  if (child_ < 0) return false;
  int status = 0;
  if (waitpid(child_, &status, WNOHANG) != child_) return true;
  child_ = -1;
  exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return false;
}

void FasciaWindow::hold() { ::kill(child_, SIGSTOP); }
void FasciaWindow::go_on() { ::kill(child_, SIGCONT); }

void FasciaWindow::kill_at_once() {
  ::kill(child_, SIGKILL);
  eventually([&] { return !running(); });
}

double FasciaWindow::processor_seconds() const {
  std::ifstream in("/proc/" + std::to_string(child_) + "/stat");
  std::string line;
  std::getline(in, line);
  std::istringstream fields(line.substr(line.rfind(')') + 2));  // the name before may contain anything
  std::string field;
  for (int i = 3; i < 14; ++i) fields >> field;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

int FasciaWindow::wait() {
  eventually([&] { return !running(); });
  return exit_code_;
}

std::string FasciaWindow::said() const {
  std::ifstream in(log_);
  return {std::istreambuf_iterator<char>(in), {}};
}

void FasciaWindow::key(const std::string& name) { xdotool({"key", name}); }
void FasciaWindow::keys_at_once(std::vector<std::string> names) {
  names.insert(names.begin(), {"key", "--delay", "1"});
  xdotool(std::move(names));
}
void FasciaWindow::type(const std::string& text) { xdotool({"type", "--delay", "30", "--", text}); }
void FasciaWindow::pause() { std::this_thread::sleep_for(std::chrono::milliseconds(700)); }
void FasciaWindow::press() { xdotool({"mousedown", "1"}); }
void FasciaWindow::key_down(const std::string& name) { xdotool({"keydown", name}); }
void FasciaWindow::key_up(const std::string& name) { xdotool({"keyup", name}); }
void FasciaWindow::click(int button) { xdotool({"click", std::to_string(button)}); }
void FasciaWindow::resize(int width, int height) {
  xdotool({"windowsize", window_, std::to_string(width), std::to_string(height)});
}
void FasciaWindow::release() { xdotool({"mouseup", "1"}); }

void FasciaWindow::move(int x, int y) {
  constexpr int kSteps = 12;
  const int from_x = x_, from_y = y_;
  for (int i = 1; i <= kSteps; ++i) {
    x_ = from_x + (x - from_x) * i / kSteps;
    y_ = from_y + (y - from_y) * i / kSteps;
    xdotool({"mousemove", "--window", window_, std::to_string(x_), std::to_string(y_)});
  }
}

Screenshot FasciaWindow::screenshot() {
  const std::set<fs::path> before = pictures(folder_);
  std::set<fs::path> after;
  Clock::time_point asked{};
  const bool taken = eventually([&] {
    // A dialog that opened late swallows the key: Escape closes it, and the key is sent again.
    if (Clock::now() - asked > std::chrono::seconds(15)) {
      if (asked != Clock::time_point{}) key("Escape");
      key("p");
      asked = Clock::now();
    }
    after = pictures(folder_);  // written under another name first, so files found here are complete
    return after.size() > before.size() || !running();
  });
  if (!taken || after.size() <= before.size()) throw std::runtime_error("no screenshot: " + said());
  fs::path file;
  for (const fs::path& path : after)
    if (!before.count(path)) file = path;
  Screenshot shot;
  shot.image = read_png(file);
  for (const auto& [keyword, text] : read_png_metadata(file)) {
    if (keyword == "Title") shot.title = text;
    if (keyword == "Moment") shot.moment = text;
    if (keyword != "Parameters") continue;
    const auto scene = nlohmann::json::parse(text);
    shot.young_modulus = scene.at("bodies").at(0).at("materials").at("default").at("young_modulus").get<double>();
    shot.wireframe = scene.value("/display/wireframe"_json_pointer, false);
    shot.section = scene.value("/display/section/offset"_json_pointer, 0.0);
  }
  return shot;
}

std::string cube_scene(const std::string& title, double young_modulus) {
  return nlohmann::json{{"fascia_scene", 1},
                        {"title", title},
                        {"gravity", {0, 0, 0}},
                        {"bodies",
                         {{{"name", "cube"},
                           {"mesh", (source_dir() / "assets/meshes/cube.msh").string()},
                           {"materials", {{"default", {{"young_modulus", young_modulus}, {"damping", 0.1}}}}},
                           {"fixed", {{{"lowest", 0.02}}}}}}}}
      .dump(2);
}

Image right_part(const Image& image, int left) {
  Image part{image.width - left, image.height, {}};
  for (int y = 0; y < image.height; ++y) {
    const auto row = image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * image.width);
    part.rgba.insert(part.rgba.end(), row + 4 * left, row + 4 * image.width);
  }
  return part;
}

double changed_beside_panels(const Screenshot& from, const Screenshot& to) {
  return difference(right_part(from.image, kPanels), right_part(to.image, kPanels)).share;
}

}  // namespace fascia::test
