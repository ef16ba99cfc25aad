#include "app/system/user_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const fs::path& file, const std::string& key, const char* expected) {
  throw Error(file.string() + ": " + key, "has the wrong type or value", std::string("expected ") + expected);
}

std::vector<std::string> texts(const fs::path& file, const std::string& key, const Json& value) {
  if (!value.is_array()) fail(file, key, "a list of texts");
  std::vector<std::string> list;
  for (const Json& item : value) {
    if (!item.is_string()) fail(file, key, "a list of texts");
    list.push_back(item.get<std::string>());
  }
  return list;
}

}  // namespace

void UserSettings::opened(const fs::path& file) {
  std::error_code ec;
  const fs::path whole = fs::absolute(file, ec).lexically_normal();
  recent.erase(std::remove(recent.begin(), recent.end(), whole), recent.end());
  recent.insert(recent.begin(), whole);
  if (recent.size() > kMostRecent) recent.resize(kMostRecent);
}

UserSettings read_user_settings(const fs::path& file) {
  std::error_code ec;
  if (!fs::exists(file, ec)) return {};
  Json json;
  try {
    json = Json::parse(read_file(file));
  } catch (const nlohmann::json::exception& error) {
    throw Error(file.string(), "is not JSON", "expected the settings that fascia wrote");
  }
  if (!json.is_object() || json.value("fascia_settings", Json()) != Json(1)) fail(file, "fascia_settings", "1");
  UserSettings settings;
  for (const auto& [key, value] : json.items()) {
    if (key == "fascia_settings") continue;
    if (key == "recent") {
      for (const std::string& path : texts(file, key, value))
        if (settings.recent.size() < UserSettings::kMostRecent) settings.recent.emplace_back(path);
    } else if (key == "folder") {
      if (!value.is_string()) fail(file, key, "a path");
      settings.folder = value.get<std::string>();
    } else if (key == "hints_done") {
      for (const std::string& hint : texts(file, key, value)) settings.hints_done.insert(hint);
    } else if (key == "welcomed") {
      if (!value.is_boolean()) fail(file, key, "true or false");
      settings.first_run_done = value.get<bool>();
    } else if (key == "theme") {
      if (value != "dark" && value != "light") fail(file, key, "dark or light");
      settings.light = value == "light";
    } else if (key == "scale") {
      if (!value.is_number() || value < UserSettings::kLeastScale || value > UserSettings::kLargestScale)
        fail(file, key, "a number from 0.6 to 2.5");
      settings.scale = value.get<double>();
    } else {
      throw Error(file.string() + ": " + key, "is unknown",
                  "expected recent, folder, hints_done, welcomed, theme or scale");
    }
  }
  return settings;
}

void write_user_settings(const fs::path& file, const UserSettings& settings) {
  Json recent = Json::array();
  for (const fs::path& path : settings.recent) recent.push_back(path.string());
  const Json json{{"fascia_settings", 1},
                  {"recent", recent},
                  {"folder", settings.folder.string()},
                  {"hints_done", settings.hints_done},
                  {"welcomed", settings.first_run_done},
                  {"theme", settings.light ? "light" : "dark"},
                  {"scale", settings.scale}};
  fs::create_directories(file.parent_path());
  write_file(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");  // paths may contain any bytes
}

UserStore::UserStore(const fs::path& folder) : file_(folder.empty() ? fs::path() : folder / "settings.json") { read(); }

void UserStore::read() {
  if (file_.empty()) return;
  try {
    settings_ = read_user_settings(file_);
    broken_ = false;
  } catch (const std::exception& error) {
    broken_ = true;
    warning_ = error.what();
  }
}

void UserStore::change(const std::function<void(UserSettings&)>& change) {
  read();
  const UserSettings before = settings_;
  change(settings_);
  if (file_.empty() || (settings_ == before && !broken_)) return;
  try {
    if (broken_) fs::rename(file_, fs::path(file_) += ".broken");
    broken_ = false;
    write_user_settings(file_, settings_);
  } catch (const std::exception& error) {
    warning_ = error.what();
    file_.clear();  // reported once, not at every change
  }
}

}  // namespace fascia
