#include "sim/model/model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_check.h"
#include "sim/mesh/mid_edges.h"
#include "sim/mesh/vertex_check.h"
#include "sim/model/file_reader.h"
#include "sim/model/prescribed_motion.h"
#include "sim/model/region_materials.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/model/vertex_csv.h"
#include "sim/model/vertex_selection.h"
#include "sim/surface/surface_fill.h"
#include "sim/tool/tool_meshes.h"

namespace fascia {
namespace {

using Eigen::Vector3d;

/// Distance of a surface from its tets, in edges of a tet, above which a note is added: a filled surface always
/// deviates a little between its vertices.
constexpr double kNotedDistance = 0.4;

/// One body while it is loaded.
struct LoadedBody {
  FileReader& files;
  const Body& body;
  std::string key, where;  // "bodies[0]", "scene.json: bodies[0]"
  std::string set;         // the start of keys of --set: "", or "bodies.0." where there are several
  MeshFile file;
  SurfaceMesh surface;  // drawn instead of the boundary, if it has triangles
  MeshRepair repaired;
  std::vector<char> used;  // [vertex_count] 1 if a usable tet has the vertex

  bool is_quadratic() const { return body.elements == ElementOrder::quadratic; }
};

LoadedBody begin_body(const Scene& scene, std::size_t index, FileReader& files) {
  const std::string key = "bodies[" + std::to_string(index) + "]";
  const std::string set = scene.bodies.size() > 1 ? "bodies." + std::to_string(index) + '.' : "";
  return {files, scene.bodies[index], key, scene.file.string() + ": " + key, set, {}, {}, {}, {}};
}

/// `mesh_name`: the name of the mesh in errors.
void repair_body(LoadedBody& loaded, const std::string& mesh_name) {
  require_range(loaded.file.mesh.positions, mesh_name);
  loaded.repaired = repair(loaded.file.mesh);
  if (loaded.repaired.tets.empty()) {
    throw Error(mesh_name,
                "has no tet higher than 1e-7 of its longest edge (" +
                    std::to_string(loaded.repaired.degenerate.size()) + " degenerate)",
                "expected at least one");
  }
  loaded.used = used_vertices(loaded.repaired.tets, loaded.file.mesh.positions.size());
  if (loaded.is_quadratic())
    for (const std::uint32_t v : keep_mid_edges(loaded.file, loaded.repaired.source, mesh_name)) loaded.used[v] = 1;
}

LoadedBody load(const Scene& scene, std::size_t index, FileReader& files, const Progress& progress) {
  LoadedBody loaded = begin_body(scene, index, files);
  const Body& body = loaded.body;
  const std::string& key = loaded.key;
  FileReader::File mesh = files.read(body.mesh, key + ".mesh", part_of(progress, 0, 0.1));
  ShapeFile shape = files.shape(mesh);
  mesh.content = std::string();
  const std::string path = mesh.place.string();
  if (shape.surface) {
    FilledSurface filled = files.blaming(mesh, [&] {
      return fill_surface(std::move(*shape.surface), path, body.resolution, part_of(progress, 0.1, 0.9));
    });
    loaded.file = std::move(filled.file);
    loaded.surface = std::move(filled.surface);
  } else {
    if (body.resolution)
      throw Error(loaded.where + ".resolution", "is given for a mesh of tets, which it does not change",
                  "expected it only beside a surface");
    loaded.file = std::move(shape.tets);
  }
  if (!body.surface.empty()) {
    loaded.surface = files.surface(files.read(body.surface, key + ".surface", part_of(progress, 0.9, 0.95)));
    put_right(loaded.surface, repair(loaded.surface, part_of(progress, 0.95, 1)));
    loaded.file.notes.insert(loaded.file.notes.end(), loaded.surface.notes.begin(), loaded.surface.notes.end());
  }
  files.blaming(mesh, [&] { repair_body(loaded, path); });
  return loaded;
}

void note_tets(const std::string& body, const std::vector<std::uint32_t>& tets, const std::string& what,
               std::vector<std::string>& notes) {
  if (tets.empty()) return;
  const bool is_one = tets.size() == 1;
  notes.push_back(body + ": " + std::to_string(tets.size()) + (is_one ? " tet " : " tets ") + what +
                  (is_one ? " (tet " : " (first: tet ") + std::to_string(tets.front()) + ")");
}

void add_notes(const LoadedBody& loaded, std::vector<std::string>& notes) {
  const std::string& name = loaded.body.name;
  for (const std::string& note : loaded.file.notes) notes.push_back(name + ": " + note);
  note_tets(name, loaded.repaired.flipped, "flipped in the file, reoriented", notes);
  note_tets(name, loaded.repaired.degenerate, "degenerate, left out of the physics", notes);
  note_tets(name, loaded.repaired.duplicated, "duplicated, left out of the physics", notes);
  if (const auto unused = std::count(loaded.used.begin(), loaded.used.end(), 0); unused > 0) {
    notes.push_back(name + ": " + std::to_string(unused) + (unused == 1 ? " vertex" : " vertices") +
                    " in no tet, kept in exports");
  }
  if (const std::vector<std::uint32_t> far = far_vertices(loaded.file.mesh); !far.empty())
    notes.push_back(name + ": " + std::to_string(far.size()) + (far.size() == 1 ? " vertex" : " vertices") +
                    " far from all others (vertex " + std::to_string(far.front()) + " at " +
                    point(loaded.file.mesh.positions[far.front()]) + ")");
  if (const std::size_t count = count_coincident(loaded.file.mesh.positions, loaded.repaired.tets); count > 0)
    notes.push_back(name + ": " + std::to_string(count) + (count == 1 ? " vertex" : " vertices") +
                    " at the place of an earlier one, not joined: fascia convert --weld makes them one");
}

// A region whose tets all belong to another one by the scene stays known: its material remains a valid entry.
void add_regions(const Model& model, LoadedBody& loaded, BodyPart& part) {
  part.regions = regions_of(loaded.file.mesh);
  assign_regions(loaded.body, model.file_mesh.region_names, loaded.where, loaded.file.mesh);
  for (const auto& region : regions_of(loaded.file.mesh))
    if (part.regions.insert(region).second) part.added_regions.insert(region.first);
}

void add_materials(const LoadedBody& loaded, Model& model, BodyPart& part) {
  const BodyMaterials resolved = resolve_materials(loaded.body, part.regions, loaded.where);
  part.material_begin = static_cast<std::uint32_t>(model.materials.size());
  part.material_count = static_cast<std::uint32_t>(resolved.materials.size());
  std::vector<char> in_use(resolved.materials.size(), 0);
  for (const std::uint32_t source : loaded.repaired.source) {
    const std::uint32_t material = resolved.material_of(loaded.file.mesh.regions[source]);
    in_use[material] = 1;
    model.tet_material.push_back(part.material_begin + material);
  }
  for (std::size_t m = 0; m < resolved.materials.size(); ++m) {
    const double ratio = resolved.materials[m].poisson_ratio;
    if (!in_use[m] || ratio <= kLockingPoissonRatio || loaded.is_quadratic()) continue;
    std::string text = std::to_string(ratio);
    text.erase(text.find_last_not_of('0') + 1);
    model.notes.push_back(resolved.names[m] + ": Poisson's ratio " + text +
                          "; linear tets lock above 0.45: expect too little motion on a coarse mesh, or use --set " +
                          loaded.set + "elements=quadratic");
  }
  model.materials.insert(model.materials.end(), resolved.materials.begin(), resolved.materials.end());
  model.material_names.insert(model.material_names.end(), resolved.names.begin(), resolved.names.end());
}

/// Appends the body's motions and fixed vertices in the model's numbering; [vertex_count] 1 where constrained.
std::vector<char> add_constraints(const LoadedBody& loaded, std::uint32_t vertex_begin, Model& model) {
  const TetMesh& mesh = loaded.file.mesh;
  const SelectableMesh selectable{mesh, loaded.repaired.tets, loaded.body.up, loaded.file.mid_edges};
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> motion_of(mesh.positions.size(), kNone);
  for (std::size_t m = 0; m < loaded.body.prescribed.size(); ++m) {
    const std::string element = ".prescribed[" + std::to_string(m) + "]", where = loaded.where + element;
    Motion motion = resolve_motion(loaded.body.prescribed[m], loaded.files, selectable, where, loaded.key + element);
    for (std::uint32_t& vertex : motion.vertices) {
      if (motion_of[vertex] != kNone) {
        throw Error(where,
                    "moves vertex " + std::to_string(vertex) + ", as prescribed[" + std::to_string(motion_of[vertex]) +
                        "] does",
                    "expected each vertex in one motion");
      }
      motion_of[vertex] = m;
      vertex += vertex_begin;
    }
    model.motions.push_back(std::move(motion));
  }
  std::vector<char> held(mesh.positions.size(), 0);
  for (std::size_t s = 0; s < loaded.body.fixed.size(); ++s) {
    const std::string where = loaded.where + ".fixed[" + std::to_string(s) + "]";
    for (const std::uint32_t vertex : select_vertices(loaded.body.fixed[s], selectable, where)) held[vertex] = 1;
  }
  for (std::uint32_t v = 0; v < held.size(); ++v) {
    const bool is_moved = motion_of[v] != kNone;
    if (held[v] && !is_moved) model.fixed.push_back(vertex_begin + v);
    held[v] = held[v] || is_moved;
  }
  return held;
}

void add_velocity(const LoadedBody& loaded, const std::vector<char>& held, Model& model) {
  std::vector<Vector3d> velocity;
  if (const auto* path = std::get_if<std::string>(&loaded.body.initial_velocity)) {
    const FileReader::File file = loaded.files.read(*path, loaded.key + ".initial_velocity");
    velocity =
        loaded.files.blaming(file, [&] { return read_complete_vertex_csv(file.place, file.content, held.size()); });
  } else {
    velocity.assign(held.size(), std::get<Vector3d>(loaded.body.initial_velocity));
  }
  for (std::size_t v = 0; v < held.size(); ++v) {
    if (held[v]) velocity[v].setZero();
  }
  model.initial_velocity.insert(model.initial_velocity.end(), velocity.begin(), velocity.end());
}

/// Makes the usable tets of the body quadratic, whose constraints and velocities the model already has: those of a
/// mid-edge vertex follow from the two ends of its edge, and its velocity is that of the file where it has one.
void add_middles(LoadedBody& loaded, std::uint32_t vertex_begin, Model& model) {
  constexpr int kFree = -2, kFixed = -1;  // else an index into Model::motions
  TetMesh& mesh = loaded.file.mesh;
  const std::size_t in_file = mesh.positions.size();
  add_mid_edges(mesh, loaded.repaired.source, loaded.file.mid_edges);
  const std::vector<MidEdge> middles = mid_edges_of(mesh);
  std::set<std::uint32_t> selected;  // by the file's vertices, where it has those in the middles
  for (const MidEdge& edge : middles) selected.insert(vertex_begin + edge.vertex);
  std::erase_if(model.fixed, [&](std::uint32_t v) { return selected.contains(v); });
  for (Motion& motion : model.motions) leave_out(selected, motion);
  std::vector<int> holder(mesh.positions.size(), kFree);
  std::vector<std::size_t> place(mesh.positions.size(), 0);  // in the motion
  for (const std::uint32_t v : model.fixed)
    if (v >= vertex_begin) holder[v - vertex_begin] = kFixed;
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    for (std::size_t k = 0; k < model.motions[m].vertices.size(); ++k) {
      const std::uint32_t v = model.motions[m].vertices[k];
      if (v < vertex_begin) continue;
      holder[v - vertex_begin] = static_cast<int>(m);
      place[v - vertex_begin] = k;
    }
  model.initial_velocity.resize(vertex_begin + mesh.positions.size(), Vector3d::Zero());
  const auto velocity = model.initial_velocity.begin() + vertex_begin;
  for (const MidEdge& edge : middles) {
    const bool free = holder[edge.a] == kFree || holder[edge.a] != holder[edge.b];
    if (!free) velocity[edge.vertex].setZero();
    if (free) {
      if (edge.vertex >= in_file) velocity[edge.vertex] = 0.5 * (velocity[edge.a] + velocity[edge.b]);
    } else if (holder[edge.a] == kFixed) {
      model.fixed.push_back(vertex_begin + edge.vertex);
    } else {
      Motion& motion = model.motions[static_cast<std::size_t>(holder[edge.a])];
      motion.vertices.push_back(vertex_begin + edge.vertex);
      if (!motion.targets.empty())
        motion.targets.push_back(0.5 * (motion.targets[place[edge.a]] + motion.targets[place[edge.b]]));
    }
  }
  std::sort(model.fixed.begin(), model.fixed.end());
}

template <std::size_t n>
std::array<std::uint32_t, n> shifted(std::array<std::uint32_t, n> vertices, std::uint32_t by) {
  for (std::uint32_t& vertex : vertices)
    if (vertex != kNoVertex) vertex += by;
  return vertices;
}

/// Appends the placed mesh to the arrays of the model and of its file_mesh.
void add_mesh(const LoadedBody& loaded, const BodyPart& part, Model& model) {
  const TetMesh& mesh = loaded.file.mesh;
  TetMesh& all = model.file_mesh;
  const Eigen::Affine3d place = placement(loaded.body);
  const auto first_tet = static_cast<std::uint32_t>(all.tets.size());
  for (const Vector3d& position : mesh.positions) all.positions.push_back(place * position);
  for (const Tet& tet : mesh.tets) all.tets.push_back(shifted(tet, part.vertex_begin));
  all.regions.insert(all.regions.end(), mesh.regions.begin(), mesh.regions.end());
  all.region_names.insert(mesh.region_names.begin(), mesh.region_names.end());
  for (const auto& [name, vertices] : mesh.groups) {
    for (const std::uint32_t vertex : vertices) all.groups[name].push_back(part.vertex_begin + vertex);
  }
  for (const Tet& tet : loaded.repaired.tets) model.tets.push_back(shifted(tet, part.vertex_begin));
  for (const std::uint32_t source : loaded.repaired.source) model.tet_source.push_back(first_tet + source);
  if (mesh.mid_edges.empty()) return;
  all.mid_edges.resize(first_tet, kNoMidEdges);  // of the linear bodies before this one
  for (const MidEdges& middles : mesh.mid_edges) all.mid_edges.push_back(shifted(middles, part.vertex_begin));
  model.mid_edges.resize(part.tet_begin, kNoMidEdges);
  for (std::size_t t = part.tet_begin; t < model.tets.size(); ++t) {
    const std::uint32_t source = model.tet_source[t];
    model.mid_edges.push_back(reordered(all.mid_edges[source], all.tets[source], model.tets[t]));
  }
}

/// Gives the linear tets after the last quadratic one their entries.
void complete_mid_edges(Model& model) {
  if (!model.has_quadratic()) return;
  model.mid_edges.resize(model.tets.size(), kNoMidEdges);
  model.file_mesh.mid_edges.resize(model.file_mesh.tets.size(), kNoMidEdges);
}

/// Embeds the body's surface in its tets, which are the last ones of the model.
void add_surface(LoadedBody loaded, const BodyPart& part, Model& model) {
  SurfaceMesh& surface = model.surfaces.emplace_back(std::move(loaded.surface));
  if (surface.triangles.empty()) return;
  const Eigen::Affine3d place = placement(loaded.body);
  for (Vector3d& p : surface.positions) p = place * p;
  std::vector<MidEdges> mid_edges;
  if (loaded.is_quadratic()) mid_edges.assign(model.mid_edges.begin() + part.tet_begin, model.mid_edges.end());
  const EmbeddedPoints own = embed(surface.positions, model.file_mesh.positions,
                                   {model.tets.begin() + part.tet_begin, model.tets.end()}, mid_edges);
  append(model.embedded, own);
  double volume = 0;
  for (auto tet = model.tets.begin() + part.tet_begin; tet != model.tets.end(); ++tet) {
    const auto& x = model.file_mesh.positions;
    volume += signed_volume6(x[(*tet)[0]], x[(*tet)[1]], x[(*tet)[2]], x[(*tet)[3]]) / 6;
  }
  const double size = std::cbrt(6 * std::sqrt(2.0) * volume / part.tet_count);  // edge of a regular tet
  if (own.outside > 0 && own.farthest > kNotedDistance * size)
    model.notes.push_back(part.name + ": " + std::to_string(own.outside) + " of " + std::to_string(own.points.size()) +
                          " vertices of the surface outside of the tets, at most " + length(own.farthest) +
                          " away: tied to the nearest tet");
}

/// float32 holds the masses and forces of a body's elements only where its size is between these; measured with meshes
/// of 500 to 100,000 tets.
constexpr double kSmallestBody = 1e-7, kLargestBody = 1e9;  // [m]

void require_size(const LoadedBody& loaded) {
  const Eigen::Affine3d place = placement(loaded.body);
  Eigen::AlignedBox3d box;
  for (const Tet& tet : loaded.repaired.tets)
    for (const std::uint32_t v : tet) box.extend(place * loaded.file.mesh.positions[v]);
  const double size = box.sizes().maxCoeff();
  if (size >= kSmallestBody && size <= kLargestBody) return;
  throw Error(loaded.where + ".mesh", loaded.body.name + " is " + number(size) + " m wide with its unit and transform",
              "expected " + number(kSmallestBody) + " to " + number(kLargestBody) +
                  " m: unit or transform.scale give the mesh another size");
}

void add_body(LoadedBody loaded, Model& model) {
  require_size(loaded);
  BodyPart part;
  part.name = loaded.body.name;
  part.vertex_begin = static_cast<std::uint32_t>(model.file_mesh.positions.size());
  part.tet_begin = static_cast<std::uint32_t>(model.tets.size());
  part.tet_count = static_cast<std::uint32_t>(loaded.repaired.tets.size());
  part.filled = loaded.file.filled;
  add_notes(loaded, model.notes);
  add_regions(model, loaded, part);
  add_materials(loaded, model, part);
  add_velocity(loaded, add_constraints(loaded, part.vertex_begin, model), model);
  if (loaded.is_quadratic()) add_middles(loaded, part.vertex_begin, model);
  part.vertex_count = static_cast<std::uint32_t>(loaded.file.mesh.positions.size());
  add_mesh(loaded, part, model);
  add_surface(std::move(loaded), part, model);
  model.bodies.push_back(std::move(part));
}

Model begin_model(const Scene& scene, FileReader& files) {
  Model model;
  model.gravity = scene.gravity;
  model.tools = tools_of(with_solids(scene.tools, [&](const std::string& path, const std::string& key) {
    const FileReader::File file = files.read(path, key);
    return ToolSurfaceFile{files.surface(file), scene.file.string() + ": " + key + ": " + file.place.string()};
  }));
  model.contact = scene.tools.contact;
  model.contact.bodies = model.contact.bodies && scene.bodies.size() > 1;  // a body alone has no other to touch
  model.notes = scene.notes;
  return model;
}

}  // namespace

Model build_bodies(const Scene& scene, const Progress& progress, const BodyRead& read) {
  FileReader files(scene);
  Model model = begin_model(scene, files);
  const auto share = [&](std::size_t bodies) {
    return static_cast<double>(bodies) / static_cast<double>(scene.bodies.size());
  };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    LoadedBody loaded = load(scene, b, files, part_of(progress, share(b), share(b + 1)));
    if (read) read(b, loaded.file.mesh, loaded.repaired.tets, loaded.surface);
    add_body(std::move(loaded), model);
  }
  model.notes.insert(model.notes.end(), files.notes.begin(), files.notes.end());
  model.files = std::move(files.files);
  complete_mid_edges(model);
  model.rest_positions = model.file_mesh.positions;
  return model;
}

Model build_bodies(const Scene& scene, std::vector<TetMesh> meshes) {
  if (meshes.size() != scene.bodies.size())
    throw Error(scene.file.string(), "has " + std::to_string(meshes.size()) + " meshes", "expected one a body");
  FileReader files(scene);
  Model model = begin_model(scene, files);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    LoadedBody loaded = begin_body(scene, b, files);
    loaded.file.mesh = std::move(meshes[b]);
    repair_body(loaded, loaded.where);
    add_body(std::move(loaded), model);
  }
  complete_mid_edges(model);
  model.rest_positions = model.file_mesh.positions;
  return model;
}

std::vector<char> Model::held() const {
  std::vector<char> held(rest_positions.size(), 0);
  for (const std::uint32_t vertex : fixed) held[vertex] = 1;
  for (const Motion& motion : motions) {
    for (const std::uint32_t vertex : motion.vertices) held[vertex] = 1;
  }
  return held;
}

}  // namespace fascia
