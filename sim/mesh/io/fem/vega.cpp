// Vega .veg (Sin, Schroeder, Barbic 2013): sections *VERTICES, *ELEMENTS, *SET, *REGION, with '#' before comments; a
// section, or a part of one, may be in another file that *INCLUDE names. Regions are those of *REGION, named after
// their sets of elements.
#include <algorithm>
#include <limits>

#include "base/error.h"
#include "sim/mesh/io/fem/fem_mesh.h"
#include "sim/mesh/io/fem/included_files.h"

namespace fascia {
namespace {

class VegaReader {
 public:
  VegaReader(Scanner& in, MeshFile& file, const ReadBeside& read_beside)
      : root_(in), file_(file), mesh_(file), included_(in.where(), read_beside) {}

  void read() {
    file_.format = "Vega";
    prepare(root_);
    read_sections(root_);
    if (!has_vertices_) root_.fail("has no vertices", "expected *VERTICES");
    note_cut_off(root_, file_);
    for (const auto& [set, material] : regions_) {
      file_.mesh.region_names[++region_] = set;
      if (set == kAll && !mesh_.find(Of::elements, kAll)) mesh_.set(root_, Of::elements, kAll).push_back(kEvery);
      mesh_.set_region(set, region_);
    }
    mesh_.finish(root_.where());
  }

 private:
  using Of = FemMesh::Of;
  static constexpr const char* kAll = "allElements";  // a set that needs no definition
  static constexpr FemRange kEvery = {std::numeric_limits<std::int64_t>::min(),
                                      std::numeric_limits<std::int64_t>::max(), 1};

  static void prepare(Scanner& in) {
    in.skip_comments();
    in.skip_commas();
  }

  /// The file of an *INCLUDE line.
  Scanner& include(Scanner& in) {
    const std::string_view line = in.line();
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string name(line.substr(begin, line.find_last_not_of(" \t") + 1 - begin));
    Scanner& other = included_.open(in, name);
    prepare(other);
    return other;
  }

  void read_sections(Scanner& in) {
    while (!in.at_end()) {
      in.set_section("");
      const std::string keyword(in.word("a section"));
      if (!keyword.starts_with('*')) in.fail("found " + in_quotes(keyword), "expected a section such as *VERTICES");
      if (keyword == "*INCLUDE") {
        read_sections(include(in));
        continue;
      }
      in.set_section(keyword);
      if (keyword == "*VERTICES") {
        read_body(in, [&](Scanner& body) { read_vertices(body); });
      } else if (keyword == "*ELEMENTS") {
        const std::string kind(in.word("the kind of elements"));
        read_body(in, [&](Scanner& body) { read_elements(body, kind); });
      } else if (keyword == "*SET") {
        const std::string name(in.word("the name of a set"));
        read_body(in, [&](Scanner& body) { read_set(body, name); });
      } else if (keyword == "*REGION") {
        const std::string set(in.word("a set"));
        regions_.emplace_back(set, in.word("a material"));
      } else {
        skip_section(in);  // *MATERIAL
      }
    }
  }

  /// The lines of a section, here or in the file that it includes.
  template <class Read>
  void read_body(Scanner& in, Read read) {
    if (!in.take("*INCLUDE")) return read(in);
    Scanner& other = include(in);
    read(other);
    if (!other.at_end()) other.fail("something follows the list", "expected the end of the file");
  }

  static void skip_section(Scanner& in) {
    in.line();
    while (!in.at_end() && !in.peek_word().starts_with('*')) in.line();
  }

  void read_vertices(Scanner& in) {
    if (has_vertices_) in.fail("is the second list of vertices", "expected one");
    has_vertices_ = true;
    const std::size_t count = in.count("vertices", 8);
    const int dimension = in.number_on_line<int>("the dimension");
    if (dimension != 3) in.fail("dimension is " + std::to_string(dimension), "expected 3");
    in.line();  // numbers of attributes and markers
    for (std::size_t v = 0; v < count; ++v) {
      const auto number = in.number<std::int64_t>("a vertex number");
      Eigen::Vector3d x;
      for (int k = 0; k < 3; ++k) x[k] = in.coordinate_on_line("a vertex coordinate");
      mesh_.add_node(in, number, x);
      in.line();
    }
  }

  void read_elements(Scanner& in, const std::string& kind_name) {
    const bool cubes = kind_name == "CUBIC";
    if (!cubes && kind_name != "TET" && kind_name != "TETS")
      in.fail("the kind of elements is " + in_quotes(kind_name), "expected TET or CUBIC");
    const std::size_t count = in.count("elements", 10);
    const auto nodes_each = in.number_on_line<unsigned>("the number of vertices of an element");
    const FemElement kind{3, cubes ? 8u : 4u, nodes_each};
    if (nodes_each != kind.corners && (cubes || nodes_each != 10))
      in.fail("an element has " + std::to_string(nodes_each) + " vertices", cubes ? "expected 8" : "expected 4");
    in.line();  // number of attributes
    std::vector<std::int64_t> nodes(kind.nodes);
    for (std::size_t e = 0; e < count; ++e) {
      const auto number = in.number<std::int64_t>("an element number");
      for (std::int64_t& node : nodes) node = in.number_on_line<std::int64_t>("a vertex of an element");
      mesh_.add_element(in, kind, number, nodes, 0);
      in.line();
    }
  }

  void read_set(Scanner& in, const std::string& name) {
    std::vector<FemRange>& set = mesh_.set(in, Of::elements, name);
    while (!in.at_end() && !in.peek_word().starts_with('*')) {
      const auto number = in.number<std::int64_t>("a member of a set");
      set.push_back({number, number, 1});
    }
  }

  Scanner& root_;
  MeshFile& file_;
  FemMesh mesh_;
  IncludedFiles included_;
  std::vector<std::pair<std::string, std::string>> regions_;  // set and material
  int region_ = 0;
  bool has_vertices_ = false;
};

}  // namespace

void read_vega(Scanner& in, MeshFile& file, const ReadBeside& read_beside) { VegaReader(in, file, read_beside).read(); }

}  // namespace fascia
