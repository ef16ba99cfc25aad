// The common part of the commands of the command line (app/commands): shared options, help, and one-line error
// messages. Help, man page and completion are generated from the same options.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>

#include "app/cli/options.h"

namespace fascia {

/// The action that the parsed command line requests.
struct Invocation {
  std::string command_line;  // as typed, for provenance
  std::function<int()> run;  // returns the exit code
};

std::unique_ptr<CLI::App> make_program();  // without commands
/// Makes "-" an error for every option of the program or its commands that is a file or a folder and does not declare
/// that it accepts "-".
void refuse_dashes(CLI::App& program);

// Options of several commands.
void add_size(CLI::App& command, int& width, int& height);
void add_quality(CLI::App& command, CommonOptions& options);
void add_graphics(CLI::App& command, CommonOptions& options);
/// --unit and --up, and the scene values that they set.
void add_mesh_frame(CLI::App& command, std::string& unit, std::string& up);
std::vector<std::string> mesh_frame_sets(const std::string& unit, const std::string& up);
void add_common(CLI::App& command, CommonOptions& options);  // add_graphics(), and how to open and step a scene

/// The end of the name of a value, as in "FILE.csv or -", for options that accept "-" as standard input or output;
/// other options refuse "-".
inline constexpr const char* kOrDash = " or -";

/// For options that are finite numbers.
CLI::Validator at_least(double least);

/// One of `choices`, which the help shows as a|b|c. `name` begins with "--", or is that of a positional.
CLI::Option* add_choice(CLI::App& command, const std::string& name, std::string& field,
                        const std::vector<std::string>& choices, const std::string& help);

/// Adds to the end of the command's help: useful command lines, and exit codes if 1 means more than a failure.
void add_examples(CLI::App& command, const std::vector<std::string>& lines,
                  const std::string& failed = "the work failed");

/// Whether the name of a scene may be meant as a command: it is no file and has neither extension nor folder.
bool may_be_command(const std::string& word);
/// Throws CLI::ValidationError if the scene does not exist and resembles the name of a command.
void refuse_mistyped_command(const CLI::App& program, const std::string& scene);

/// The one-line answer to a wrong command line: the error and, for a word that resembles a known one, that word.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error);

}  // namespace fascia
