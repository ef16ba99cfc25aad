// fascia convert: converts between mesh formats, preserving vertex order, quadratic tets, regions and names where the
// format can; converts scenes and replays to files that carry their meshes.
#include <algorithm>
#include <iostream>
#include <optional>

#include "app/cli/command_line.h"
#include "app/cli/output_files.h"
#include "app/cli/usage_error.h"
#include "app/commands/command.h"
#include "app/session/open_input.h"
#include "app/session/progress_lines.h"
#include "app/system/paths.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/text.h"
#include "sim/mesh/io/mesh_formats.h"
#include "sim/mesh/io/written_middles.h"
#include "sim/mesh/vertex_check.h"
#include "sim/scene/scene_carry.h"
#include "sim/surface/surface_fill.h"

namespace fascia {
namespace {

struct ConvertOptions {
  std::string in, out;
  bool weld = false;
  bool with_mesh = false;  // IN is a scene or a replay, OUT the same with its files in it
};

// Writes a scene or a replay with its files in it, which opens anywhere.
int write_self_contained(const ConvertOptions& options) {
  const bool is_replay = lower_ending(options.in) == ".fascia";
  const std::filesystem::path in = input_or_shipped(options.in, "");
  Opened opened = open_file(in);
  if (const std::string note = shipped_note(options.in, in); !note.empty()) opened.model.notes.push_back(note);
  require_outputs({{"OUT", options.out, {is_replay ? ".fascia" : ".json"}}}, input_files(opened.scene));
  const std::filesystem::path folder = std::filesystem::path(options.out).parent_path();
  const Scene whole = self_contained(opened.scene, opened.model.files);
  if (is_replay) opened.replay->scene = whole;
  write_file(options.out, is_replay ? replay_to_json(*opened.replay, folder) : scene_to_json(whole, folder));
  for (const std::string& note : opened.model.notes) std::cerr << "fascia: " << note << '\n';
  std::cerr << "fascia: " << options.out << ": with ";
  for (const KnownFile& file : whole.files) std::cerr << (&file == &whole.files.front() ? "" : ", ") << file.path;
  std::cerr << '\n';
  return exit_done;
}

int convert_file(const ConvertOptions& options) {
  if (options.with_mesh) return write_self_contained(options);
  if (const std::string ending = lower_ending(options.in); ending == ".json" || ending == ".fascia")
    throw UsageError(options.in, ending == ".json" ? "is a scene" : "is a replay",
                     "expected a mesh, or --with-mesh for a copy with its meshes in it");
  const auto files_of = [](const std::string& path) {  // TetGen has two files
    const std::string ending = lower_ending(path);
    std::vector<std::filesystem::path> files{path};
    if (ending == ".node" || ending == ".ele")
      files.push_back(std::filesystem::path(path).replace_extension(ending == ".node" ? ".ele" : ".node"));
    return files;
  };
  for (const std::filesystem::path& out : files_of(options.out))
    require_outputs({{"OUT", out.string(), written_endings()}}, files_of(options.in));
  std::optional<EndAtOnce> opening(std::in_place);
  MeshFile file = read_mesh_or_fill(options.in, {}, opening_progress(options.in));
  opening.reset();
  keep_written_middles(file, options.out);
  const std::size_t welded = options.weld ? weld(file.mesh) : 0;
  write_mesh(options.out, file.mesh);
  std::cerr << "fascia: " << options.out << ": " << plural(file.mesh.positions.size(), "vertex") << ", "
            << plural(file.mesh.tets.size(), "tet");
  const auto quadratic = std::count_if(file.mesh.mid_edges.begin(), file.mesh.mid_edges.end(),
                                       [](const MidEdges& middles) { return middles != kNoMidEdges; });
  if (quadratic > 0) std::cerr << " (" << quadratic << " quadratic)";
  std::cerr << ", from " << file.format << '\n';
  if (options.weld)
    std::cerr << "fascia: --weld: " << plural(welded, "vertex") << " at the place of an earlier one left out\n";
  if (const std::string lost = names_left_out(options.out, file.mesh); !lost.empty())
    std::cerr << "fascia: " << lost << '\n';
  if (const std::string cells = ignored_cells(file); !cells.empty())
    std::cerr << "fascia: not written, beside the tets: " << cells << "; groups keep their vertices\n";
  for (const std::string& note : file.notes) std::cerr << "fascia: " << note << '\n';
  return exit_done;
}

}  // namespace

void add_convert(CLI::App& program, Invocation& invocation) {
  const auto options = std::make_shared<ConvertOptions>();
  CLI::App& command = *program.add_subcommand(
      "convert", "between mesh formats, by the ending of OUT; a scene or a replay to one that carries its meshes");
  command.add_option("in", options->in, "mesh, scene or replay to read")->type_name("FILE")->required();
  command
      .add_option("out", options->out,
                  "mesh to write: .msh, .vtk, .vtu, .node, .ele, .mesh or .inp; with --with-mesh a scene (.json) or a "
                  "replay (.fascia)")
      ->type_name("FILE")
      ->required();
  CLI::Option* const weld = command.add_flag(
      "--weld", options->weld, "make vertices at exactly one place one: halves that only touch hold together");
  command
      .add_flag("--with-mesh", options->with_mesh,
                "OUT is the scene or the replay IN with all the files in it that it refers to: it opens anywhere")
      ->excludes(weld);
  add_examples(command, {"fascia convert model.vtu model.msh", "fascia convert liver.json elsewhere.json --with-mesh"});
  command.callback([&invocation, options] { invocation.run = [options] { return convert_file(*options); }; });
}

}  // namespace fascia
