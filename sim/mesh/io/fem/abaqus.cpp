// Abaqus and CalculiX .inp: keyword lines that begin with '*', then lines of values with commas. Nodes, elements, sets
// and solid sections are read; the sections' sets of elements are the regions, or else the sets that *ELEMENT names.
// Every *INSTANCE places a part: a file of several is read once for each of them, without the parts and sets of the
// others, and the results are merged. Files that *INCLUDE or INPUT= names are read in their place.
#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "sim/mesh/io/fem/abaqus_lines.h"
#include "sim/mesh/io/fem/abaqus_outline.h"
#include "sim/mesh/io/fem/included_files.h"
#include "sim/mesh/io/fem/merged_mesh.h"

namespace fascia {
namespace {

constexpr const char* kOfAssembly = " (assembly)";  // behind the name of a set whose name a set of the part has

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

class AbaqusReader {
 public:
  AbaqusReader(Scanner& in, MeshFile& file, const ReadBeside& read_beside)
      : in_(&in), file_(file), mesh_(file), included_(in.where(), read_beside) {}

  /// Only what belongs to this instance. `several`: all sets of the assembly have kOfAssembly behind their names.
  void read_instance(const AbaqusInstance& instance, bool several) {
    instance_ = &instance;
    several_ = several;
    read();
  }

  void read() {
    read_keywords();
    in_->set_section("");
    if (file_.mesh.positions.empty())
      in_->fail(instance_ ? "instance " + in_quotes(instance_->name) + " has no nodes" : "has no nodes",
                "expected *NODE");
    name_regions();
    if (own_nodes_)
      file_.notes.push_back("Nodes of the assembly, which belong to no part, and sets of them are left out.");
    note_joints();
    note_cut_off(*in_, file_);
    place();
    mesh_.build();
  }

 private:
  using Of = FemMesh::Of;

  bool at_keyword() const { return at_abaqus_keyword(*in_); }

  void read_keywords() {
    while (in_->remaining() > 0) {
      if (!at_keyword()) {
        in_->line();  // values of a keyword that is passed over, blank lines, comments
        continue;
      }
      read_keyword(take_keyword(*in_));
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
      if (!at_abaqus_comment(*in_) && !in_->at_line_end()) return true;
      in_->line();
    }
    return false;
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
    if (keyword.name == "PART") return begin_part(keyword);
    if (keyword.name == "INSTANCE") return begin_instance(keyword);
    if (keyword.name == "END INSTANCE") return end_instance();
    constexpr std::array kJoints = {"TIE", "MPC", "EQUATION", "COUPLING", "EMBEDDED ELEMENT"};
    if (std::find(kJoints.begin(), kJoints.end(), keyword.name) != kJoints.end()) joints_.insert("*" + keyword.name);
  }

  void note_joints() {
    std::string text;
    for (const std::string& name : joints_) text += (text.empty() ? "" : ", ") + name;
    if (!text.empty())
      file_.notes.push_back("Constraints are left out, so that what they join moves apart: " + text + ".");
  }

  void begin_assembly(bool begins) {
    in_assembly_ = begins && parts_ > 0;
    for (const auto& [key, name] : spelled_) of_part_.insert(key.second);
  }

  static bool same_name(const std::string& a, const std::string& b) { return upper_case(a) == upper_case(b); }

  void skip_to(const char* end) {
    while (in_->remaining() > 0) {
      if (at_keyword() && take_keyword(*in_).name == end) return;
      if (!at_keyword()) in_->line();
    }
  }

  void begin_part(const Keyword& keyword) {
    ++parts_;
    if (!instance_) return;
    if (!same_name(keyword.value("NAME"), instance_->part)) return skip_to("END PART");
    found_part_ = true;
  }

  void begin_instance(const Keyword& keyword) {
    if (instance_) {
      if (!same_name(keyword.value("NAME"), instance_->name)) return skip_to("END INSTANCE");
      if (!found_part_) in_->fail("names part " + in_quotes(instance_->part), "expected an earlier *PART");
    }
    read_placement();
    in_instance_ = true;
    // The mesh of an independent instance stands here instead of in its part.
    is_independent_ = file_.mesh.positions.empty();
    if (is_independent_) in_assembly_ = false;
  }

