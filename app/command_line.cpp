#include "app/command_line.h"

#include "app/command_tree.h"
#include "sim/suggest.h"

namespace fascia {
namespace {

// "--samples INT in [1 - 16] [4]": what an option takes and what it is without, shorter than CLI11 says it.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(32); }
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0) return "";
    const std::string type = option->get_type_name(), fallback = option->get_default_str();
    const std::size_t range = type.find(" in [");
    std::string text = " " + value_name(*option);
    if (range != std::string::npos) text += type.substr(range);
    if (!fallback.empty()) text += " [" + fallback + "]";
    return text + (option->get_required() ? " (required)" : "");
  }
};

// The innermost command that was named.
const CLI::App& named_command(const CLI::App& program) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  return named.empty() ? program : named_command(*named.front());
}

}  // namespace

std::unique_ptr<CLI::App> make_command_line(Invocation& invocation) {
  auto program = std::make_unique<CLI::App>("fascia: interactive soft tissue on the GPU. SI units everywhere. Files and keys: see README.md");
  program->formatter(std::make_shared<HelpFormatter>());
  program->set_version_flag("--version", std::string("fascia ") + FASCIA_VERSION);
  program->require_subcommand(0, 1);
  add_view(*program, invocation);
  add_render(*program, invocation);
  add_check(*program, invocation);
  add_run(*program, invocation);
  add_bench(*program, invocation);
  add_stress(*program, invocation);
  add_soak(*program, invocation);
  add_info(*program, invocation);
  add_convert(*program, invocation);
  add_completion(*program, invocation);
  add_man(*program, invocation);
  return program;
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error) {
  std::string text = error.what();
  const CLI::App& command = named_command(program);
  const CommandEntry entry = describe(command);
  std::vector<std::string> options, commands;
  for (const OptionEntry& option : entry.options) options.push_back(option.name);
  for (const CommandEntry& child : entry.commands) commands.push_back(child.path.back());
  // A mistyped command is taken for a scene, and then for one argument too many, or for none at all.
  std::vector<std::string> words = program.remaining(true);
  if (!command.get_parent() && !words.empty())
    for (const std::string& scene : command.get_option("scene")->results())
      if (!nearest(scene, commands).empty()) words = {scene};
  bool any_near = false;
  std::string lines;
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    const std::string near = nearest(name, name.starts_with("-") ? options : commands);
    any_near = any_near || !near.empty();
    lines += (lines.empty() ? "" : "\n") + name + ": not expected here" + (near.empty() ? "" : "; perhaps you meant " + near);
  }
  if (any_near || error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError)) text = lines;
  std::string path;
  for (const CLI::App* named = &command; named->get_parent(); named = named->get_parent()) path = named->get_name() + " " + path;
  return text + "\nRun fascia " + path + "--help for what there is.";
}

}  // namespace fascia
