#include "app/cli/command_tree.h"

#include "app/cli/command_line.h"

namespace fascia {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

OptionEntry entry_of(const CLI::Option& option) {
  using Takes = OptionEntry::Takes;
  OptionEntry entry;
  entry.name = option.get_positional() ? option.get_name() : option.get_name(false, true);
  const std::size_t comma = entry.name.find(',');
  if (comma != std::string::npos) entry.name = entry.name.substr(comma + 1);  // the long name of "-h,--help"
  entry.help = option.get_description();
  entry.required = option.get_required();
  entry.many = option.get_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  if (option.get_type_size() == 0) {
    entry.takes = Takes::nothing;
    return entry;
  }
  entry.value = value_name(option);
  entry.fallback = option.get_default_str();
  if (entry.value.find('|') != std::string::npos) {
    entry.takes = Takes::choice;
    entry.choices = split(entry.value, '|');
  } else if (entry.value == "DIR") {
    entry.takes = Takes::folder;
  } else if (entry.value == "KEY=VALUE") {
    entry.takes = Takes::scene_value;
  } else if (entry.value.starts_with("FILE") || entry.value.starts_with("GOLDEN")) {
    entry.takes = Takes::file;
    entry.takes_dash = entry.value.ends_with(kOrDash);
    const std::size_t dot = entry.value.find('.');
    if (dot != std::string::npos) entry.ending = entry.value.substr(dot, entry.value.find(' ') - dot);
  }
  return entry;
}

CommandEntry entry_of(const CLI::App& command, std::vector<std::string> path) {
  CommandEntry entry;
  entry.help = command.get_description();
  entry.examples = command.get_footer();
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_group().empty()) continue;
    (option->get_positional() ? entry.positionals : entry.options).push_back(entry_of(*option));
  }
  for (const CLI::App* child : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (child->get_group().empty()) continue;
    std::vector<std::string> longer = path;
    longer.push_back(child->get_name());
    entry.commands.push_back(entry_of(*child, longer));
  }
  entry.path = std::move(path);
  return entry;
}

}  // namespace

OptionEntry describe(const CLI::Option& option) { return entry_of(option); }

CommandEntry describe(const CLI::App& program) { return entry_of(program, {}); }

std::vector<const CommandEntry*> all_commands(const CommandEntry& command) {
  std::vector<const CommandEntry*> list{&command};
  for (const CommandEntry& child : command.commands)
    for (const CommandEntry* below : all_commands(child)) list.push_back(below);
  return list;
}

std::string spaced(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string value_name(const CLI::Option& option) {
  const std::string name = option.get_type_name();
  return name.substr(0, name.find(':'));
}

}  // namespace fascia