  void end_instance() {
    if (is_independent_) begin_assembly(true);
    in_instance_ = is_independent_ = false;
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
    if (of == Of::nodes && keyword.has("ELSET")) {  // of the nodes of these elements, which the group of a set has
      std::vector<FemRange>& elements = set_of(Of::elements, name);
      if (is_of_other(keyword.value("INSTANCE"))) return;
      return add_set(elements, Of::elements, keyword.value("ELSET"), false);
    }
    const bool numbers_of_part = !in_assembly_ || in_instance_ || keyword.has("INSTANCE") || !(own_nodes_ || several_);
    std::vector<FemRange>& set = set_of(of, name);
    if (is_of_other(keyword.value("INSTANCE"))) return;
    std::vector<FemRange> left_out;
    if (keyword.has("GENERATE")) return read_generated(numbers_of_part ? set : left_out);
    while (at_values()) {
      while (!in_->at_line_end()) {
        const std::string_view word = in_->peek_word();
        const std::size_t behind = word.rfind('.') + 1;  // "instance.member"
        const bool of_instance = in_assembly_ && behind > 0 && behind < word.size() && !is_digit(word[0]);
        if (of_instance && is_of_other(std::string(word.substr(0, behind - 1)))) {
          in_->word("a member of a set");
          continue;
        }
        if (of_instance) in_->seek(in_->offset() + behind);
        if (is_digit(word[of_instance ? behind : 0])) {
          const auto number = in_->number_on_line<std::int64_t>("a member of a set");
          if (numbers_of_part || of_instance) set.push_back({number, number, 1});
        } else {
          add_set(set, of, std::string(in_->word("a set")), of_instance);
        }
      }
      in_->line();
    }
  }

  /// In files of several instances the parts and sets of the others are left out; empty: of no instance.
  bool is_of_other(const std::string& instance) const {
    return instance_ && !instance.empty() && !same_name(instance, instance_->name);
  }

  void add_set(std::vector<FemRange>& set, Of of, const std::string& name, bool of_instance) {
    const std::vector<FemRange>* other =
        in_assembly_ && !of_instance ? mesh_.find(of, known_name(of, trimmed(name) + kOfAssembly)) : nullptr;
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
  void read_placement() {
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
    const bool taken = in_assembly_ && (several_ || of_part_.contains(upper_case(name)));
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
  std::set<std::string> joints_;                  // keywords that join what the mesh does not
  bool in_assembly_ = false, own_nodes_ = false;  // nodes of the assembly itself
  bool in_instance_ = false, is_independent_ = false, found_part_ = false, several_ = false;
  const AbaqusInstance* instance_ = nullptr;  // null: the file has no more than one part and one instance
  int parts_ = 0;
  std::size_t members_ = 0;  // that sets have from other sets
};

void note_skipped(MeshFile& file, const std::vector<std::string>& names) {
  constexpr std::size_t kMostNames = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNames); ++i) text += (i == 0 ? " " : ", ") + names[i];
  if (names.size() > kMostNames) text += " and " + std::to_string(names.size() - kMostNames) + " more";
  if (!names.empty()) file.notes.push_back("Instances without solid elements left out:" + text + ".");
}

/// Instances of solids, or, if there are none, of surfaces.
void read_instances(const Scanner& in, MeshFile& file, const std::vector<AbaqusInstance>& instances,
                    const ReadBeside& read_beside) {
  std::vector<MeshFile> parts(instances.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Scanner again = in;
    AbaqusReader(again, parts[i], read_beside).read_instance(instances[i], instances.size() > 1);
  }
  const bool solid =
      std::any_of(parts.begin(), parts.end(), [](const MeshFile& part) { return !part.mesh.tets.empty(); });
  std::vector<std::string> skipped;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    check_vertex_count(in, file.mesh.positions.size() + parts[i].mesh.positions.size());
    if (solid && parts[i].mesh.tets.empty())
      skipped.push_back(instances[i].name);
    else if (parts.size() == 1)
      file = std::move(parts[i]);
    else
      merge_mesh(file, parts[i], instances[i].name, kOfAssembly);
    parts[i] = {};
  }
  note_skipped(file, skipped);
}

}  // namespace

void read_abaqus(Scanner& in, MeshFile& file, const ReadBeside& read_beside) {
  in.skip_commas();
  const AbaqusOutline outline = abaqus_outline(in, read_beside);
  if (outline.parts <= 1 && outline.instances.size() <= 1) {
    AbaqusReader(in, file, read_beside).read();
  } else if (outline.instances.empty()) {
    in.fail("has " + std::to_string(outline.parts) + " parts and no *INSTANCE", "expected one for each part to read");
  } else {
    read_instances(in, file, outline.instances, read_beside);
  }
  file.format = "Abaqus";
  finish_mesh(file, in.where());
}

}  // namespace fascia
