// The self-description of the command line: help, nearest words, manual page, completion. All of it comes from the
// options' own tables.
// Covers: command_tree, completion_bash, completion_fish, completion_zsh, manual_page, scene_keys
// Covers: app/commands/command, app/commands/completion
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/cli/command_line.h"
#include "app/cli/completion.h"
#include "app/cli/manual_page.h"
#include "app/cli/scene_keys.h"
#include "app/commands/command.h"
#include "base/file.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;

namespace {

CommandEntry program() {
  Invocation invocation;
  return describe(*make_command_line(invocation));
}

// The completions that bash offers for the words of a line, sorted.
std::vector<std::string> offered(const std::string& script, const std::vector<std::string>& words,
                                 const std::filesystem::path& folder) {
  std::string line =
      "source \"$0\"; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); _fascia; printf '%s\\n' \"${COMPREPLY[@]}\" | sort";
  std::vector<std::string> arguments{"bash", "-c", line, script};
  arguments.insert(arguments.end(), words.begin(), words.end());
  const CommandResult result = run_command(arguments, folder);
  CHECK(result.err == "");
  std::vector<std::string> lines;
  std::string rest = result.out;
  for (std::size_t end; (end = rest.find('\n')) != std::string::npos; rest.erase(0, end + 1))
    if (end > 0) lines.push_back(rest.substr(0, end));
  return lines;
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("every command has help with examples and exit codes", "[command_line]") {
  const CommandEntry tree = program();
  for (const CommandEntry* command : all_commands(tree)) {
    if (!command->commands.empty() && !command->path.empty()) continue;
    CAPTURE(command->path);
    CHECK(contains(command->examples, "  fascia "));
    CHECK(contains(command->examples, "Exit codes: 0 done, 1 "));
    CHECK(!command->help.empty());
    for (const OptionEntry& option : command->options) {
      CAPTURE(option.name);
      CHECK(option.name.starts_with("--"));
      CHECK(!option.help.empty());
    }
  }
}

TEST_CASE("unknown words suggest the nearest known one, and wrong values say what is expected", "[command_line]") {
  const struct {
    Words arguments;
    std::string said;
  } cases[] = {{{"render", "--contxt", "egl"}, "perhaps you meant --context"},
               {{"run", "--stpes=4"}, "perhaps you meant --steps"},
               {{"bench", "spede", "--out", "x"}, "perhaps you meant speed"},
               {{"rendr"}, "perhaps you meant render"},
               {{"chekc", "assets/check"}, "perhaps you meant check"},
               {{"run", "--zzzzzzzz"}, "--zzzzzzzz: not expected here"},
               {{"run", "x", "--steps", "1.5"}, "--steps: is 1.5; expected a whole number"},
               {{"run", "x", "--time", "1s"}, "--time: is 1s; expected a number"}};
  for (const auto& [arguments, said] : cases) {
    const CommandResult result = run_fascia(arguments);
    CAPTURE(arguments, result.err, said);
    CHECK(result.exit_code == 2);
    CHECK(contains(result.err, said));
    CHECK(contains(result.err, "--help"));
  }
}

TEST_CASE("the manual page has every command and option and is valid roff", "[command_line]") {
  const TemporaryFolder folder;
  const CommandEntry tree = program();
  const std::string page = manual_page(tree);
  write_file(folder / "fascia.1", page);
  for (const CommandEntry* command : all_commands(tree))
    for (const OptionEntry& option : command->options) {
      std::string name;
      for (const char c : option.name) name += c == '-' ? "\\-" : std::string(1, c);
      CAPTURE(option.name);
      CHECK(contains(page, "\\fB" + name + "\\fR"));
    }
  for (std::size_t line = 0; line != std::string::npos && line < page.size(); line = page.find("\n", line) + 1) {
    if (page[line] == '.')
      CHECK(std::isupper(static_cast<unsigned char>(page[line + 1])) +
            std::islower(static_cast<unsigned char>(page[line + 1])));
    if (page.find("\n", line) == std::string::npos) break;
  }
  CHECK(run_fascia({"man"}).out == page);
}

TEST_CASE("help and manual refer to the manual and to the keys of scenes", "[command_line]") {
  const std::string help = run_fascia({"--help"}).out, page = run_fascia({"man"}).out,
                    read_me = read_file(source_dir() / "README.md"),
                    guide = read_file(source_dir() / "docs/guide/command-line.md");
  CAPTURE(help, page);
  for (const std::string& text : {help, page, read_me}) CHECK(contains(text, "docs/guide/scenes.md"));
  CHECK(contains(read_file(source_dir() / "docs/guide/scenes.md"), "young_modulus"));
  CHECK(contains(help, "fascia man | man -l -"));
  CHECK(contains(page, "fascia man | man \\-l \\-"));
  CHECK(contains(guide, "fascia man | man -l -"));
  CHECK(!contains(page, "README.md lists"));
  CHECK(contains(help, "\n  man "));  // among the commands
  // The installed README's links lead to the installed pages.
  CHECK(contains(read_file(source_dir() / "CMakeLists.txt"),
                 "install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})"));
}

TEST_CASE("animated GIF is a documented video", "[command_line]") {
  const std::string help = run_fascia({"render", "--help"}).out, page = run_fascia({"man"}).out;
  CAPTURE(help, page);
  CHECK(contains(help, ".gif"));
  CHECK(contains(page, ".gif"));
  CHECK(contains(read_file(source_dir() / "docs/guide/command-line.md"), ".gif"));
}

TEST_CASE("the help of view explains --steps and --time for a window", "[command_line]") {
  const CommandEntry tree = program();
  for (const CommandEntry* command : all_commands(tree)) {
    if (!command->path.empty() && command->path != Words{"view"}) continue;
    for (const char* name : {"--steps", "--time"}) {
      const auto option = std::find_if(command->options.begin(), command->options.end(),
                                       [&](const OptionEntry& o) { return o.name == name; });
      REQUIRE(option != command->options.end());
      CAPTURE(command->path, name, option->help);
      CHECK(contains(option->help, "the window closes"));
    }
    CHECK(!contains(command->positionals.at(0).help, "standard input"));  // which it does not accept
  }
}

TEST_CASE("keys of --set are those of scenes", "[command_line]") {
  Words names;
  for (const SceneKey& key : scene_keys()) names.push_back(key.name);
  for (const char* name : {"solver.iterations", "solver.method", "materials.default.young_modulus", "gravity",
                           "display.color", "camera.eye"})
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  CHECK(std::count(names.begin(), names.end(), "fascia_scene") == 0);
}

TEST_CASE("bash completes commands, options, choices, scene keys and files", "[command_line]") {
  const TemporaryFolder folder;
  const std::string script = folder / "completion.bash";
  write_file(script, run_fascia({"completion", "bash"}).out);
  write_file(folder / "picture.png", "");
  write_file(folder / "scene.json", "");
  CHECK(offered(script, {"fascia", "ren"}, folder.path()) == Words{"render"});
  CHECK(offered(script, {"fascia", "bench", "s"}, folder.path()) == Words{"skip", "speed", "static"});
  CHECK(offered(script, {"fascia", "render", "--context", "e"}, folder.path()) == Words{"egl"});
  CHECK(offered(script, {"fascia", "render", "--context", "=", "os"}, folder.path()) == Words{"osmesa"});
  CHECK(offered(script, {"fascia", "render", "--comp"}, folder.path()) == Words{"--compare"});
  CHECK(offered(script, {"fascia", "run", "--set", "solver.me"}, folder.path()) == Words{"solver.method="});
  CHECK(offered(script, {"fascia", "run", "--set", "solver.method", "=", "tw"}, folder.path()) == Words{"two_level"});
  CHECK(offered(script, {"fascia", "render", "--out", ""}, folder.path()) == Words{"picture.png"});
  CHECK(offered(script, {"fascia", "render", "sce"}, folder.path()) == Words{"scene.json"});
}

TEST_CASE("completion of other shells has the same options", "[command_line]") {
  const CommandEntry tree = program();
  const std::string zsh = zsh_completion(tree), fish = fish_completion(tree);
  for (const CommandEntry* command : all_commands(tree))
    for (const OptionEntry& option : command->options) {
      CAPTURE(option.name);
      CHECK(contains(zsh, option.name + "["));
      CHECK(contains(fish, " -l " + option.name.substr(2) + " "));
    }
  CHECK(run_fascia({"completion", "tcsh"}).exit_code == 2);
}
