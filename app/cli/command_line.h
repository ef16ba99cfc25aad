// The command line: one function per command, each in command_line_<name>.cpp, which adds its options and says what to
// run. An option is added in its command's file and nowhere else: help, man page and completion are made from these
// tables.
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

/// The program with all its commands; parsing it fills `invocation`, which must outlive it.
std::unique_ptr<CLI::App> make_command_line(Invocation& invocation);

void add_view(CLI::App& program, Invocation& invocation);  // as command, and as what runs without one
void add_render(CLI::App& program, Invocation& invocation);
void add_check(CLI::App& program, Invocation& invocation);
void add_run(CLI::App& program, Invocation& invocation);
void add_bench(CLI::App& program, Invocation& invocation);
void add_stress(CLI::App& program, Invocation& invocation);
void add_soak(CLI::App& program, Invocation& invocation);
void add_info(CLI::App& program, Invocation& invocation);
void add_convert(CLI::App& program, Invocation& invocation);
void add_completion(CLI::App& program, Invocation& invocation);
void add_man(CLI::App& program, Invocation& invocation);

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
