// The commands of fascia, each in the file of its name, with its options and its work.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command_line.h"
#include "base/interrupt.h"

namespace fascia {

inline constexpr int exit_done = 0, exit_failed = 1, exit_usage = 2;  // and exit_interrupted

/// The program with all its commands. Parsing it fills `invocation`, which must outlive it. The command then returns
/// the exit code; Error and other exceptions are caught once, in main.
std::unique_ptr<CLI::App> make_command_line(Invocation& invocation);

}  // namespace fascia
