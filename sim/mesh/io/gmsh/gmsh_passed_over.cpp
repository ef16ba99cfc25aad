// Gmsh .msh: sections that a mesh does not need. No content of theirs makes a file unreadable.
#include <algorithm>

#include "base/error.h"
#include "sim/mesh/io/gmsh/gmsh.h"

namespace fascia {
namespace {

constexpr std::size_t kNamedSections = 8;
constexpr std::size_t kMostTags = 100;  // of one kind; Gmsh writes three at most

std::size_t tag_count(Scanner& in, const char* tags) {
  const std::size_t count = in.count(tags, 1);
  if (count > kMostTags)
    in.fail("has " + std::to_string(count) + " " + tags, "expected at most " + std::to_string(kMostTags));
  return count;
}

/// Skips the numbers of a binary $NodeData, $ElementData or $ElementNodeData, whose head is text. Throws Error.
void skip_binary_data(Scanner& in, bool per_node) {
  const std::size_t names = tag_count(in, "names");
  in.end_line("the number of names");
  for (std::size_t i = 0; i < names; ++i) in.line();
  const std::size_t reals = tag_count(in, "real tags");
  for (std::size_t i = 0; i < reals; ++i) in.number<double>("a real tag");
  const std::size_t integers = tag_count(in, "integer tags");
  std::uint64_t components = 0, entries = 0;
  for (std::size_t i = 0; i < integers; ++i) {
    const auto tag = in.number<std::uint32_t>("an integer tag");
    if (i == 1) components = tag;
    if (i == 2) entries = tag;
  }
  in.end_line("the integer tags");
  constexpr std::uint64_t number = sizeof(std::int32_t);
  const std::uint64_t row = sizeof(double) * components;
  in.check_count(entries, "values", number + (per_node ? number : row));
  if (!per_node) return in.skip(entries * (number + row), "the values");
  for (std::uint64_t i = 0; i < entries; ++i) {
    in.skip(number, "an element number");
    const auto nodes = in.binary<std::uint32_t>("a number of nodes");
    in.check_count(nodes, "values of an element", std::max<std::uint64_t>(row, 1));
    in.skip(nodes * row, "the values of an element");
  }
}

}  // namespace

/// Skips by the counts in the section, if they lead to its end tag: the numbers may contain bytes that look like a tag.
bool GmshReader::skip_by_counts(std::string_view name) {
  const bool per_node = name == "$ElementNodeData";
  if (!binary_ || wrong_counts_ || (name != "$NodeData" && name != "$ElementData" && !per_node)) return false;
  const Scanner before = in_;
  try {
    skip_binary_data(in_, per_node);
    if (in_.take(gmsh_end_tag(name))) return true;
  } catch (const Error&) {  // falls back to a search for the tag
  }
  in_ = before;
  wrong_counts_ = true;
  return false;
}

void GmshReader::skip_section(std::string_view name) {
  if (name != "$Comments") passed_over_.emplace(name);
  if (skip_by_counts(name)) return;
  if (!tags_) tags_.emplace(in_.data());
  const std::string end_tag = gmsh_end_tag(name);
  const std::size_t from = in_.offset(), nowhere = in_.data().size();
  const std::size_t end = tags_->find(end_tag, from).value_or(nowhere),
                    again = tags_->find(name, from).value_or(nowhere);
  if (end < again) return in_.seek(end + end_tag.size());
  endless_.emplace(name);
  std::size_t next = again;
  for (const char* const needed : {"$PhysicalNames", "$Entities", "$PartitionedEntities", "$Nodes", "$ParametricNodes",
                                   "$Elements", "$NOD", "$ELM"})
    next = std::min(next, tags_->find(needed, from).value_or(nowhere));
  in_.seek(next);
}

/// Text between sections: Gmsh skips it, too.
void GmshReader::skip_stray_line(std::string_view word) {
  if (!has_stray_lines_) file_.notes.push_back("Text between sections passed over, first " + in_quotes(word) + ".");
  has_stray_lines_ = true;
  in_.line();
}

/// Reads the section, or skips it if it is not understood.
void GmshReader::read_optional(std::string_view name, void (GmshReader::*reader)()) {
  if (passed_over_.contains(std::string(name))) return skip_section(name);
  const Scanner before = in_;
  try {
    return (this->*reader)();
  } catch (const Error& error) {
    file_.notes.push_back("Section " + std::string(name) + " cannot be understood and is passed over: " + error.what() +
                          ".");
  }
  in_ = before;
  skip_section(name);
}

void GmshReader::note_sections() {
  const auto note = [&](const std::set<std::string>& sections, const std::string& one, const std::string& several,
                        const std::string& rest) {
    if (sections.empty()) return;
    std::string text = sections.size() == 1 ? one : several;
    std::size_t named = 0;
    for (const std::string& section : sections) {
      if (named == kNamedSections) break;
      text += (named++ ? ", " : " ") + section.substr(0, 40);
    }
    if (named < sections.size()) text += " and " + std::to_string(sections.size() - named) + " more";
    file_.notes.push_back(text + rest);
  };
  note(passed_over_, "Section that holds no part of the mesh passed over:",
       "Sections that hold no part of the mesh passed over:", ".");
  note(endless_, "Section without an end:", "Sections without an end:", "; the file may be cut off.");
}

}  // namespace fascia
