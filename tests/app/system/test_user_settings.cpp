// The window's stored settings: read and written exactly, and never an obstacle to starting.
#include <catch2/catch.hpp>

#include "app/system/user_settings.h"
#include "base/error.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

TEST_CASE("user settings survive a round trip, and a missing file means a new user") {
  const TemporaryFolder folder;
  CHECK(read_user_settings(folder / "none.json") == UserSettings());
  UserSettings settings;
  settings.recent = {"/a/b c.json", "/d/\xc3\xa9.msh"};
  settings.folder = "/a";
  settings.hints_done = {"grab"};
  settings.first_run_done = settings.light = true;
  settings.scale = 1.25;
  write_user_settings(folder / "deep/settings.json", settings);
  CHECK(read_user_settings(folder / "deep/settings.json") == settings);
}

TEST_CASE("recent files: the latest first, each once, limited in number") {
  UserSettings settings;
  for (int i = 0; i < 20; ++i) settings.opened("/meshes/" + std::to_string(i) + ".msh");
  REQUIRE(settings.recent.size() == UserSettings::kMostRecent);
  CHECK(settings.recent.front() == "/meshes/19.msh");
  settings.opened("/meshes/x/../15.msh");
  CHECK(settings.recent.size() == UserSettings::kMostRecent);
  CHECK(settings.recent.front() == "/meshes/15.msh");
  CHECK(std::count(settings.recent.begin(), settings.recent.end(), "/meshes/15.msh") == 1);
  settings.opened("here.json");
  CHECK(settings.recent.front() == std::filesystem::current_path() / "here.json");
}

TEST_CASE("broken settings are reported, kept aside and replaced") {
  const TemporaryFolder folder;
  const std::string broken =
      GENERATE(as<std::string>(), "{", "[]", "{\"fascia_settings\": 2}", "{\"fascia_settings\": 1, \"recent\": 3}",
               "{\"fascia_settings\": 1, \"recent\": [3]}", "{\"fascia_settings\": 1, \"colour\": \"red\"}",
               "{\"fascia_settings\": 1, \"welcomed\": \"yes\"}", "{\"fascia_settings\": 1, \"folder\": []}",
               "{\"fascia_settings\": 1, \"theme\": \"red\"}", "{\"fascia_settings\": 1, \"scale\": 9}",
               "{\"fascia_settings\": 1, \"scale\": \"large\"}", "\xff\xfe");
  CAPTURE(broken);
  write_file(folder / "settings.json", broken);
  CHECK_THROWS_AS(read_user_settings(folder / "settings.json"), Error);
  UserStore store(folder.path());
  CHECK_THAT(store.warning(), Catch::Contains("settings.json") && Catch::Contains("expected"));
  CHECK(store.now() == UserSettings());
  store.change([](UserSettings& settings) { settings.opened("/a.msh"); });
  CHECK(read_file(folder / "settings.json.broken") == broken);
  CHECK(read_user_settings(folder / "settings.json").recent.size() == 1);
}

TEST_CASE("two windows do not lose each other's recent files") {
  const TemporaryFolder folder;
  UserStore one(folder.path()), two(folder.path());
  one.change([](UserSettings& settings) { settings.opened("/one.msh"); });
  two.change([](UserSettings& settings) { settings.opened("/two.msh"); });
  CHECK(read_user_settings(folder / "settings.json").recent ==
        std::vector<std::filesystem::path>{"/two.msh", "/one.msh"});
}

TEST_CASE("settings that cannot be written are reported once and do no harm") {
  const TemporaryFolder folder;
  write_file(folder / "file", "no folder");
  UserStore store(folder / "file");
  store.change([](UserSettings& settings) { settings.opened("/a.msh"); });
  CHECK_FALSE(store.warning().empty());
  CHECK(store.now().recent.size() == 1);
  UserStore nowhere((std::filesystem::path()));
  nowhere.change([](UserSettings& settings) { settings.first_run_done = true; });
  CHECK(nowhere.now().first_run_done);
  CHECK(nowhere.warning().empty());
}
