#include "sim/output/abaqus_model.h"

#include "base/number_text.h"
#include "sim/mesh/io/fem/abaqus_write.h"
#include "sim/mesh/io/formats.h"

namespace fascia {
namespace {

/// Adds the set under this name, or one like it that is free.
std::string add_group(TetMesh& mesh, std::string name, const std::vector<std::uint32_t>& vertices) {
  while (mesh.groups.contains(name)) name += "_vertices";
  mesh.groups[name] = vertices;
  return name;
}

}  // namespace

std::string abaqus_model_text(const Model& model, const std::vector<Eigen::Vector3d>& displacement) {
  TetMesh mesh{model.rest_positions, model.tets, model.mid_edges, {}, {}, {}};
  for (std::size_t v = 0; v < displacement.size(); ++v) mesh.positions[v] += displacement[v];
  for (const std::uint32_t material : model.tet_material) mesh.regions.push_back(static_cast<int>(material) + 1);
  for (std::size_t m = 0; m < model.material_names.size(); ++m)
    mesh.region_names[static_cast<int>(m) + 1] = model.material_names[m];
  for (const auto& [name, vertices] : groups_beyond_regions(model.file_mesh)) mesh.groups[name] = *vertices;
  const std::string fixed = add_group(mesh, "fixed", model.fixed);
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    add_group(mesh, "prescribed_" + std::to_string(m), model.motions[m].vertices);

  AbaqusMesh written = abaqus_mesh(mesh);
  NumberText out;
  for (const auto& [region, set] : written.regions) {
    const Material& material = model.materials[static_cast<std::size_t>(region - 1)];
    out.add("*MATERIAL, NAME=").add(set).add("\n*ELASTIC\n").add(material.young_modulus).add(", ");
    out.add(material.poisson_ratio).add("\n*DENSITY\n").add(material.density);
    out.add("\n*SOLID SECTION, ELSET=").add(set).add(", MATERIAL=").add(set).add('\n');
  }
  if (!model.fixed.empty()) out.add("*BOUNDARY\n").add(written.groups.at(fixed)).add(", 1, 3\n");
  return written.text + out.take();
}

}  // namespace fascia
