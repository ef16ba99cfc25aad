#include "sim/output/run_provenance.h"

#include <cstdio>

namespace fascia {

Provenance provenance_of(const Scene& scene, const Model& model, const std::string& renderer,
                         const std::string& command_line, long step, double time) {
  char hash[24], moment[64];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(mesh_hash(model.file_mesh)));
  std::snprintf(moment, sizeof moment, "step %ld, %.9g s", step, time);
  return {{"Software", std::string("fascia ") + FASCIA_VERSION},
          {"Title", scene.title},
          {"Renderer", renderer},
          {"Mesh hash", hash},
          {"Moment", moment},
          {"Parameters", parameters_to_json(scene, scene.file.parent_path())},
          {"Command line", command_line}};
}

}  // namespace fascia
