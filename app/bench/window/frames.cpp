#include "app/bench/window/frames.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/csv/csv_line.h"
#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace {

constexpr double kAfterGrab = 1;  // [s] not counted: the first grab may compile kernels

bool is_part(const std::string& column) { return column.ends_with("_ms") && column != "elapsed_ms"; }

// The puts are in the order of time and differ from one to the next; a frame may have skipped some.
std::vector<double> latencies(const WindowSession& session, double from, double to) {
  std::vector<double> milliseconds;
  std::size_t next = 0;
  for (const LoggedFrame& frame : session.frames) {
    for (std::size_t k = next; k < session.puts.size() && session.puts[k].at < frame.ended; ++k) {
      const PointerPut& put = session.puts[k];
      if (std::hypot(put.x - frame.x, put.y - frame.y) > 1) continue;
      for (; next <= k; ++next)
        if (session.puts[next].at >= from && session.puts[next].at < to)
          milliseconds.push_back(1000 * (frame.ended - session.puts[next].at));
      break;
    }
  }
  return milliseconds;
}

}  // namespace

std::vector<LoggedFrame> read_frame_log(const std::filesystem::path& path) {
  std::istringstream in(read_file(path));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string_view> names = csv_cells(line);
  const std::vector<std::string> columns(names.begin(), names.end());
  for (const char* needed : {"ended_s", "elapsed_ms", "steps", "simulated_s", "fused", "pointer_x", "pointer_y"})
    if (std::find(columns.begin(), columns.end(), needed) == columns.end())
      throw Error(path.string(), std::string("has no column ") + needed, "expected a file of --frame-log");
  std::vector<LoggedFrame> frames;
  while (std::getline(in, line)) {
    const std::vector<std::string_view> cells = csv_cells(line);
    if (cells.size() != columns.size())
      throw Error(path.string(), "line " + std::to_string(frames.size() + 2), "expected a value for every column");
    LoggedFrame frame;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const double value = std::stod(std::string(cells[c]));
      const std::string& name = columns[c];
      if (name == "ended_s") frame.ended = value;
      if (name == "elapsed_ms") frame.elapsed_ms = value;
      if (name == "steps") frame.steps = static_cast<int>(value);
      if (name == "simulated_s") frame.simulated_s = value;
      if (name == "fused") frame.fused = value != 0;
      if (name == "pointer_x") frame.x = value;
      if (name == "pointer_y") frame.y = value;
      if (is_part(name)) frame.parts_ms[name] = value;
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

WindowFigures figures_of(const WindowSession& session) {
  WindowFigures figures;
  const double from = session.pressed + kAfterGrab, to = session.released;
  std::vector<double> frame_ms;
  std::map<std::string, std::vector<double>> parts;
  double simulated = 0, steps_ms = 0, first = 0, last = 0, fused = -1;
  int steps = 0, pictures = 0;
  for (std::size_t i = 0; i < session.frames.size(); ++i) {
    const LoggedFrame& frame = session.frames[i];
    const double took = i > 0 ? 1000 * (frame.ended - session.frames[i - 1].ended) : 0;
    (frame.ended < session.pressed ? figures.longest_before_ms : figures.longest_grabbed_ms) =
        std::max(frame.ended < session.pressed ? figures.longest_before_ms : figures.longest_grabbed_ms, took);
    if (frame.fused && fused < 0) fused = frame.ended;
    if (frame.ended < from || frame.ended > to) continue;
    if (pictures++ == 0) {
      first = frame.ended;
      continue;  // what it simulated belongs to the time before
    }
    last = frame.ended;
    frame_ms.push_back(took);
    for (const auto& [name, ms] : frame.parts_ms) parts[name].push_back(ms);
    simulated += frame.simulated_s;
    steps += frame.steps;
    steps_ms += frame.parts_ms.at("steps_ms");
  }
  if (frame_ms.empty())
    throw Error("the window", "drew less than two frames while the tissue was dragged", "expected a window that runs");
  const double real = last - first;
  figures.first_picture_s = session.frames.front().ended - session.started;
  figures.fused_s = fused < 0 ? -1 : fused - session.frames.front().ended;
  figures.share = simulated / real;
  figures.pictures_per_s = static_cast<double>(frame_ms.size()) / real;
  figures.frame_ms = spread_of(frame_ms);
  figures.latency_ms = spread_of(latencies(session, from, to));
  figures.steps_per_frame = steps / static_cast<double>(frame_ms.size());
  figures.step_ms = steps > 0 ? steps_ms / steps : 0;
  for (auto& [name, values] : parts) figures.parts_ms[name] = spread_of(std::move(values)).median;
  return figures;
}

}  // namespace fascia
