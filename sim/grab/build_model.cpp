#include "sim/grab/build_model.h"

#include <algorithm>

#include "sim/contact/contact_surface.h"
#include "sim/grab/resolve_grab.h"
#include "sim/model/unconstrained_parts.h"
#include "sim/tool/tool_size.h"

namespace fascia {
namespace {

// Of a body that cannot move, which may be meant for one that others touch.
std::string note_of_held(const Model& model, const BodyPart& body) {
  const auto first = std::lower_bound(model.fixed.begin(), model.fixed.end(), body.vertex_begin),
             end = std::lower_bound(first, model.fixed.end(), body.vertex_begin + body.vertex_count);
  for (std::uint32_t t = body.tet_begin; t < body.tet_begin + body.tet_count; ++t)
    for (const std::uint32_t v : model.element(t))
      if (!std::binary_search(first, end, v)) return "";
  return body.name + ": every vertex is fixed: it does not move";
}

// A released beam of quadratic tets with a Poisson's ratio of 0.499 and no damping gains 0.15 to 3 times its energy
// with 5 to 20 iterations (docs/developers/accuracy-notes.md), with 0.49 nothing.
std::string note_of_few_iterations(const Scene& scene, const Model& model) {
  constexpr double kRatio = 0.495;
  constexpr int kEnough = 40;
  if (scene.solver.integrator != Integrator::sdirk2 || scene.solver.iterations >= kEnough) return "";
  for (std::size_t t = 0; t < model.tets.size(); ++t)
    if (model.is_quadratic(t) && model.materials[model.tet_material[t]].poisson_ratio > kRatio)
      return "solver: sdirk2 with " + std::to_string(scene.solver.iterations) +
             " iterations may gain energy where Poisson's ratio is above 0.495: use bdf2, or 40 iterations";
  return "";
}

// [m] the largest side of all bodies together.
double extent_of(const Model& model) {
  Eigen::AlignedBox3d box;
  for (const Tet& t : model.tets)
    for (const std::uint32_t v : t) box.extend(model.rest_positions[v]);
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

Model with_grabs(const Scene& scene, Model model) {
  for (std::size_t g = 0; g < scene.grabs.size(); ++g) model.grabs.push_back(resolve_grab(scene, g, model));
  for (const Tool& tool : model.tools)
    if (std::string note = note_of_size(tool, extent_of(model)); !note.empty()) model.notes.push_back(std::move(note));
  if (model.has_contact() || model.contact.thickness > 0)
    for (std::string& note : check_contact(model, scene.file.string())) model.notes.push_back(std::move(note));
  for (const BodyPart& body : model.bodies)
    if (std::string note = note_of_held(model, body); !note.empty()) model.notes.push_back(std::move(note));
  if (std::string note = note_of_few_iterations(scene, model); !note.empty()) model.notes.push_back(std::move(note));
  if (std::string note = model.tools.empty() ? note_of_unconstrained_parts(model) : ""; !note.empty())
    model.notes.push_back(std::move(note));
  return model;
}

}  // namespace

Model build_model(const Scene& scene, const Progress& progress, const BodyRead& read) {
  return with_grabs(scene, build_bodies(scene, progress, read));
}
Model build_model(const Scene& scene, std::vector<TetMesh> meshes) {
  return with_grabs(scene, build_bodies(scene, std::move(meshes)));
}

}  // namespace fascia
