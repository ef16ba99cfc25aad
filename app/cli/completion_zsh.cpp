#include "app/cli/completion.h"
#include "app/cli/scene_keys.h"

namespace fascia {
namespace {

using Takes = OptionEntry::Takes;

// Quotes for single quotes; square brackets and colons are special to _arguments.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string function_name(const CommandEntry& command) {
  std::string name = "_fascia";
  for (const std::string& word : command.path) name += "_" + word;
  return name;
}

std::string zsh_action(const OptionEntry& option) {
  switch (option.takes) {
    case Takes::choice:
      return "(" + spaced(option.choices) + ")";
    case Takes::file:
      return option.ending.empty() ? "_files" : "_files -g \"*" + option.ending + "\"";
    case Takes::folder:
      return "_files -/";
    case Takes::scene_value:
      return "_fascia_keys";
    case Takes::anything:
    case Takes::nothing:
      break;
  }
  return " ";
}

std::string option_line(const OptionEntry& option) {
  std::string text = "    '" + std::string(option.many ? "*" : "") + option.name + "[" + quoted(option.help) + "]";
  if (option.takes != Takes::nothing) text += ":" + quoted(option.value) + ":" + zsh_action(option);
  return text + "' \\\n";
}

// For a command with subcommands, the first word selects one of them (or is a file), and the rest belongs to it.
std::string function(const CommandEntry& command) {
  std::string options;
  for (const OptionEntry& option : command.options) options += option_line(option);
  if (command.commands.empty()) {
    std::string text = function_name(command) + "() {\n  _arguments \\\n" + options;
    for (const OptionEntry& p : command.positionals)
      text += "    '" + std::string(p.many ? "*" : "") + ":" + quoted(p.name) + ":" + zsh_action(p) + "' \\\n";
    return text + "    && return\n}\n";
  }
  std::string names, branches;
  for (const CommandEntry& child : command.commands) {
    names += "    '" + child.path.back() + ":" + quoted(child.help) + "'\n";
    branches += "      " + child.path.back() + ") " + function_name(child) + " ;;\n";
  }
  return function_name(command) + "() {\n  local curcontext=$curcontext state line\n  local -a commands=(\n" + names +
         "  )\n  _arguments -C \\\n" + options +
         "    '1: :->first' '*:: :->rest'\n  case $state in\n    first)\n      _describe command commands\n" +
         (command.positionals.empty() ? "" : "      _files\n") + "      ;;\n    rest) case $line[1] in\n" + branches +
         "      esac ;;\n  esac\n}\n";
}

}  // namespace

std::string zsh_completion(const CommandEntry& program) {
  std::string text =
      "#compdef fascia\n# Completion of fascia for zsh, written by: fascia completion zsh\n_fascia_keys() {\n  case "
      "$PREFIX in\n";
  std::string keys;
  for (const SceneKey& key : scene_keys()) {
    keys += (keys.empty() ? "" : " ") + key.name;
    if (key.values.empty()) continue;
    text += "    " + key.name + "=*) compset -P '*='; compadd --";
    for (const std::string& value : key.values) text += " " + value;
    text += " ;;\n";
  }
  text += "    *) compadd -S = -- " + keys + " ;;\n  esac\n}\n";
  for (const CommandEntry* command : all_commands(program)) text += function(*command);
  // Supports sourcing and autoloading; the second calls the function at once.
  return text + "if [ \"$funcstack[1]\" = _fascia ]; then _fascia \"$@\"; else compdef _fascia fascia; fi\n";
}

}  // namespace fascia
