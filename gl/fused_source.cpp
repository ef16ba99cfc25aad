#include "gl/fused_source.h"

#include <cctype>
#include <set>
#include <sstream>
#include <string_view>

namespace fascia::gl {
namespace {

constexpr std::string_view kUniform = "uniform uint ";
// The common includes of all kernels.
const std::vector<std::string> kCommon = {"common/step.glsl", "shared/types.h", "common/fused.glsl"};

// The declarations of a kernel's text at its outermost level, which begin in the first column.
struct Names {
  std::set<std::string> globals, macros;
};

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// The first word that begins at or after `at`.
std::string word_from(const std::string& line, std::size_t at) {
  while (at < line.size() && !in_word(line[at])) ++at;
  std::size_t end = at;
  while (end < line.size() && in_word(line[end])) ++end;
  return line.substr(at, end - at);
}

Names names_of(const std::string& text) {
  Names names;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line[0] == '#' || line[0] == ' ') {
      const std::size_t hash = line.find_first_not_of(' ');
      if (hash != std::string::npos && line[hash] == '#' && word_from(line, hash) == "define")
        names.macros.insert(word_from(line, line.find("define") + 6));
      continue;
    }
    if (!in_word(line[0])) continue;
    const std::string type = word_from(line, 0), name = word_from(line, type.size());
    const std::size_t behind = type.size() + 1 + name.size();
    if (line.starts_with(kUniform)) {
      for (std::size_t at = kUniform.size(); at != std::string::npos && at < line.find(';');
           at = line.find(',', at + 1))
        names.globals.insert(word_from(line, at));
    } else if (type == "struct") {
      names.globals.insert(name);
    } else if (type == "shared" || type == "const") {
      names.globals.insert(word_from(line, behind));
    } else if (behind < line.size() && line[behind] == '(') {
      names.globals.insert(name);  // a function
    }
  }
  return names;
}

class Composer {
 public:
  explicit Composer(ShaderText& result) : result_(result) {}
  void line(const std::string& text, const ShaderText::Line& from = {"common/fused.glsl", 0}) {
    result_.text += text + "\n";
    result_.lines.push_back(from);
  }
  // Adds the text without the #version line.
  void all_of(const ShaderText& part) {
    std::istringstream in(part.text);
    std::string text;
    for (std::size_t i = 0; std::getline(in, text); ++i) {
      if (i == 0) continue;
      if (text.starts_with(kUniform)) text.erase(0, 8);  // a plain variable here
      line(text, part.lines[i]);
    }
  }

 private:
  ShaderText& result_;
};

std::string numbered(const std::string& name, std::size_t n) { return name + "_" + std::to_string(n); }

void append_kernel(Composer& out, const std::filesystem::path& folder, const FusedKernel& kernel, std::size_t n,
                   const Defines& all) {
  const ShaderText part = read_shader(folder, kernel.file, kernel.defines, kCommon);
  Names names = names_of(part.text);
  names.globals.insert("invocations");  // declared by COMPUTE_1D
  for (const auto& [name, fused] : kernel.buffers) names.globals.erase(name);
  for (const auto& [name, value] : all) names.macros.erase(name);
  for (const std::string& name : names.globals) out.line("#define " + name + " " + numbered(name, n));
  for (const auto& [name, fused] : kernel.buffers) out.line("#define " + name + " " + fused);
  out.all_of(part);
  out.line("void load_constants_of" + numbered("", n) + "(uint at) {");
  for (std::size_t k = 0; k < kernel.constants.size(); ++k)
    if (names.globals.contains(kernel.constants[k]))
      out.line("  " + kernel.constants[k] + " = PLAN(at + " + std::to_string(3 + k) + "u);");
  out.line("}");
  for (const auto& [name, fused] : kernel.buffers) out.line("#undef " + name);
  for (const std::string& name : names.globals) out.line("#undef " + name);
  for (const std::string& name : names.macros) out.line("#undef " + name);
}

