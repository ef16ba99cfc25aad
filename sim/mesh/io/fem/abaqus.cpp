// Abaqus and CalculiX .inp: keyword lines that begin with '*', then lines of values with commas. Nodes, elements, sets
// and solid sections are read; the sections' sets of elements are the regions, or else the sets that *ELEMENT names.
// A part may be placed by one *INSTANCE. Files that *INCLUDE or INPUT= names are read in their place.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "sim/mesh/io/fem/fem_mesh.h"
#include "sim/mesh/io/fem/included_files.h"

namespace fascia {
namespace {

constexpr const char* kOfAssembly = " (assembly)";  // behind the name of a set whose name a set of the part has

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\"");
  if (begin == text.npos) return "";
  return std::string(text.substr(begin, text.find_last_not_of(" \t\r\"") + 1 - begin));
}

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// A keyword line: its words in upper case, the values of parameters as they are.
struct Keyword {
  std::string name;
  std::map<std::string, std::string> parameters;
  bool has(const char* parameter) const { return parameters.contains(parameter); }
  std::string value(const char* parameter) const {
    const auto found = parameters.find(parameter);
    return found == parameters.end() ? "" : found->second;
  }
};

/// The kind of element by its name: C3D10MH is a solid of ten nodes, CPS3 a triangle.
std::optional<FemElement> abaqus_element(const std::string& type) {
  struct Family {
    const char* prefix;
    int dimension;
  };
  static constexpr std::array<Family, 15> families = {{{"DC3D", 3},
                                                       {"AC3D", 3},
                                                       {"C3D", 3},
                                                       {"SFM3D", 2},
                                                       {"M3D", 2},
                                                       {"R3D", 2},
                                                       {"STRI", 2},
                                                       {"CPS", 2},
                                                       {"CPE", 2},
                                                       {"CAX", 2},
                                                       {"DC2D", 2},
                                                       {"DS", 2},
                                                       {"S", 2},
                                                       {"T3D", 1},
                                                       {"B3", 1}}};
  const auto family = std::find_if(families.begin(), families.end(), [&](const Family& f) {
    const std::size_t length = std::string_view(f.prefix).size();
    return type.starts_with(f.prefix) && type.size() > length && std::isdigit(static_cast<unsigned char>(type[length]));
  });
  if (family == families.end()) return std::nullopt;
  std::size_t nodes = 0;
  std::from_chars(type.data() + std::string_view(family->prefix).size(), type.data() + type.size(), nodes);
  if (family->prefix == std::string_view("STRI") && nodes == 65) nodes = 6;
  static const std::map<std::pair<int, std::size_t>, std::size_t> corners = {
      {{3, 4}, 4},  {{3, 5}, 5},  {{3, 6}, 6}, {{3, 8}, 8}, {{3, 10}, 4}, {{3, 13}, 5}, {{3, 15}, 6},
      {{3, 20}, 8}, {{3, 27}, 8}, {{2, 3}, 3}, {{2, 4}, 4}, {{2, 6}, 3},  {{2, 8}, 4},  {{2, 9}, 4}};
  const auto found = corners.find({family->dimension, nodes});
  if (found == corners.end()) return FemElement{family->dimension, 0, 0};
  return FemElement{family->dimension, found->second, nodes};
}

class AbaqusReader {
 public:
  AbaqusReader(Scanner& in, MeshFile& file, const ReadBeside& read_beside)
      : in_(&in), file_(file), mesh_(file), included_(in.where(), read_beside) {}

  void read() {
    file_.format = "Abaqus";
    in_->skip_commas();
    read_keywords();
    in_->set_section("");
    if (file_.mesh.positions.empty()) in_->fail("has no nodes", "expected *NODE");
    name_regions();
    if (own_nodes_)
      file_.notes.push_back("Nodes of the assembly, which belong to no part, and sets of them are left out.");
    note_cut_off(*in_, file_);
    place();
    mesh_.finish(in_->where());
  }

 private:
  using Of = FemMesh::Of;

