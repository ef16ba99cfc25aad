// The variables for each kind of device, with a copy of what Linux shows in /sys; and which contexts count as one
// device.
#include "render/context/window_device.h"

#include "tests/gl/gl_support.h"

namespace fascia {
namespace {

using Catch::Matchers::Contains;
using Variables = std::vector<std::pair<std::string, std::string>>;
namespace fs = std::filesystem;

/// /sys with one graphics card as /dev/dri/card1, in a slot of the PCI bus or elsewhere.
class Sys {
 public:
  Sys(const std::string& slot, const std::string& driver) {
    const fs::path device = folder_ / "devices" / slot, card = folder_ / "class/drm/card1";
    fs::create_directories(device);
    fs::create_directories(folder_ / "drivers" / driver);
    fs::create_directories(card);
    fs::create_directory_symlink(fs::canonical(folder_ / "drivers" / driver), device / "driver");
    fs::create_directory_symlink(fs::canonical(device), card / "device");
  }
  fs::path path() const { return folder_.path(); }

 private:
  test::TemporaryFolder folder_;
};

EglDevice card() {
  EglDevice device;
  device.name = "device 1";
  device.file = "/dev/dri/card1";
  return device;
}

}  // namespace

TEST_CASE("a window asks for a GPU of Mesa by its slot") {
  const Sys sys("0000:c1:00.0", "amdgpu");
  CHECK(window_environment(card(), sys.path()) ==
        Variables{{"DRI_PRIME", "pci-0000_c1_00_0"}, {"__GLX_VENDOR_LIBRARY_NAME", "mesa"}});
}

TEST_CASE("a window asks for NVIDIA's driver by its offload, with and without a file of the card") {
  const Variables offload{{"__NV_PRIME_RENDER_OFFLOAD", "1"}, {"__GLX_VENDOR_LIBRARY_NAME", "nvidia"}};
  const Sys sys("0000:01:00.0", "nvidia"), empty("0000:01:00.0", "nouveau");
  CHECK(window_environment(card(), sys.path()) == offload);
  EglDevice fileless = card();
  fileless.file.clear();
  fileless.nvidia = true;
  CHECK(window_environment(fileless, empty.path()) == offload);
  CHECK(window_environment(card(), empty.path())[0].first == "DRI_PRIME");  // nouveau is Mesa's
}

TEST_CASE("a window asks for a software renderer whatever GPUs there are") {
  EglDevice device;
  device.software = true;
  CHECK(window_environment(device, "/nowhere") ==
        Variables{{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"__GLX_VENDOR_LIBRARY_NAME", "mesa"}});
}

TEST_CASE("GPUs without a slot are refused with what helps") {
  const Sys sys("ff9a0000.gpu", "panfrost");
  for (const char* file : {"/dev/dri/card1", "/dev/dri/card7", ""}) {
    EglDevice device = card();
    device.file = file;
    CHECK_THAT(test::error_of([&] { window_environment(device, sys.path()); }),
               Contains("device 1: not a PCI device") && Contains("expected DRI_PRIME=1"));
  }
}

TEST_CASE("two contexts are of one device by renderer and, where known, UUID") {
  gl::Device a, b;
  a.renderer = b.renderer = "GPU X";
  CHECK(same_device(a, b));
  a.uuid = "0123456789abcdef";
  CHECK(same_device(a, b));
  b.uuid = "0123456789abcdeg";
  CHECK_FALSE(same_device(a, b));
  CHECK(other_device_than(1, a, b) ==
        "--device 1 is GPU X, but this display has its windows drawn by another one of these");
  b.uuid = a.uuid;
  CHECK(same_device(a, b));
  CHECK(other_device_than(1, a, b).empty());
  b.renderer = "GPU Y";
  CHECK_FALSE(same_device(a, b));
  CHECK(other_device_than(1, a, b) == "--device 1 is GPU X, but this display has its windows drawn by GPU Y");
}

TEST_CASE("a device of a window is asked for by its number") {
  CHECK_THAT(test::error_of([] { ask_for_window_device(31); }), Contains("--device 31: EGL has no device"));
}

TEST_CASE("on systems without a GPU nothing is said of another device") {
  if (may_have_gpu()) return;
  const auto context = make_osmesa_context({});
  CHECK(other_device_without_window(gl::device()).empty());
  CHECK(context->is_current());
}

}  // namespace fascia
