#include "app/cli/command_line.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "app/cli/command_tree.h"
#include "base/file.h"
#include "base/json/json_document.h"
#include "base/suggest.h"

namespace fascia {
namespace {

constexpr const char* kAbout =
    "fascia: interactive soft tissue on the GPU. SI units everywhere.\n"
    "The manual: fascia man | man -l -, and once installed man fascia. Scene files and their keys: "
    "docs/guide/scenes.md";

// "--samples INT in [1 - 256] [4]": the value of an option and its default, shorter than CLI11 prints it.
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

// The innermost command on the command line.
const CLI::App& named_command(const CLI::App& program) {
  const std::vector<CLI::App*> named = program.get_subcommands();
  return named.empty() ? program : named_command(*named.front());
}

// Command names of other programs.
std::string command_for(const std::string& word) {
  static const std::map<std::string, std::string> others{
      {"simulate", "run"},   {"simulation", "run"}, {"sim", "run"},     {"solve", "run"},     {"open", "view"},
      {"show", "view"},      {"gui", "view"},       {"window", "view"}, {"draw", "render"},   {"screenshot", "render"},
      {"picture", "render"}, {"video", "render"},   {"test", "check"},  {"compare", "check"}, {"benchmark", "bench"},
      {"inspect", "info"},   {"describe", "info"},  {"manual", "man"},  {"help", "--help"},   {"version", "--version"}};
  const auto found = others.find(word);
  return found == others.end() ? "" : found->second;
}

std::vector<std::string> names_below(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CommandEntry& child : describe(command).commands) names.push_back(child.path.back());
  return names;
}

std::string near_command(const CLI::App& command, const std::string& word) {
  const std::string other = command.get_parent() ? "" : command_for(word);
  return other.empty() ? nearest(word, names_below(command)) : other;
}

std::string unknown_command(const CLI::App& command, const std::string& word) {
  const std::string near = near_command(command, word), what = on_one_line(word) + ": unknown command";
  return near.empty() ? what + "; expected one of " + join(names_below(command)) : what + ", perhaps you meant " + near;
}

// The first remaining word that resembles an option, else the first of all.
std::string left_over(const CLI::App& command, const std::vector<std::string>& words, bool any) {
  std::vector<std::string> options;
  for (const OptionEntry& option : describe(command).options) options.push_back(option.name);
  const auto name_of = [](const std::string& word) { return word.substr(0, word.find('=')); };
  for (const std::string& word : words) {
    const std::string near = word.starts_with("-") ? nearest(name_of(word), options) : "";
    if (!near.empty()) return on_one_line(name_of(word)) + ": not expected here, perhaps you meant " + near;
  }
  return any && !words.empty() ? on_one_line(name_of(words.front())) + ": not expected here" : "";
}

// A better message if the parser names the wrong word; else empty.
std::string better_reason(const CLI::App& program, const CLI::App& command, const CLI::ParseError& error) {
  const bool is_extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  const std::vector<std::string> words = program.remaining(true);
  // The parser takes a mistyped command for a scene, and then reports an extra argument.
  if (!command.get_parent() && is_extra)
    for (const std::string& scene : command.get_option("scene")->results())
      if (may_be_command(scene)) return unknown_command(command, scene);
  const bool needs_command = command.get_require_subcommand_min() > 0 && command.get_subcommands().empty();
  if (needs_command && !words.empty() && !words.front().starts_with("-"))
    return unknown_command(command, words.front());
  if (needs_command && !is_extra)
    return "fascia " + command.get_name() + ": no command named; expected one of " + join(names_below(command));
  return left_over(command, words, is_extra);
}

/// "Could not convert: --steps = 1.5", as fascia says it.
std::string conversion_reason(const std::string& text) {
  constexpr std::string_view kBegin = "Could not convert: ", kBetween = " = ";
  const std::size_t at = text.find(kBetween);
  if (!text.starts_with(kBegin) || at == std::string::npos) return text;
  const std::string value = text.substr(at + kBetween.size());
  char* end = nullptr;
  std::strtod(value.c_str(), &end);
  return text.substr(kBegin.size(), at - kBegin.size()) + ": is " + on_one_line(value) + "; expected a " +
         (!value.empty() && *end == 0 ? "whole number" : "number");
}

}  // namespace

bool may_be_command(const std::string& word) {
  std::error_code ec;
  return !word.empty() && word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, ec);
}

void refuse_mistyped_command(const CLI::App& program, const std::string& scene) {
  if (may_be_command(scene) && !near_command(program, scene).empty())
    throw CLI::ValidationError(unknown_command(program, scene));
}

std::unique_ptr<CLI::App> make_program() {
  auto program = std::make_unique<CLI::App>(kAbout);
  program->formatter(std::make_shared<HelpFormatter>());
  program->set_version_flag("--version", std::string("fascia ") + FASCIA_VERSION);
  program->require_subcommand(0, 1);
  return program;
}

void refuse_dashes(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    const OptionEntry entry = describe(*option);
    const bool is_file = entry.takes == OptionEntry::Takes::file, is_folder = entry.takes == OptionEntry::Takes::folder;
    if (entry.takes_dash || (!is_file && !is_folder)) continue;
    const std::string expected = is_file ? "a file, ./- if that is its name" : "a folder, ./- if that is its name";
    option->check(CLI::Validator(
        [expected](std::string& value) {
          return value == kStandardInput ? "- is standard input or output, which it does not take; expected " + expected
                                         : std::string();
        },
        ""));
  }
  for (CLI::App* child : command.get_subcommands([](const CLI::App*) { return true; })) refuse_dashes(*child);
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = named_command(program);
  std::string text = better_reason(program, command, error);
  if (text.empty()) text = conversion_reason(error.what());
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::string path;
  for (const CLI::App* named = &command; named->get_parent(); named = named->get_parent())
    path = named->get_name() + " " + path;
  const std::string help = "see fascia " + path + "--help";
  return text.find("; ") == std::string::npos ? text + "; " + help : text + " (" + help + ")";
}

}  // namespace fascia
