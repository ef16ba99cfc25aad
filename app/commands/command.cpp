#include "app/commands/command.h"

namespace fascia {

// Adds a command to the program; when parsed, it stores its action in the invocation.
using AddCommand = void(CLI::App& program, Invocation& invocation);
AddCommand add_view, add_render, add_check, add_run, add_bench, add_stress, add_soak, add_verify, add_refine, add_fit,
    add_info, add_convert, add_kernels, add_completion, add_man;

std::unique_ptr<CLI::App> make_command_line(Invocation& invocation) {
  std::unique_ptr<CLI::App> program = make_program();
  for (AddCommand* add : {add_view, add_render, add_check, add_run, add_bench, add_stress, add_soak, add_verify,
                          add_refine, add_fit, add_info, add_convert, add_kernels, add_completion, add_man})
    add(*program, invocation);
  refuse_dashes(*program);
  return program;
}

}  // namespace fascia
