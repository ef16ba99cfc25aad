#include "app/cli/manual_page.h"

namespace fascia {
namespace {

// Escapes a text for roff. A line must begin with neither "." nor "'".
std::string plain(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if ((c == '.' || c == '\'') && (i == 0 || text[i - 1] == '\n')) result += "\\&";
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

std::string typed(const std::vector<std::string>& words) {
  std::string text = "fascia";
  for (const std::string& word : words) text += " " + word;
  return text;
}

std::string synopsis(const CommandEntry& command) {
  std::string text = ".B " + plain(typed(command.path)) + "\n[\\fIoptions\\fR]";
  for (const OptionEntry& p : command.positionals) {
    const std::string name = "\\fI" + plain(p.name) + "\\fR" + (p.many ? " ..." : "");
    text += p.required ? " " + name : " [" + name + "]";
  }
  return text + "\n";
}

std::string paragraph(const OptionEntry& option) {
  std::string text = ".TP\n\\fB" + plain(option.name) + "\\fR";
  if (!option.value.empty() && option.name.starts_with("-")) text += " \\fI" + plain(option.value) + "\\fR";
  text += "\n" + plain(option.help);
  if (!option.fallback.empty()) text += " [" + plain(option.fallback) + "]";
  return text + "\n";
}

std::string section(const CommandEntry& command) {
  std::string text = ".SS " + plain(typed(command.path)) + "\n" + plain(command.help) + "\n.PP\n" + synopsis(command);
  for (const OptionEntry& p : command.positionals) text += paragraph(p);
  for (const OptionEntry& option : command.options) text += paragraph(option);
  if (!command.examples.empty()) text += ".PP\n.nf\n" + plain(command.examples) + "\n.fi\n";
  return text;
}

}  // namespace

std::string manual_page(const CommandEntry& program) {
  std::string text = ".TH FASCIA 1 \"\" \"fascia " FASCIA_VERSION
                     "\" \"User Commands\"\n.SH NAME\nfascia \\- interactive soft tissue on the GPU\n.SH SYNOPSIS\n";
  for (const CommandEntry* command : all_commands(program))
    if (command->commands.empty() || command->path.empty()) text += synopsis(*command) + ".br\n";
  text +=
      ".SH DESCRIPTION\n"
      "fascia steps tetrahedral meshes in OpenGL 4.3 compute shaders: in a window in which tissue can be grabbed, or "
      "without one as\n"
      "pictures, videos, exported states, measurements and regression checks. SI units everywhere; y is up.\n"
      "Scene files are strict JSON; docs/guide/scenes.md lists their keys (FILES says where it is).\n"
      "A command that takes a scene or writes a table takes \\- for standard input or output, where its options say "
      "so: a scene is then\n"
      "read with paths from the working folder, and nothing else is printed on standard output.\n.SH COMMANDS\n";
  for (const CommandEntry* command : all_commands(program))
    if (command->commands.empty() || command->path.empty()) text += section(*command);
  text +=
      ".SH EXIT STATUS\n"
      ".TP\n0\ndone\n.TP\n1\nthe work failed or a comparison did: one line on stderr says where, what, and what was "
      "expected\n"
      ".TP\n2\nwrong usage\n.TP\n130\ninterrupted; the file being written is the old one or the new one, never half of "
      "it\n"
      ".SH FILES\n"
      ".TP\ndocs/guide/scenes.md\nkeys of scene files: in share/doc/fascia beside the folder bin of the installed "
      "program, else in the source tree. So are\n"
      "README.md and the other pages of docs\n"
      ".TP\nshare/man/man1/fascia.1\nthis page of the installed program. The program prints it: fascia man | man \\-l "
      "\\-\n"
      ".SH ENVIRONMENT\n"
      ".TP\nFASCIA_DATA_DIR\nfolder that holds shaders/ and assets/\n"
      ".TP\nFASCIA_GL_DEBUG\nset to anything: OpenGL's debug messages on stderr\n"
      ".TP\nLP_NUM_THREADS\nworker threads of the software renderer llvmpipe; 0 for none. No result depends on it\n";
  return text;
}

}  // namespace fascia
