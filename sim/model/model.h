// The input of the solvers: all bodies of a scene in one set of arrays, repaired, placed and with their selections
// resolved. The reference solver and the GPU solver start from the same Model.
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/progress.h"
#include "sim/material/material.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/model/bare_mesh_plan.h"
#include "sim/model/resolved_grab.h"
#include "sim/scene/scene.h"
#include "sim/surface/embedding.h"
#include "sim/surface/surface_mesh.h"
#include "sim/tool/tool.h"

namespace fascia {

/// Moves its vertices from rest along a path to `target` and constrains them there (scene key "prescribed").
struct Motion {
  std::vector<std::uint32_t> vertices;
  std::vector<Eigen::Vector3d> targets;  // final positions [m]; path is straight unless the motion rotates
  Eigen::Vector3d translate{0, 0, 0}, axis{1, 0, 0}, center{0, 0, 0};
  double angle = 0, scale = 1;     // [rad]; used when `targets` is empty
  double start = 0, duration = 0;  // [s]

  /// Position at time t of vertices[k] whose rest position is `rest` [m].
  Eigen::Vector3d position(std::size_t k, const Eigen::Vector3d& rest, double t) const;
};

struct BodyPart {
  std::string name;
  std::uint32_t vertex_begin = 0, vertex_count = 0;  // in rest_positions
  std::uint32_t tet_begin = 0, tet_count = 0;        // in Model::tets
  std::uint32_t material_begin = 0, material_count = 0;
  std::map<int, std::string> regions;  // of its mesh and of Body::regions: number, and name if there is one
  std::set<int> added_regions{};       // those that the mesh file does not have
  std::optional<double> filled{};      // volume of tets that fill a surface, over what that encloses
};

/// The vertices of one element: four corners, and then the six mid-edge vertices of a quadratic tet.
class ElementVertices {
 public:
  explicit ElementVertices(const Tet& corners) : count_(4) { std::copy(corners.begin(), corners.end(), all_.begin()); }
  ElementVertices(const Tet& corners, const MidEdges& mid_edges) : ElementVertices(corners) {
    std::copy(mid_edges.begin(), mid_edges.end(), all_.begin() + 4);
    count_ = 10;
  }
  const std::uint32_t* begin() const { return all_.data(); }
  const std::uint32_t* end() const { return all_.data() + count_; }
  std::size_t size() const { return count_; }
  std::uint32_t operator[](std::size_t n) const { return all_[n]; }

 private:
  std::array<std::uint32_t, 10> all_{};
  std::size_t count_;
};

struct Model {
  std::vector<Eigen::Vector3d> rest_positions;  // [vertex_count] X [m], transforms applied: body by body the vertices
                                                // of the file in its order, and then added mid-edge vertices
  std::vector<Tet> tets;                        // [tet_count] corners of the usable tets, positive volume
  std::vector<MidEdges> mid_edges;              // [tet_count] kNoMidEdges in linear tets; empty if all are linear
  std::vector<std::uint32_t> tet_material;      // [tet_count] index into materials
  std::vector<Material> materials;              // one per body and region that has its own values
  std::vector<std::string> material_names;      // "beam: default", "liver: tumour"
  std::vector<std::uint32_t> fixed;  // ascending, unique; prescribed vertices not included. A mid-edge vertex
                                     // is fixed, or in a motion, if both ends of its edge are
  std::vector<Motion> motions;
  std::vector<ResolvedGrab> grabs;
  std::vector<Tool> tools;  // that the bodies may touch
  ContactSettings contact;
  std::vector<Eigen::Vector3d> initial_velocity;  // [vertex_count] v [m/s]; zero where fixed or prescribed
  Eigen::Vector3d gravity{0, -9.81, 0};           // [m/s^2]
  std::vector<BodyPart> bodies;

  std::vector<SurfaceMesh>
      surfaces;  // [body] placed, drawn instead of the boundary of its tets; without triangles: the boundary is drawn
  EmbeddedPoints embedded;  // the vertices of all surfaces, concatenated, embedded in the tets of their bodies

  TetMesh file_mesh;                      // every vertex and tet of the files (placed), for exports
  std::vector<std::uint32_t> tet_source;  // [tet_count] index of each tet in file_mesh.tets
  std::vector<std::string> notes;         // repairs and warnings for the user, one line each
  std::optional<BareMeshPlan> plan;       // of a mesh opened on its own
  std::vector<ReadFile> files;            // files that were read for the model

  bool has_quadratic() const { return !mid_edges.empty(); }
  bool is_quadratic(std::size_t t) const { return has_quadratic() && mid_edges[t][0] != kNoVertex; }
  ElementVertices element(std::size_t t) const {
    return is_quadratic(t) ? ElementVertices(tets[t], mid_edges[t]) : ElementVertices(tets[t]);
  }
  std::vector<char> held() const;  // [vertex_count] 1 where fixed or prescribed
  double end_of_motions() const;   // [s] end of the last prescribed motion; 0 without any
  double end_of_grabs() const;     // [s] when the last scripted grab ends its path or is released; 0 without any
  double end_of_tools() const;     // [s] end of the last instrument's path; 0 without any
  bool has_contact() const;        // whether tissue may touch anything: tools or tissue
  bool touches_tissue() const;     // whether bodies may touch each other or themselves
};

/// Called with the mesh of a body and its usable tets, before anything else of the body is looked at.
using BodyRead = std::function<void(std::size_t body, const TetMesh& mesh, const std::vector<Tet>& tets,
                                    const SurfaceMesh& surface)>;

/// Reads the meshes, surfaces and CSV files of the scene's bodies, without the grabs (sim/grab/build_model.h). `read`
/// may change the scene. Throws Error for an unreadable file, an empty selection, a material key that names no region,
/// tets of regions that do not exist, or prescribed targets that miss vertices.
Model build_bodies(const Scene& scene, const Progress& progress = {}, const BodyRead& read = {});
/// The same from meshes in memory, [body], instead of the files that the bodies name. Their vertex indices and
/// positions are not checked.
Model build_bodies(const Scene& scene, std::vector<TetMesh> meshes);

/// Lumped masses [vertex_count] [kg]: a quarter of density * volume of each linear tet per vertex, and the positive
/// shares of sim/elements/quadratic_tet.h of each quadratic one. Zero for unreferenced vertices.
std::vector<double> lumped_masses(const Model& model);
/// The row sums of the mass matrix [vertex_count] [kg], negative at corners of quadratic tets: gravity acts on them,
/// and momentum is their sum with velocities. Of linear tets the lumped masses.
std::vector<double> consistent_masses(const Model& model);

/// What moves with which velocity: 1/2 sum own |v|^2 + 1/2 sum centroid |v at the centroid|^2 is the kinetic energy
/// (sim/elements/quadratic_tet.h).
struct MovingMasses {
  std::vector<double> own;       // [vertex_count] [kg]; of linear tets the lumped ones
  std::vector<double> centroid;  // [tet_count] [kg]; 0 in linear tets; empty if all are linear
};
MovingMasses moving_masses(const Model& model);

/// FNV-1a 64 over vertex positions, tet indices and those of mid-edge vertices: identifies the mesh in provenance
/// stamps.
std::uint64_t mesh_hash(const TetMesh& mesh);

}  // namespace fascia
