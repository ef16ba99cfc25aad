// The command line as a tree of plain texts, from which the man page and the completion of shells are generated.
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fascia {

struct OptionEntry {
  enum class Takes { nothing, anything, choice, file, folder, scene_value };
  std::string name;            // "--set"; of a positional "scene"
  std::string value;           // "KEY=VALUE"; empty: it is a flag
  std::string help, fallback;  // fallback: the default, if it is worth mentioning
  Takes takes = Takes::anything;
  std::vector<std::string> choices;  // of Takes::choice
  std::string ending;                // of Takes::file: ".png"; empty: any
  bool takes_dash = false;           // "-" for standard input or output
  bool required = false, many = false;
};

struct CommandEntry {
  std::vector<std::string> path;  // {"bench", "speed"}; empty: the program
  std::string help, examples;
  std::vector<OptionEntry> options, positionals;
  std::vector<CommandEntry> commands;  // without hidden ones
};

CommandEntry describe(const CLI::App& program);
OptionEntry describe(const CLI::Option& option);

/// The command and all its descendants, parents first.
std::vector<const CommandEntry*> all_commands(const CommandEntry& command);

/// Joins words with spaces.
std::string spaced(const std::vector<std::string>& words);

/// "INT" of "INT:INT in [1 - 16]": the value of an option, without its validation.
std::string value_name(const CLI::Option& option);

}  // namespace fascia
