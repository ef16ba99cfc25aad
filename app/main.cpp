// Catches all errors of the program: a line on stderr and exit code 1 (2 for wrong usage).
#include <exception>
#include <iostream>

#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/session/reproduce.h"
#include "base/error.h"
#include "base/interrupt.h"

namespace {

using namespace fascia;

int run(int argc, char** argv) {
  Invocation invocation{"fascia", {}};
  for (int i = 1; i < argc; ++i) invocation.command_line += " " + shell_quoted(argv[i]);
  const std::unique_ptr<CLI::App> program = make_command_line(invocation);
  try {
    program->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program->exit(error);  // help and version
    std::cerr << usage_message(*program, error) << '\n';
    return exit_usage;
  }
  catch_interrupts();
  try {
    return invocation.run();
  } catch (const UsageError& error) {
    std::cerr << error.what() << '\n';
    return exit_usage;
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int exit_code = run(argc, argv);
    if (!std::cout.flush())
      throw fascia::Error("standard output", "writing failed", "expected a device that takes data");
    return exit_code;
  } catch (const std::bad_alloc&) {
    std::cerr << "fascia: needs more memory than there is; expected a smaller mesh\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
  }
  return fascia::exit_failed;
}
