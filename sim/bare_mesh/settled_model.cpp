#include "sim/bare_mesh/settled_model.h"

#include "sim/bare_mesh/plan.h"
#include "sim/grab/build_model.h"

namespace fascia {

Model settled_model(Scene& scene, const Progress& progress) {
  if (!scene.unsettled) return build_model(scene, progress);
  BareMeshPlan plan;
  std::string law_note;
  const auto settle = [&](std::size_t index, const TetMesh& mesh, const std::vector<Tet>& tets,
                          const SurfaceMesh& surface) {
    if (index > 0) return;
    Body& body = scene.bodies[0];
    plan = plan_bare_mesh(body.mesh, mesh, tets, *scene.unsettled, body, scene.gravity.norm(),
                          surface.triangles.empty() ? 0 : box_of(surface).sizes().maxCoeff());
    body.unit = plan.unit;
    body.up = plan.up;
    body.fixed = plan.fixed;
    body.material.young_modulus = plan.young_modulus;
    if (carries(scene.solver.method, plan.law)) body.material.model = plan.law;
    law_note = carries(scene.solver.method, plan.law)
                   ? ""
                   : std::string(name_of(scene.solver.method)) + " does not support the material model " +
                         name_of(plan.law) + ", so it is " + name_of(body.material.model);
  };
  Model model = build_model(scene, progress, settle);
  scene.unsettled.reset();
  model.notes.insert(model.notes.begin(), scene.bodies[0].name + ": " + text_of(plan));
  if (!law_note.empty()) model.notes.push_back(law_note);
  model.plan = std::move(plan);
  return model;
}

}  // namespace fascia