// The name in groups_of() of the kernel after the k-th one of a loop, or 0 if its number of groups is unknown there.
std::string next_of(const std::vector<FusedKernel>& kernels, const std::vector<FusedLoop>& loops, std::size_t loop,
                    std::size_t k) {
  const bool last = k + 1 == loops[loop].size();
  if (last && loop + 1 == loops.size()) return "0u";
  const std::size_t next = last ? loops[loop + 1].front() : loops[loop][k + 1];
  if (kernels[next].groups.empty()) return "0u";
  const std::string name = std::to_string(next + 1) + "u";
  return last ? "turn + 1u == PLAN(" + std::to_string(1 + loop) + "u) ? " + name + " : 0u" : name;
}

void append_call(Composer& out, const FusedKernel& kernel, std::size_t n, const std::string& next) {
  out.line("      load_constants_of" + numbered("", n) + "(at);");
  out.line("      groups = " + (kernel.groups.empty() ? "PLAN(at)" : kernel.groups + "[PLAN(at)]") + ";");
  out.line("      most = PLAN(at + 1u);");
  out.line("      cost = PLAN(at + 2u);");
  out.line("      at += " + std::to_string(record_size(kernel)) + "u;");
  // Loops that test their condition last: llvmpipe runs other loops once more, with no active invocation.
  out.line("      begin_kernel();");
  out.line("      do {");
  out.line("        take_part(groups, most, cost);");
  out.line("        do {");
  out.line("          fused_invocation = group * uint(GROUP_SIZE) + gl_LocalInvocationID.x;");
  out.line("          if (group < end_of_part) " + numbered("main", n) + "();");
  out.line("          ++group;");
  out.line("        } while (group < end_of_part);");
  out.line("      } while (stretches_left > 0u);");
  out.line("      wait_for_crew(" + next + ", at);");
}

}  // namespace

ShaderText read_fused(const std::filesystem::path& folder, const Defines& defines,
                      const std::vector<std::string>& declarations, bool step, const std::vector<FusedKernel>& kernels,
                      const std::vector<FusedLoop>& loops) {
  Defines all = defines;
  all.emplace_back("FUSED", "1");
  ShaderText result = read_shader(folder, "common/fused.glsl", all);
  Composer out(result);
  if (step) out.all_of(read_shader(folder, "common/step.glsl", {}));
  for (const std::string& declaration : declarations) out.line(declaration);
  for (std::size_t n = 0; n < kernels.size(); ++n) append_kernel(out, folder, kernels[n], n, all);
  out.line("uint groups_of(uint next, uint record) {");
  for (std::size_t n = 0; n < kernels.size(); ++n)
    if (!kernels[n].groups.empty())
      out.line("  if (next == " + std::to_string(n + 1) + "u) return " + kernels[n].groups + "[PLAN(record)];");
  out.line("  return 1u;");
  out.line("}");
  out.line("void main() {");
  out.line("  kernel_count = repeats * PLAN(0u);");
  // A late group should execute as little as possible; a loop in llvmpipe runs at least once.
  out.line("  uint first = join_crew();");
  out.line(
      "  uint last_repeat = first == NO_KERNEL ? 0u : repeats, repeat = first == NO_KERNEL ? 0u : first / PLAN(0u);");
  out.line("  kernel_number = repeat * PLAN(0u);");
  out.line("  uint turn, at, groups, most, cost;");
  out.line("  do {");
  out.line("    at = " + std::to_string(1 + loops.size()) + "u;");
  for (std::size_t l = 0; l < loops.size(); ++l) {
    out.line("    turn = 0u;");
    out.line("    do {");
    for (std::size_t k = 0; k < loops[l].size(); ++k)
      append_call(out, kernels[loops[l][k]], loops[l][k], next_of(kernels, loops, l, k));
    out.line("      ++turn;");
    out.line("    } while (turn < PLAN(" + std::to_string(1 + l) + "u) && last_repeat > 0u);");
  }
  out.line("    ++repeat;");
  out.line("  } while (repeat < last_repeat);");
  out.line("}");
  return result;
}

}  // namespace fascia::gl
