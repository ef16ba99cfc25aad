#include "app/command_line.h"

namespace fascia {

std::unique_ptr<CLI::App> make_command_line(Invocation& invocation) {
  auto program = std::make_unique<CLI::App>("fascia: interactive soft tissue on the GPU. SI units everywhere. Files and keys: see README.md");
  program->set_version_flag("--version", std::string("fascia ") + FASCIA_VERSION);
  program->require_subcommand(0, 1);
  add_view(*program, invocation);
  add_render(*program, invocation);
  add_run(*program, invocation);
  add_bench(*program, invocation);
  add_stress(*program, invocation);
  add_soak(*program, invocation);
  add_info(*program, invocation);
  add_convert(*program, invocation);
  return program;
}

}  // namespace fascia
