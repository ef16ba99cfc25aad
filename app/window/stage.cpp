#include "app/window/stage.h"

#include "app/overlay/color_bar.h"
#include "app/panels/panels.h"
#include "app/session/file_provenance.h"
#include "base/file.h"
#include "base/text.h"
#include "sim/output/simulation_fields.h"
#include "sim/output/state_export.h"
#include "sim/scene/scene_carry.h"
#include "sim/scene/scene_write.h"
#include "sim/simulation/scene_edits.h"

namespace fascia {

Scene Stage::scene_now() const {
  Scene scene = simulation().scene;
  follow_materials(scene, simulation().model);
  const Camera& camera = session->camera;
  scene.camera = CameraSettings{camera.eye, camera.target, camera.up, camera.fov_deg};
  return scene;
}

Provenance Stage::provenance() const {
  Scene scene = simulation().scene;
  follow_materials(scene, simulation().model);
  return provenance_of(scene, simulation().model, session->renderer_description(), command_line, state.statistics.steps,
                       simulation().time());
}

void Stage::give_up_brush() {
  stroke.finish();
  lasso.finish();
}

int Stage::panels_cover() const { return state.show_panels ? static_cast<int>(panel_space()) : 0; }

Margins Stage::margins() const {
  const Cover cover = cover_of(state);
  Margins margins = legend_margins(*session, framebuffer->width() - static_cast<int>(cover.right),
                                   framebuffer->height() - static_cast<int>(cover.bottom), 1, panels_cover());
  margins.right += cover.right;
  margins.bottom = cover.bottom;
  return margins;
}

Scene Stage::scene_to_save(bool with_mesh) {
  std::vector<ReadFile>& files = simulation().model.files;
  Scene now = scene_now();
  const std::vector<ScriptedGrab> staying = mouse.grabs().staying(simulation().model);
  now.grabs.insert(now.grabs.end(), staying.begin(), staying.end());
  return with_mesh ? self_contained(now, files) : with_known_files(now, files);
}

void Stage::save(const std::filesystem::path& path, bool with_mesh) {
  const Scene scene = scene_to_save(with_mesh);
  write_file(path, scene_to_json(scene, path.parent_path()));
  const std::size_t staying = scene.grabs.size() - simulation().scene.grabs.size();
  messages.say("Saved " + path.string() + (staying == 0 ? "" : ", with " + plural(staying, "grab") + " that stays"));
}

void Stage::export_state(const std::filesystem::path& path) {
  write_state(path, simulation().model, export_fields(simulation(), simulation().state(), path), provenance());
  const std::string ending = path.extension().string();
  const bool tools_beside = !simulation().model.tools.empty() && (ending == ".vtu" || ending == ".obj");
  messages.say("Exported " + path.string() + (tools_beside ? ", and the tools beside it as .obj" : ""));
}

}  // namespace fascia
