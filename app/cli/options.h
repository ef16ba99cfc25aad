// The values on the command line, one struct per command.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/golden/golden_files.h"

namespace fascia {

struct CommonOptions {
  std::string input;                     // scene or mesh; empty: the default scene
  std::vector<std::string> sets;         // --set KEY=VALUE
  std::string unit, up;                  // --unit, --up: scene keys of body 0; empty: those of the scene, or guessed
  std::vector<std::string> grabs;        // --grab TEXT (sim/scene/grab_text.h)
  std::vector<std::string> instruments;  // --instrument TEXT (sim/scene/tools/instrument_text.h)
  std::string replay;                    // recorded inputs, with their scene
  std::string context = "auto";          // auto, window, egl, osmesa
  int device = -1;                       // --device: number of the EGL device; -1: the first GPU
  std::string loads = "auto";            // how kernels read buffers: auto, ssbo, texel
  std::string kernels = "auto";          // of a step: auto (fused on llvmpipe), single
  std::string quality = "auto";  // of pictures: auto (in a window on software renderers draft, else full), full, draft
  std::string data_dir;          // shaders and assets; empty: beside the program or in the source tree
  std::optional<long> steps;     // --steps
  std::optional<double> time;    // --time [s]
  bool static_equilibrium = false;  // --static
  bool reference = false;           // --reference
  bool quiet = false;
  std::string command_line;  // as typed, for provenance
};

struct RenderOptions : CommonOptions {
  std::string out;    // PNG
  std::string video;  // MP4 or another format of ffmpeg, or pictures, frames/%05d.png
  int width = 1280, height = 720;
  int samples = 4;
  double fps = 60;
  double slow = 1;                // times slower than real time
  std::string camera = "follow";  // follow (the replay's), scene, a file, or six numbers: eye, target
  std::string turntable;          // "8s" or "360deg"; empty: none
  std::string preset;             // of pictures, see picture_presets()
  std::string legend_out;         // the legend alone: SVG or PDF
  bool hash = false;              // of the last state and of all frames
  bool panels = false;            // --ui
  std::string color;              // overrides display.color
  bool wireframe = false;
  std::string compare;  // golden PNG
  std::string state;    // golden CSV
  GoldenLimits limits;
  std::string difference;  // --diff, PNG
  bool update = false;     // updates the goldens instead of comparing
  GoldenFiles goldens() const { return {compare, state}; }
  std::string split;  // --set texts for a second side, separated by semicolons
};

struct ViewOptions : CommonOptions {
  int width = 1280, height = 720;
  int samples = 0;          // 0: 4 on a GPU, 1 on software renderers
  std::string export_path;  // state at the closing of the window: .vtu, .csv, .msh, .obj, .inp
  std::string stats;        // stats.json
  std::string measured;     // curves to draw in the plots, CSV
  std::string frame_log;    // times of the frames, CSV
};

struct BenchOptions : CommonOptions {
  std::string out;  // folder
  bool quick = false;
  std::vector<std::string> charts{".svg", ".png"};  // endings of their files
  int width = 1280, height = 720;
};

}  // namespace fascia
