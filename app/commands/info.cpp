// fascia info: the report of the mesh check, for a mesh or for every body of a scene; or that of the graphics device.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <numeric>

#include "app/cli/command_line.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/commands/info_device.h"
#include "app/session/file_provenance.h"
#include "app/session/open_input.h"
#include "app/session/progress_lines.h"
#include "app/system/paths.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "sim/bare_mesh/plan.h"
#include "sim/bare_mesh/settled_model.h"
#include "sim/material/tissues.h"
#include "sim/mesh/io/mesh_io.h"
#include "sim/mesh/mesh_check.h"
#include "sim/mesh/vertex_check.h"
#include "sim/model/file_reader.h"
#include "sim/model/model.h"
#include "sim/ordering/graph_coloring.h"
#include "sim/ordering/morton_order.h"
#include "sim/surface/surface_fill.h"
#include "sim/tool/tool.h"

namespace fascia {
namespace {

struct InfoOptions : CommonOptions {
  bool tissues = false;       // the table of presets instead of a mesh
  bool tests_device = false;  // the device instead of a mesh
};

// Prints the dispatches of a Gauss-Seidel sweep and their balance.
void print_coloring(const std::string& name, const Model& model, const Coloring& coloring) {
  std::size_t least = model.tets.size(), most = 0;
  for (std::size_t color = 0; color < coloring.color_count(); ++color) {
    least = std::min<std::size_t>(least, coloring.begin[color + 1] - coloring.begin[color]);
    most = std::max<std::size_t>(most, coloring.begin[color + 1] - coloring.begin[color]);
  }
  std::cout << "  coloring     " << name << ": " << plural(coloring.color_count(), "color") << " of ";
  if (least < most) std::cout << least << " to ";
  std::cout << plural(most, "tet") << ", " << plural(coloring.phantom_vertex.size(), "phantom") << '\n';
}

void print_tool(const Tool& tool) {
  std::cout << "  tool         " << tool.name << ": " << kShapeNames[tool.shape.index()]
            << (tool.has_jaws ? " as jaws" : "") << ", friction " << tool.friction;
  if (tool.path.size() > 1) std::cout << ", moves until " << tool.end() << " s";
  std::cout << '\n';
}

void print_colorings(const Model& model, int asked) {
  const std::vector<char> held = model.held();
  const std::vector<std::uint32_t> visit = curve_order(model.rest_positions, model.tets);
  print_coloring("plain", model, color_tets(model.tets, held, visit));
  for (const int colors : {16, 8})
    if (colors != asked)
      print_coloring("at most " + std::to_string(colors), model,
                     color_tets(model.tets, held, visit, static_cast<std::uint32_t>(colors)));
  if (asked > 0)
    print_coloring("solver.colors " + std::to_string(asked), model,
                   color_tets(model.tets, held, visit, static_cast<std::uint32_t>(asked)));
}

/// The tets of a surface, printed after the report about the surface. That comes first, so that a surface that cannot
/// be filled is described, too.
MeshFile filled_mesh(SurfaceMesh surface, const std::string& where, const Body& body, const std::string& unit,
                     const Progress& progress) {
  print_report(std::cout, surface, repair(surface, part_of(progress, 0.1, 0.3)), unit, part_of(progress, 0.3, 0.5));
  FilledSurface filled = fill_surface(std::move(surface), where, body.resolution, part_of(progress, 0.5, 1));
  std::cout << "\nfilled with tets, resolution " << filled.resolution << "\n";
  filled.file.notes.erase(filled.file.notes.begin(),
                          filled.file.notes.begin() + filled.notes_of_surface);  // already printed
  return std::move(filled.file);
}

/// What the file does not state, and how fascia opens it.
void print_plan(const BareMeshPlan& plan) {
  std::cout << "\nopened on its own: what the file does not state is chosen as follows\n";
  std::cout << "  unit         " << name_of(plan.unit) << ": " << plan.unit_reason << "; another one: --unit\n";
  std::cout << "  up           " << name_of(plan.up) << ": " << plan.up_reason << "; another axis: --up\n";
  std::cout << "  supports     " << plan.support_reason << "; others: --set fixed=...\n";
  std::cout << "  stiffness    " << plan.young_modulus << " Pa: " << plan.stiffness_reason
            << "; another one: --set materials.default.young_modulus=...\n";
}

/// The unit of the file's coordinates: the body's, or the one that is guessed for a mesh on its own.
std::string unit_of(const Scene& scene, const Body& body, const ShapeFile& shape) {
  if (!scene.unsettled || !scene.unsettled->unit) return name_of(body.unit);
  if (shape.surface) return name_of(likely_unit(box_of(*shape.surface).sizes().maxCoeff() * body.transform.scale));
  Eigen::AlignedBox3d box;
  for (const Tet& tet : shape.tets.mesh.tets)
    for (const std::uint32_t v : tet) box.extend(shape.tets.mesh.positions[v]);
  return name_of(likely_unit(box.isEmpty() ? 0 : box.sizes().maxCoeff() * body.transform.scale));
}

int inspect(const InfoOptions& options) {
  const EndAtOnce reading;  // no file is being written
  if (options.tests_device) return inspect_device(options);
  if (options.tissues) {
    print_tissues(std::cout);
    return exit_done;
  }
  const std::filesystem::path input = input_or_shipped(options.input, options.data_dir);
  if (const std::string note = shipped_note(options.input, input); !note.empty()) std::cout << note << '\n';
  if (const auto provenance = provenance_of_file(input)) {
    std::cout << input.string() << '\n';
    for (const auto& [keyword, text] : *provenance)
      std::cout << "  " << std::left << std::setw(12) << keyword << ' ' << text << (text.ends_with('\n') ? "" : "\n");
    const std::string ending = lower_ending(input);
    if (ending != ".vtu" && ending != ".msh" && ending != ".inp") return exit_done;  // such files may be meshes
  }
  Scene scene = blaming_options([&] {
    std::vector<std::string> sets = options.sets;
    for (std::string& set : mesh_frame_sets(options.unit, options.up)) sets.push_back(std::move(set));
    return open_scene_or_input(input, sets);
  });
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const Progress progress = opening_progress(body.mesh);
    FileReader files(scene);
    const FileReader::File found =
        files.read(body.mesh, "bodies[" + std::to_string(b) + "].mesh", part_of(progress, 0, 0.1));
    std::cout << found.place.string() << '\n';
    ShapeFile shape = files.shape(found);
    const std::string unit = unit_of(scene, body, shape);
    MeshFile file = shape.surface ? filled_mesh(std::move(*shape.surface), found.place.string(), body, unit, progress)
                                  : std::move(shape.tets);
    require_range(file.mesh.positions, found.place.string());
    const MeshRepair repaired = repair(file.mesh);
    MeshReport report = examine(file.mesh, repaired);
    if (body.elements == ElementOrder::quadratic)
      report.unused_vertices -= keep_mid_edges(file, repaired.source, found.place.string()).size();
    if (scene.unsettled || body.unit != LengthUnit::m) report.unit_guess.clear();  // the unit is known, or in the plan
    print_report(std::cout, file, repaired, report, unit);
  }
  const Model model = settled_model(scene, opening_progress(input.string()));
  if (model.plan) print_plan(*model.plan);
  const std::vector<double> masses = lumped_masses(model);
  std::cout << "\nscene\n";
  std::cout << "  mass         " << std::accumulate(masses.begin(), masses.end(), 0.0) << " kg\n";
  std::cout << "  fixed        " << plural(model.fixed.size(), "vertex") << '\n';
  std::size_t prescribed = 0;
  for (const Motion& motion : model.motions) prescribed += motion.vertices.size();
  std::cout << "  prescribed   " << plural(prescribed, "vertex") << '\n';
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const Material& m = model.materials[i];
    std::cout << "  material     " << model.material_names[i] << ": E " << m.young_modulus << " Pa, nu "
              << m.poisson_ratio << ", density " << m.density << " kg/m^3, damping " << m.damping << " s\n";
  }
  for (const Tool& tool : model.tools) print_tool(tool);
  print_colorings(model, scene.solver.colors);
  if (const EmbeddedPoints& drawn = model.embedded; !drawn.points.empty())
    std::cout << "  surface      " << plural(drawn.points.size(), "vertex") << ", " << drawn.outside
              << " of them outside of the tets, at most " << length(drawn.farthest) << '\n';
  for (std::size_t n = model.plan ? 1 : 0; n < model.notes.size(); ++n)  // the first one sums up the plan
    std::cout << "  note         " << model.notes[n] << '\n';
  return exit_done;
}

}  // namespace

