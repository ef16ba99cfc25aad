#include "app/fit/fit_progress.h"

#include <nlohmann/json.hpp>

#include "base/byte_hash.h"
#include "base/error.h"
#include "base/file.h"
#include "sim/scene/scene_write.h"

namespace fascia {
namespace {

std::string hash_of(const std::string& text) {
  ByteHash hash;
  hash.add({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  return hash_text(hash.value());
}

}  // namespace

FitIdentity identity_of(const Scene& scene, const std::vector<Measurement>& measurements, const std::string& options) {
  std::string measured;
  for (const Measurement& measurement : measurements) measured += read_file(measurement.file) + '\n';
  return {hash_of(scene_to_json(scene, scene.file.parent_path())), hash_of(measured), hash_of(options)};
}

FitProgressFile::FitProgressFile(const std::filesystem::path& folder, FitIdentity identity)
    : file_(folder / "progress.json"), identity_(std::move(identity)) {}

std::optional<FitProgress> FitProgressFile::read(std::size_t parameters) const {
  if (!std::filesystem::exists(file_)) return std::nullopt;
  const Error no_record(file_.string(), "is no record of a fit", "remove it to begin anew");
  try {
    const auto document = nlohmann::json::parse(read_file(file_));
    const auto require = [&](const char* name, const std::string& own, const char* what) {
      if (document.at(name) == own) return;
      throw Error(file_.string(), std::string("is of an interrupted fit with ") + what,
                  "expected the same command; remove the file or choose another --out to begin anew");
    };
    require("scene", identity_.scene, "another scene");
    require("measurement", identity_.measurement, "another measurement");
    require("options", identity_.options, "other options");
    FitProgress progress;
    progress.inner = document.at("inner").get<std::vector<double>>();
    progress.simulations = document.at("simulations");
    progress.start_misfit = document.at("start_misfit");
    if (progress.inner.size() != parameters) throw no_record;
    return progress;
  } catch (const nlohmann::json::exception&) {
    throw no_record;
  }
}

void FitProgressFile::write(const FitProgress& progress) const {
  const nlohmann::ordered_json document = {
      {"scene", identity_.scene}, {"measurement", identity_.measurement}, {"options", identity_.options},
      {"inner", progress.inner},  {"simulations", progress.simulations},  {"start_misfit", progress.start_misfit}};
  write_file(file_, document.dump(2) + "\n");
}

void FitProgressFile::remove() const {
  std::error_code none;
  std::filesystem::remove(file_, none);
}

}  // namespace fascia