  char next() const { return in_->remaining() > 0 ? in_->data()[in_->offset()] : '\0'; }
  bool at_comment() const { return in_->data().substr(in_->offset()).starts_with("**"); }
  bool at_keyword() const { return next() == '*' && !at_comment(); }

  void read_keywords() {
    while (in_->remaining() > 0) {
      if (!at_keyword()) {
        in_->line();  // values of a keyword that is passed over, blank lines, comments
        continue;
      }
      in_->blame(in_->offset());
      read_keyword(keyword_line());
    }
  }

  /// Calls read() with in_ at the beginning of the file that a parameter INPUT names.
  template <class Read>
  void read_other(const Keyword& keyword, Read read) {
    Scanner& other = included_.open(*in_, keyword.value("INPUT"));
    Scanner* const outer = std::exchange(in_, &other);
    in_->skip_commas();
    in_->set_section("*" + keyword.name);
    read();
    note_cut_off(*in_, file_);
    in_ = outer;
  }

  /// At the beginning of the next line of values; false before a keyword and at the end.
  bool at_values() {
    while (in_->remaining() > 0 && !at_keyword()) {
      if (!at_comment() && !in_->at_line_end()) return true;
      in_->line();
    }
    return false;
  }

  Keyword keyword_line() {
    std::string text;
    for (bool goes_on = true; goes_on && in_->remaining() > 0;) {
      const std::string_view line = in_->line();
      text += line;
      goes_on = trimmed(line).ends_with(',') && !at_keyword();
    }
    Keyword keyword;
    std::string_view rest(text);
    for (bool first = true; !rest.empty(); first = false) {
      const std::string_view part = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(part.size() + 1, rest.size()));
      if (first) {
        keyword.name = upper_case(trimmed(part.substr(1)));
      } else {
        const std::size_t equals = std::min(part.find('='), part.size());
        keyword.parameters[upper_case(trimmed(part.substr(0, equals)))] =
            equals < part.size() ? trimmed(part.substr(equals + 1)) : "";
      }
    }
    return keyword;
  }

  void read_keyword(const Keyword& keyword) {
    in_->set_section("*" + keyword.name);
    if (keyword.name == "ASSEMBLY" || keyword.name == "END ASSEMBLY") return begin_assembly(keyword.name == "ASSEMBLY");
    if (keyword.name == "NODE" || keyword.name == "ELEMENT") {
      own_nodes_ |= in_assembly_;  // reference points, whose numbers are not those of the part
      if (in_assembly_) return;
      require_rectangular(keyword);
      const auto values = [&] { keyword.name == "NODE" ? read_nodes(keyword) : read_elements(keyword); };
      if (keyword.has("INPUT")) read_other(keyword, values);
      return values();
    }
    if (keyword.name == "NSET") return read_set(keyword, Of::nodes);
    if (keyword.name == "ELSET") return read_set(keyword, Of::elements);
    if (keyword.name == "SOLID SECTION" && !keyword.value("ELSET").empty())
      return sections_.push_back(known_name(Of::elements, keyword.value("ELSET")));
    if (keyword.name == "INCLUDE") return read_other(keyword, [&] { read_keywords(); });
    if (keyword.name == "INSTANCE") return read_instance();
    if (keyword.name == "PART" && ++parts_ > 1 && !file_.mesh.positions.empty())
      in_->fail("is the second part", "expected one: export the parts as one, or each in a file of its own");
  }

  void begin_assembly(bool begins) {
    in_assembly_ = begins && parts_ > 0;
    for (const auto& [key, name] : spelled_) of_part_.insert(key.second);
  }

  void require_rectangular(const Keyword& keyword) {
    const std::string system = upper_case(keyword.value("SYSTEM"));
    if (!system.empty() && system != "R")
      in_->fail("coordinates are in system " + in_quotes(system), "expected R, rectangular ones");
  }

  void read_nodes(const Keyword& keyword) {
    const std::string name = keyword.value("NSET");
    std::vector<FemRange>* const set = name.empty() ? nullptr : &set_of(Of::nodes, name);
    while (at_values()) {
      const auto number = in_->number_on_line<std::int64_t>("a node number");
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = in_->coordinate_on_line("a node coordinate");
      mesh_.add_node(*in_, number, x);
      if (set) set->push_back({number, number, 1});
      in_->line();  // Abaqus allows a normal behind the coordinates
    }
  }

  /// A line of values goes on in the next one if it ends with a comma.
  void continue_line() {
    if (!in_->at_line_end()) return;
    const std::string_view before = in_->data().substr(0, in_->offset());
    const std::size_t last = before.find_last_not_of(" \t\r");
    if (last != before.npos && before[last] == ',') in_->line();
  }

  void read_elements(const Keyword& keyword) {
    const std::string type = upper_case(keyword.value("TYPE"));
    if (type.empty()) in_->fail("has no TYPE", "expected one such as TYPE=C3D4");
    const FemElement kind = abaqus_element(type).value_or(FemElement{3, 0, 0});
    const std::string name = keyword.value("ELSET");
    std::vector<FemRange>* const set = name.empty() ? nullptr : &set_of(Of::elements, name);
    if (set && kind.dimension == 3) add_block(known_name(Of::elements, name));
    std::vector<std::int64_t> nodes(kind.nodes);
    while (at_values()) {
      const auto number = in_->number_on_line<std::int64_t>("an element number");
      for (std::int64_t& node : nodes) {
        continue_line();
        node = in_->number_on_line<std::int64_t>("a node of an element");
      }
      mesh_.add_element(*in_, kind, number, nodes, 0);
      if (kind.nodes > 0) {
        in_->end_line("the nodes of an element");
      } else {
        skip_record();
      }
      if (set) set->push_back({number, number, 1});
    }
  }

  void skip_record() {
    while (trimmed(in_->line()).ends_with(',') && at_values()) {
    }
  }

  void read_set(const Keyword& keyword, Of of) {
    const std::string name = keyword.value(of == Of::nodes ? "NSET" : "ELSET");
    if (name.empty()) in_->fail("has no name", of == Of::nodes ? "expected NSET=NAME" : "expected ELSET=NAME");
    if (of == Of::nodes && keyword.has("ELSET"))  // of the nodes of these elements, which the group of a set has
      return add_set(set_of(Of::elements, name), Of::elements, keyword.value("ELSET"));
    const bool numbers_of_part = !in_assembly_ || !own_nodes_ || keyword.has("INSTANCE");
    std::vector<FemRange>& set = set_of(of, name);
    std::vector<FemRange> left_out;
    if (keyword.has("GENERATE")) return read_generated(numbers_of_part ? set : left_out);
    while (at_values()) {
      while (!in_->at_line_end()) {
        const std::string_view word = in_->peek_word();
        const std::size_t behind = word.rfind('.') + 1;  // "instance.member"
        const bool of_instance = in_assembly_ && behind > 0 && behind < word.size() && !is_digit(word[0]);
        if (of_instance) in_->seek(in_->offset() + behind);
        if (is_digit(word[of_instance ? behind : 0])) {
          const auto number = in_->number_on_line<std::int64_t>("a member of a set");
          if (numbers_of_part || of_instance) set.push_back({number, number, 1});
        } else {
          add_set(set, of, std::string(in_->word("a set")));
        }
      }
      in_->line();
    }
  }

  void add_set(std::vector<FemRange>& set, Of of, const std::string& name) {
    const std::vector<FemRange>* other =
        in_assembly_ ? mesh_.find(of, known_name(of, trimmed(name) + kOfAssembly)) : nullptr;
    if (!other) other = mesh_.find(of, known_name(of, trimmed(name)));
    if (!other || other == &set)
      in_->fail("names " + in_quotes(name), "expected a number or the name of an earlier set");
    set.insert(set.end(), other->begin(), other->end());
    members_ += other->size();
    if (members_ > 4 * in_->data().size())  // sets of sets can double with every line
      in_->fail("sets of sets have " + std::to_string(members_) + " members", "expected no more than four a byte");
  }

  void read_generated(std::vector<FemRange>& set) {
    while (at_values()) {
      FemRange range{0, 0, 1};
      range.first = in_->number_on_line<std::int64_t>("the first member");
      range.last = in_->number_on_line<std::int64_t>("the last member");
      if (!in_->at_line_end()) range.step = in_->number_on_line<std::int64_t>("the step");
      if (range.step < 1) in_->fail("step is " + std::to_string(range.step), "expected 1 or more");
      if (range.last < range.first)
        in_->fail("goes from " + std::to_string(range.first) + " to " + std::to_string(range.last), "expected upward");
      set.push_back(range);
      in_->end_line("the step");
    }
  }

  /// The placement of a part: a line with a translation, then one with two points of an axis and an angle [degrees].
  void read_instance() {
    if (++instances_ > 1)
      in_->fail("is the second instance", "expected one: export the parts as one, or each in a file of its own");
    if (!at_values()) return;
    Eigen::Vector3d shift, from, to;
    for (int k = 0; k < 3; ++k) shift[k] = in_->coordinate_on_line("a translation");
    in_->end_line("the translation");
    placement_.translation() = shift;
    if (!at_values()) return;
    for (int k = 0; k < 3; ++k) from[k] = in_->coordinate_on_line("a point of the axis");
    for (int k = 0; k < 3; ++k) to[k] = in_->coordinate_on_line("a point of the axis");
    const double angle = in_->coordinate_on_line("the angle") * std::numbers::pi / 180;
    in_->end_line("the angle");
    const Eigen::Vector3d axis = to - from;
    if (!(axis.norm() > 0)) in_->fail("the axis of the rotation has no length", "expected two points");
    const Eigen::Translation3d origin(from);
    placement_ = origin * Eigen::AngleAxisd(angle, axis.normalized()) * origin.inverse() * Eigen::Translation3d(shift);
  }

  void place() {
    if (placement_.matrix().isIdentity(0)) return;
    for (Eigen::Vector3d& x : file_.mesh.positions) {
      x = placement_ * x;
      if (!x.allFinite()) in_->fail("a node of the instance is not finite", "expected a finite placement");
    }
  }

  /// Names are the same in upper and lower case; the first spelling is kept.
  std::string known_name(Of of, const std::string& name) {
    return spelled_.try_emplace({of, upper_case(name)}, name).first->second;
  }
  std::vector<FemRange>& set_of(Of of, const std::string& name) {
    const bool taken = in_assembly_ && of_part_.contains(upper_case(name));
    return mesh_.set(*in_, of, known_name(of, taken ? name + kOfAssembly : name));
  }

  void add_block(const std::string& name) {
    if (std::find(blocks_.begin(), blocks_.end(), name) == blocks_.end()) blocks_.push_back(name);
  }

  void name_regions() {
    int region = 0;
    for (const std::string& name : sections_.empty() ? blocks_ : sections_) {
      file_.mesh.region_names[++region] = name;
      mesh_.set_region(name, region);
    }
  }

  Scanner* in_;  // of the file that is read: this one, or one that it includes
  MeshFile& file_;
  FemMesh mesh_;
  IncludedFiles included_;
  std::map<std::pair<Of, std::string>, std::string> spelled_;
  std::vector<std::string> sections_, blocks_;  // names of element sets: of solid sections, of *ELEMENT
  Eigen::Affine3d placement_ = Eigen::Affine3d::Identity();
  std::set<std::string> of_part_;                 // names of sets, in upper case
  bool in_assembly_ = false, own_nodes_ = false;  // nodes of the assembly itself
  int parts_ = 0, instances_ = 0;
  std::size_t members_ = 0;  // that sets have from other sets
};

}  // namespace

void read_abaqus(Scanner& in, MeshFile& file, const ReadBeside& read_beside) {
  AbaqusReader(in, file, read_beside).read();
}

}  // namespace fascia