void add_info(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App& command = *program.add_subcommand(
      "info",
      "mesh check: sizes, materials, defects; the provenance of a file that fascia wrote; or a test of the graphics "
      "device");
  CLI::Option* scene = command
                           .add_option("scene", options->input,
                                       "scene (.json) or tetrahedral mesh; or a picture, video, replay or export; - is "
                                       "a scene on standard input")
                           ->type_name(std::string("FILE") + kOrDash);
  command.add_flag("--tissues", options->tissues, "list the tissue presets with their sources, instead")
      ->excludes(scene);
  CLI::Option* device =
      command
          .add_option_function<std::string>(
              "--device",
              [options](const std::string& number) {
                options->tests_device = true;
                if (number.empty() || number == "true") return;  // as it is without a number
                if (number.find_first_not_of("0123456789") != std::string::npos || number.size() > 3)
                  throw CLI::ValidationError("--device", number + " is not the number of an EGL device");
                options->device = std::stoi(number);
              },
              "report what the graphics device is, why it was taken, and whether its kernels compute what they should; "
              "N: that EGL device")
          ->type_name("[N]")
          ->expected(0, 1)
          ->trigger_on_parse()
          ->excludes(scene);
  add_choice(command, "--context", options->context, {"auto", "egl", "osmesa"}, "where --device takes OpenGL from")
      ->capture_default_str()
      ->needs(device);
  add_choice(command, "--loads", options->loads, {"auto", "ssbo", "texel"},
             "how tested kernels read buffers; auto: in every way that the device permits")
      ->capture_default_str()
      ->needs(device);
  command.add_option("--data-dir", options->data_dir, "folder that holds shaders/ and assets/")
      ->type_name("DIR")
      ->needs(device);
  command.add_option("--set", options->sets, "override a scene value")->type_name("KEY=VALUE")->allow_extra_args(false);
  add_mesh_frame(command, options->unit, options->up);
  add_examples(command,
               {"fascia info liver.msh", "fascia info beam.json --set solver.colors=5", "fascia info --tissues",
                "fascia info --device"},
               "the work failed, or a kernel computes something else than it should");
  command.callback([&invocation, options] {
    if (options->input.empty() && !options->tissues && !options->tests_device)
      throw CLI::RequiredError("scene, --tissues or --device,");
    invocation.run = [options] { return inspect(*options); };
  });
}

}  // namespace fascia
