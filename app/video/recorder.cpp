#include "app/video/recorder.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "base/error.h"
#include "base/file.h"

extern char** environ;

namespace fascia {
namespace fs = std::filesystem;
namespace {

// ffmpeg's last line of output, for the error message.
std::string last_words(const fs::path& log) {
  std::string text;
  try {
    text = read_file(log);
  } catch (const Error&) {
    return "no message";
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::size_t start = text.find_last_of("\r\n");
  text = start == std::string::npos ? text : text.substr(start + 1);
  return text.empty() ? "no message" : text;
}

// As ffmpeg reads it from a file, since a scene can be longer than a command line.
std::string metadata_text(const Provenance& provenance) {
  const auto escaped = [](const std::string& text) {
    std::string result;
    for (const char c : text) {
      if (std::strchr("=;#\\\n", c)) result += '\\';
      result += c;
    }
    return result;
  };
  std::string text = ";FFMETADATA1\n";
  for (const auto& [key, value] : provenance)
    text += escaped(key == "Title" ? "title" : key) + "=" + escaped(value) + "\n";
  return text;
}

// Options of the encoder, by the container.
std::vector<std::string> encoder(const std::string& ending, bool live) {
  if (ending == ".mp4" || ending == ".mkv" || ending == ".mov")
    return {"-c:v", "libx264", "-preset",   live ? "ultrafast" : "veryfast",
            "-crf", "18",      "-movflags", "+faststart+use_metadata_tags"};
  if (ending == ".webm")
    return {"-c:v",      "libvpx-vp9",    "-crf", "28",        "-b:v",
            "0",         "-row-mt",       "1",    "-deadline", live ? "realtime" : "good",
            "-cpu-used", live ? "8" : "4"};
  return {};
}

}  // namespace

Recorder::Recorder(fs::path path, const FrameFormat& format, const Provenance& provenance)
    : path_(std::move(path)),
      temporary_(temporary_name(path_)),
      frame_bytes_(std::size_t{4} * format.width * format.height) {
  const int width = format.width, height = format.height;
  log_ = temporary_;
  log_ += ".log";
  metadata_ = temporary_;
  metadata_ += ".txt";
  require_writable(path_);
  if (width % 2 || height % 2)
    throw Error(path_.string(), "a video of " + std::to_string(width) + "x" + std::to_string(height),
                "expected an even width and height");

  try {
    write_file(metadata_, metadata_text(provenance));
  } catch (const Error&) {  // the file is not one that the user named
    throw Error(path_.string(), "cannot be written", "expected a writable folder with free space");
  }
  std::vector<std::string> arguments{"ffmpeg",
                                     "-hide_banner",
                                     "-loglevel",
                                     "error",
                                     "-y",
                                     "-f",
                                     "rawvideo",
                                     "-pix_fmt",
                                     "rgba",
                                     "-s",
                                     std::to_string(width) + "x" + std::to_string(height),
                                     "-r",
                                     std::to_string(format.fps),
                                     "-i",
                                     "-",
                                     "-f",
                                     "ffmetadata",
                                     "-i",
                                     "file:" + metadata_.string(),
                                     "-map",
                                     "0:v",
                                     "-map_metadata",
                                     "1",
                                     "-pix_fmt",
                                     "yuv420p"};
  for (std::string& argument : encoder(lower_ending(path_), format.live)) arguments.push_back(std::move(argument));
  arguments.push_back("file:" + temporary_.string());  // otherwise a name may look like a URL
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail(std::string("no pipe to ffmpeg: ") + std::strerror(errno));
  fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);  // a frame in a few writes instead of hundreds; optional
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // A separate process group: Ctrl-C in the terminal must reach only fascia, so that the file can be completed.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int spawned = posix_spawnp(&child_, "ffmpeg", &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  pipe_ = ends[1];
  if (spawned != 0) {
    child_ = -1;
    fail(std::string("ffmpeg cannot be started: ") + std::strerror(spawned));
  }
}

Recorder::~Recorder() {
  if (pipe_ >= 0) close(pipe_);
  wait_for_child();
  remove_files();
}

void Recorder::remove_files() {
  std::error_code ec;
  for (const fs::path& file : {temporary_, log_, metadata_}) fs::remove(file, ec);
}

void Recorder::write(const std::vector<std::uint8_t>& rgba) {
  if (rgba.size() != frame_bytes_)
    throw Error(path_.string(), "a frame has a different size", "expected the size it was opened with");
  std::size_t written = 0;
  while (written < rgba.size()) {
    const ssize_t n = ::write(pipe_, rgba.data() + written, rgba.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("ffmpeg stopped after " + std::to_string(frames_) + " frames");
    written += static_cast<std::size_t>(n);
  }
  ++frames_;
}

int Recorder::wait_for_child() {
  if (child_ < 0) return 0;
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void Recorder::finish() {
  close(pipe_);
  pipe_ = -1;
  if (const int status = wait_for_child(); status != 0) fail("ffmpeg ended with status " + std::to_string(status));
  replace_file(temporary_, path_);
}

void Recorder::fail(const std::string& what) {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  wait_for_child();
  const std::string said = last_words(log_);
  remove_files();
  throw Error(path_.string(), what + " (" + said + ")", "expected a working ffmpeg and free disk space");
}

}  // namespace fascia
