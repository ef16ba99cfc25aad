// What the commands of the command line (app/commands) share: options that several have, help, and one line for what is
// wrong. Help, man page and completion are made from the same options.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "app/cli/options.h"

namespace fascia {

/// What the parsed command line asks for.
struct Invocation {
  std::string command_line;  // as typed, for provenance
  std::function<int()> run;  // returns the exit code
};

std::unique_ptr<CLI::App> make_program();  // without commands
/// Where an option of the program or of a command below it is a file or a folder and does not say that it takes "-",
/// "-" becomes an error.
void refuse_dashes(CLI::App& program);

// Options that several commands have.
void add_size(CLI::App& command, int& width, int& height);
void add_graphics(CLI::App& command, CommonOptions& options);
void add_common(CLI::App& command, CommonOptions& options);  // add_graphics() and what opens and steps a scene

/// Ends the name of a value, as in "FILE.csv or -", where "-" is standard input or output; elsewhere "-" is refused.
inline constexpr const char* kOrDash = " or -";

/// For options that are finite numbers.
CLI::Validator at_least(double least);

/// One of `choices`, which the help shows as a|b|c. `name` begins with "--", or is a positional's.
CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& field,
                        const std::vector<std::string>& choices, const std::string& help);

/// Ends the command's help: command lines that do something useful, and exit codes where 1 means more than that the
/// work failed.
void add_examples(CLI::App& command, const std::vector<std::string>& lines,
                  const std::string& failed = "the work failed");

/// Whether a scene's name could be meant as that of a command: no file, and neither ending nor folder.
bool may_be_command(const std::string& word);
/// Throws CLI::ValidationError where the scene is none, and nearly the name of a command.
void refuse_mistyped_command(const CLI::App& program, const std::string& scene);

/// What a wrong command line is answered with, in one line: the error and, where a word is nearly one that is known,
/// that word.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error);

}  // namespace fascia
