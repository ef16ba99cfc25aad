#include "app/session/file_provenance.h"

#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/session/reproduce.h"
#include "base/error.h"
#include "base/file.h"
#include "render/target/image.h"
#include "sim/replay/replay.h"
#include "sim/replay/replay_time.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

// Containers change the capitals of keywords and add spaces; fascia's begin with a capital.
std::string keyword_of(std::string text) {
  for (char& c : text) c = c == '_' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Provenance of_video(const fs::path& path) {
  if (std::ifstream in(path); in.peek() == std::ifstream::traits_type::eof()) read_file(path);  // throws its errors
  const std::string command = "ffprobe -v error -show_entries format_tags -of json " +
                              shell_quoted(fs::absolute(path).string()) + " 2>/dev/null";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  char block[4096];
  for (std::size_t n; pipe && (n = std::fread(block, 1, sizeof block, pipe)) > 0;) text.append(block, n);
  constexpr int kNoSuchCommand = 127;
  if (const int status = pipe ? pclose(pipe) : -1;
      status == -1 || (WIFEXITED(status) && WEXITSTATUS(status) == kNoSuchCommand))
    throw Error(path.string(), "cannot be examined: ffprobe did not start", "expected ffmpeg to be installed");
  const Json document = Json::parse(text, nullptr, false);
  Provenance provenance;
  bool ours = false;
  if (!document.is_object() || !document.contains("format") || !document["format"].contains("tags")) return {};
  for (const auto& [keyword, value] : document["format"]["tags"].items()) {
    if (!value.is_string()) continue;
    const std::string name = keyword_of(keyword), said = value.get<std::string>();
    ours |= name == "Software" && said.starts_with("fascia");
    if (name != "Major brand" && name != "Minor version" && name != "Compatible brands" && name != "Encoder")
      provenance.emplace_back(name, said);
  }
  return ours ? provenance : Provenance{};
}

Provenance of_json(const std::string& text) {
  const Json document = Json::parse(text, nullptr, false);
  Provenance provenance;
  if (!document.is_object() || !document.contains("provenance") || !document["provenance"].is_object()) return {};
  for (const auto& [keyword, value] : document["provenance"].items())
    if (value.is_string()) provenance.emplace_back(keyword, value.get<std::string>());
  return provenance;
}

Provenance of_replay(const fs::path& path) {
  const Replay replay = read_replay(path);
  Provenance provenance = replay.made_by;
  provenance.emplace_back("Title", replay.scene.title);
  char text[160];
  std::snprintf(text, sizeof text, "%ld steps, %.9g s, %zu inputs", replay.steps,
                ReplayTime(replay).seconds(replay.steps), replay.inputs.size());
  provenance.emplace_back("Replay", text);
  std::string carried;
  for (const KnownFile& file : replay.scene.files)
    if (file.deflated) carried += (carried.empty() ? "" : ", ") + file.path;
  if (!carried.empty()) provenance.emplace_back("Carries", carried);
  if (replay.hash) provenance.emplace_back("State", hash_text(*replay.hash));
  if (!replay.note.empty()) provenance.emplace_back("Note", replay.note);
  return provenance;
}

}  // namespace

std::optional<Provenance> provenance_of_file(const fs::path& path) {
  const std::string ending = lower_ending(path);
  Provenance provenance;
  if (ending == ".fascia") {
    provenance = of_replay(path);
  } else if (ending == ".png") {
    provenance = read_png_metadata(path);
  } else if (ending == ".mp4" || ending == ".webm" || ending == ".mkv" || ending == ".mov") {
    provenance = of_video(path);
  } else if (ending == ".json") {
    provenance = of_json(read_file(path));
  } else if (ending == ".csv") {
    std::error_code ec;
    read_file(path);
    if (fs::exists(provenance_beside(path), ec)) provenance = of_json(read_file(provenance_beside(path)));
  } else if (ending == ".vtu" || ending == ".msh" || ending == ".obj" || ending == ".inp") {
    provenance = find_provenance(read_file(path));
  }
  if (provenance.empty()) return std::nullopt;
  return provenance;
}

}  // namespace fascia
