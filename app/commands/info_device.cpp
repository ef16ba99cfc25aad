#include "app/commands/info_device.h"

#include <iomanip>
#include <iostream>

#include "app/commands/command.h"
#include "app/session/graphics.h"
#include "base/error.h"
#include "base/text.h"
#include "gl/context/context.h"
#include "sim/gpu/self_test/self_test.h"

namespace fascia {
namespace {

void print_row(const std::string& name, const std::string& text) {
  std::cout << "  " << std::left << std::setw(12) << name << ' ' << text << '\n';
}

void print_device(const Graphics& graphics) {
  const gl::Device& device = gl::device();
  std::cout << "device\n";
  print_row("renderer", device.renderer + (device.software ? ", computed by the CPU" : ""));
  print_row("OpenGL", device.version);
  print_row("context", graphics.context->name());
  print_row("kernels", std::string("read by ") + gl::name_of(graphics.programs->load_path()));
  print_row("limits", std::to_string(device.max_compute_storage_blocks) + " storage blocks a kernel, of " +
                          std::to_string(device.max_storage_block_size) + " bytes; " +
                          std::to_string(device.max_compute_textures) + " buffer textures, of " +
                          std::to_string(device.max_texture_buffer_size) + " texels; " +
                          std::to_string(device.max_compute_groups) + " work groups");
}

void print_found(const CommonOptions& options, const std::string& context) {
  std::cout << "\nEGL\n";
  std::vector<EglDevice> found;
  try {
    found = egl_devices();
  } catch (const Error& error) {
    print_row("none", error.what());
  }
  bool taken = context != "egl";  // by then
  for (const EglDevice& device : found) {
    std::string text = device.file.empty() ? "" : device.file + ": ";
    if (!device.refusal.empty()) {
      text += "refused: " + device.refusal;
    } else {
      text += device.renderer;
      const bool wanted = options.device < 0 ? !device.software || options.context == "egl"
                                             : device.name == "device " + std::to_string(options.device);
      if (device.software && options.device < 0 && options.context == "auto")
        text += "; passed over: computed by the CPU";
      else
        text += !wanted ? "" : taken ? "; passed over: not the first" : "; taken";
      taken = taken || wanted;
    }
    print_row(device.name, text);
  }
}

/// The checks that failed, with the access of kernels to their inputs.
std::vector<std::string> failed_checks(const Graphics& graphics, gl::LoadPath loads) {
  std::cout << "\nself-test, read by " << gl::name_of(loads) << ": deviation from double precision, and its bound\n";
  gl::ProgramCache programs(graphics.data_dir / "shaders", loads);
  std::vector<std::string> failed;
  std::string failure;  // the last one
  self_test(programs, [&](const KernelCheck& check) {
    std::cout << "  " << (check.passed() ? "      " : "WRONG ") << std::setprecision(2) << std::scientific
              << check.deviation << "  " << check.bound << "  " << check.kernels
              << (check.failure.empty()      ? ""
                  : check.failure == failure ? ": as before"
                                             : ": " + check.failure)
              << std::endl;
    if (!check.failure.empty()) failure = check.failure;
    if (!check.passed()) failed.push_back(check.text() + ", read by " + gl::name_of(loads));
  });
  return failed;
}

}  // namespace

int inspect_device(const CommonOptions& options) {
  Graphics graphics = open_graphics(options, false);
  print_device(graphics);
  if (!graphics.context->passed_over.empty()) print_row("no GPU", graphics.context->passed_over);
  print_found(options, graphics.context->name());
  graphics.context->make_current();
  std::vector<gl::LoadPath> paths{graphics.programs->load_path()};
  if (options.loads == "auto") {
    paths = {gl::LoadPath::texel};
    if (gl::device().max_compute_storage_blocks >= gl::kMostStorageBlocks)
      paths.insert(paths.begin(), gl::LoadPath::storage);
  }
  std::vector<std::string> failed;
  for (const gl::LoadPath loads : paths)
    for (std::string& text : failed_checks(graphics, loads)) failed.push_back(std::move(text));
  if (failed.empty()) {
    std::cout << "\nall kernels compute what they should\n";
    return exit_done;
  }
  std::cerr << "fascia: " << gl::device().renderer << ": " << failed.front();
  if (failed.size() > 1) std::cerr << "; and " << failed.size() - 1 << " more";
  std::cerr << '\n';
  return exit_failed;
}

}  // namespace fascia
