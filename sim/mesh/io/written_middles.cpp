#include "sim/mesh/io/written_middles.h"

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "base/suggest.h"
#include "base/text.h"
#include "sim/mesh/io/formats.h"
#include "sim/mesh/io/mesh_formats.h"
#include "sim/mesh/mesh_check.h"
#include "sim/mesh/mid_order.h"

namespace fascia {
namespace {

void put_in_order(MeshFile& file) {
  std::vector<MidEdges> ordered = file.mid_edges;
  try {
    const std::size_t tets = order_mid_edges(file.mesh, repair(file.mesh).source, ordered, "");
    if (tets == 0) return;
    file.mid_edges = ordered;
    file.notes.push_back("Middle vertices of " + plural(tets, "quadratic tet") +
                         " are not in the order of the format they were read from: put in order by their places.");
  } catch (const Error&) {  // what no body takes may still be converted
    file.notes.push_back("Middle vertices that are at no middle of an edge: written in the order of the file.");
  }
}

}  // namespace

void keep_written_middles(MeshFile& file, const std::filesystem::path& out) {
  const bool had_note = std::erase(file.notes, kHigherOrderNote) > 0;
  const auto quadratic = static_cast<std::size_t>(
      std::count_if(file.mid_edges.begin(), file.mid_edges.end(), [](const MidEdges& m) { return m != kNoMidEdges; }));
  const std::vector<std::string> endings = ten_node_endings();
  const std::string ending = lower_ending(out);
  if (quadratic == 0) {
    if (had_note) file.notes.push_back("Cells of higher order: kept the corners of each.");
  } else if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
    file.notes.push_back(plural(quadratic, "quadratic tet") + " written with the corners alone, and the middle " +
                         "vertices in no tet: fascia writes " + ending + " with tets of four nodes, and " +
                         join(endings) + " with tets of ten.");
  } else {
    put_in_order(file);
    file.mesh.mid_edges = file.mid_edges;
    file.mesh.mid_edges.resize(file.mesh.tets.size(), kNoMidEdges);
    if (had_note && file.split.tets > 0)
      file.notes.push_back("Hexahedra, wedges and pyramids of higher order: kept the corners of each.");
  }
}

}  // namespace fascia
