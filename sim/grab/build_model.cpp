#include "sim/grab/build_model.h"

#include "sim/contact/contact_surface.h"
#include "sim/grab/resolve_grab.h"
#include "sim/model/unconstrained_parts.h"

namespace fascia {
namespace {

Model with_grabs(const Scene& scene, Model model) {
  for (std::size_t g = 0; g < scene.grabs.size(); ++g) model.grabs.push_back(resolve_grab(scene, g, model));
  if (model.has_contact())
    for (std::string& note : check_contact(model, scene.file.string())) model.notes.push_back(std::move(note));
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
