#include "app/cli/completion.h"
#include "app/cli/scene_keys.h"

namespace fascia {
namespace {

using Takes = OptionEntry::Takes;

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

std::string names_of(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> names;
  for (const CommandEntry& command : commands) names.push_back(command.path.back());
  return spaced(names);
}

// True where a command's own words are valid: the command was typed, and none of its subcommands.
std::string condition(const CommandEntry& command) {
  std::string text;
  for (const std::string& word : command.path)
    text += (text.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + word);
  if (!command.commands.empty())
    text += (text.empty() ? "" : "; and ") + ("not __fish_seen_subcommand_from " + names_of(command.commands));
  return in_quotes(text);
}

std::string value(const OptionEntry& option) {
  switch (option.takes) {
    case Takes::nothing:
      return "";
    case Takes::choice:
      return " -x -a " + in_quotes(spaced(option.choices));
    case Takes::file:
      return option.ending.empty() ? " -r -F" : " -x -a " + in_quotes("(__fish_complete_suffix " + option.ending + ")");
    case Takes::folder:
      return " -x -a '(__fish_complete_directories)'";
    case Takes::scene_value:
      return " -x -a '(__fascia_keys)'";
    case Takes::anything:
      break;
  }
  return " -x";
}

}  // namespace

std::string fish_completion(const CommandEntry& program) {
  std::string text = "# Completion of fascia for fish, written by: fascia completion fish\nfunction __fascia_keys\n";
  for (const SceneKey& key : scene_keys()) {
    if (key.values.empty()) text += "  echo " + key.name + "=\n";
    for (const std::string& v : key.values) text += "  echo " + key.name + "=" + v + "\n";
  }
  text += "end\n";
  for (const CommandEntry* command : all_commands(program)) {
    const std::string where = "complete -c fascia -n " + condition(*command);
    for (const CommandEntry& child : command->commands)
      text += where + " -a " + child.path.back() + " -d " + in_quotes(child.help) + "\n";
    for (const OptionEntry& option : command->options)
      text += where + " -l " + option.name.substr(2) + value(option) + " -d " + in_quotes(option.help) + "\n";
  }
  return text;
}

}  // namespace fascia
