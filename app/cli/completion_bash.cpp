// Completion for bash alone: it does not use the package bash-completion, which is not always installed.
#include "app/cli/completion.h"
#include "app/cli/scene_keys.h"

namespace fascia {
namespace {

using Takes = OptionEntry::Takes;

std::string slashed(const std::vector<std::string>& path) {
  std::string text;
  for (const std::string& word : path) text += "/" + word;
  return text;
}

std::string bash_action(const OptionEntry& option) {
  switch (option.takes) {
    case Takes::choice:
      return "_fascia_words '" + spaced(option.choices) + "'";
    case Takes::file:
      return "_fascia_files '" + option.ending + "'";
    case Takes::folder:
      return "_fascia_folders";
    case Takes::scene_value:
      return "_fascia_keys";
    case Takes::anything:
    case Takes::nothing:
      break;
  }
  return ":";
}

std::string branch(const CommandEntry& command) {
  std::string text = "    '" + slashed(command.path) + "')\n      case $prev in\n";
  std::vector<std::string> names, commands;
  for (const OptionEntry& option : command.options) {
    names.push_back(option.name);
    if (option.takes != Takes::nothing) text += "        " + option.name + ") " + bash_action(option) + "; return ;;\n";
  }
  text += "      esac\n      if [[ $cur == -* ]]; then _fascia_words '" + spaced(names) + "'; return; fi\n";
  for (const CommandEntry& child : command.commands) commands.push_back(child.path.back());
  if (!commands.empty()) text += "      _fascia_words '" + spaced(commands) + "'\n";
  if (!command.positionals.empty()) text += "      " + bash_action(command.positionals.front()) + "\n";
  return text + "      ;;\n";
}

}  // namespace

std::string bash_completion(const CommandEntry& program) {
  std::string paths, branches, keys, values;
  for (const CommandEntry* command : all_commands(program)) {
    if (!command->path.empty())
      paths += "      '" + slashed(command->path) + "') path=" + slashed(command->path) + " ;;\n";
    branches += branch(*command);
  }
  for (const SceneKey& key : scene_keys()) {
    keys += (keys.empty() ? "" : " ") + key.name + "=";
    if (!key.values.empty()) values += "    " + key.name + ") _fascia_words '" + spaced(key.values) + "' ;;\n";
  }
  return "# Completion of fascia for bash, written by: fascia completion bash\n"
         "_fascia_words() { COMPREPLY+=($(compgen -W \"$1\" -- \"$cur\")); }\n"
         "_fascia_folders() {\n"
         "  local IFS=$'\\n'\n"
         "  compopt -o filenames 2>/dev/null\n"
         "  COMPREPLY+=($(compgen -d -- \"$cur\"))\n"
         "}\n"
         "_fascia_files() {  # those with an ending, and folders on the way to them\n"
         "  local IFS=$'\\n'\n"
         "  _fascia_folders\n"
         "  local file\n"
         "  for file in $(compgen -f -X \"!*$1\" -- \"$cur\"); do [[ -d $file ]] || COMPREPLY+=(\"$file\"); done\n"
         "}\n"
         "_fascia_keys() {\n"
         "  compopt -o nospace 2>/dev/null\n"
         "  _fascia_words '" +
         keys +
         "'\n"
         "}\n"
         "_fascia() {\n"
         "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} path= i\n"
         "  COMPREPLY=()\n"
         "  # bash cuts words at \"=\": --context=egl is three of them, and so is solver.method=jacobi.\n"
         "  if [[ $cur == = ]]; then cur=; else [[ $prev == = ]] && prev=${COMP_WORDS[COMP_CWORD - 2]}; fi\n"
         "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
         "    case $path/${COMP_WORDS[i]} in\n" +
         paths +
         "    esac\n"
         "  done\n"
         "  case $prev in\n" +
         values +
         "  esac\n"
         "  ((${#COMPREPLY[@]})) && return\n"
         "  case $path in\n" +
         branches +
         "  esac\n"
         "}\n"
         "complete -F _fascia fascia\n";
}

}  // namespace fascia
