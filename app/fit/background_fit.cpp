#include "app/fit/background_fit.h"

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_write.h"

namespace fascia {

namespace fs = std::filesystem;

BackgroundFit::Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "fascia-fit-XXXXXX").string();
  if (!mkdtemp(name.data())) throw Error(name, "cannot be made", "expected a folder for temporary files");
  path = name;
}

BackgroundFit::Folder::~Folder() {
  std::error_code none;
  fs::remove_all(path, none);
}

BackgroundFit::BackgroundFit(const fs::path& program, const Scene& scene, const FitTask& task) {
  const fs::path file = folder_.path / "scene.json";
  write_file(file, scene_to_json(scene, folder_.path));
  std::string joined;
  for (const std::string& key : task.keys) joined += (joined.empty() ? "" : ",") + key;
  std::vector<std::string> command{program.string(),
                                   "fit",
                                   file.string(),
                                   "--measured",
                                   fs::absolute(task.measured).string(),
                                   "--free",
                                   joined,
                                   "--probe",
                                   std::to_string(task.probe),
                                   "--profile",
                                   "0",
                                   "--out",
                                   folder_.path.string()};
  if (task.equilibria) command.emplace_back("--static");
  program_.emplace(std::move(command), std::map<std::string, std::string>{}, folder_.path / "said");
}

BackgroundFit::~BackgroundFit() = default;

bool BackgroundFit::ended() { return program_->ended().has_value(); }

std::string BackgroundFit::last_line() const {
  std::error_code none;
  if (!fs::exists(folder_.path / "said", none)) return "";
  std::string text = read_file(folder_.path / "said");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  text.erase(0, text.rfind('\n') + 1);  // npos + 1 is 0
  constexpr std::string_view kName = "fascia: ";
  return text.starts_with(kName) ? text.substr(kName.size()) : text;
}

std::optional<std::vector<Estimate>> BackgroundFit::found() {
  if (!program_->ended() || !program_->ended()->succeeded) return std::nullopt;
  const auto document = nlohmann::json::parse(read_file(folder_.path / "fit.json"));
  std::vector<Estimate> found;
  for (const auto& parameter : document.at("parameters")) {
    Estimate& estimate = found.emplace_back();
    estimate.key = parameter.at("key");
    estimate.value = parameter.at("value");
    estimate.low = estimate.high = std::numeric_limits<double>::quiet_NaN();
    if (!parameter.contains("interval_95")) continue;
    estimate.low = parameter["interval_95"][0];
    estimate.high = parameter["interval_95"][1];
  }
  return found;
}

}  // namespace fascia
