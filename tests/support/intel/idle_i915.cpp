// Preloaded into a program: a kernel with an Intel chip that executes nothing. Mesa's OpenGL driver (iris) starts on
// it, compiles and links as on the chip and records its commands; results are what buffers held before, zeros at first.
// FASCIA_CHIP chooses the chip: "skl", "tgl" (by default) or "dg2".
#include <fcntl.h>
#include <i915_drm.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <xf86drm.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>

namespace {

constexpr const char* kNode = "/dev/dri/renderD128";
constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;
constexpr std::uint64_t kMemory = 8 * kGiB;

struct Chip {
  const char* name;
  std::uint16_t device;  // of PCI
  int revision;
  std::uint16_t slices, subslices, eus;  // in each of the next larger
  int clock;                             // of time stamps [Hz]
  bool local_memory;
};
constexpr Chip kChips[] = {{"skl", 0x1912, 6, 1, 3, 8, 12'000'000, false},
                           {"tgl", 0x9a49, 1, 1, 6, 16, 19'200'000, false},
                           {"dg2", 0x56a0, 8, 8, 4, 16, 19'200'000, true}};

const Chip& chip() {
  static const Chip& chosen = [&]() -> const Chip& {
    const char* const name = std::getenv("FASCIA_CHIP");
    for (const Chip& known : kChips)
      if (name && std::strcmp(name, known.name) == 0) return known;
    return kChips[1];
  }();
  return chosen;
}

struct Range {
  std::uint64_t begin, size;
};

/// The device is a file in memory; its buffers are ranges of it, so that mmap needs no help.
struct Device {
  int file = memfd_create("idle_i915", MFD_CLOEXEC);
  struct stat identity {};
  std::mutex mutex;
  std::map<std::uint32_t, Range> buffers;
  std::uint64_t end = 0;
  std::uint32_t last_buffer = 0, last_number = 0;  // of contexts and the like
  Device() { fstat(file, &identity); }
};

Device& device() {
  static Device& the_device = *new Device;  // used by threads of the driver until the process ends
  return the_device;
}

bool is_ours(int file) {
  struct stat found {};
  return fstat(file, &found) == 0 && found.st_ino == device().identity.st_ino &&
         found.st_dev == device().identity.st_dev;
}

std::uint32_t make_buffer(std::uint64_t size) {
  Device& all = device();
  const std::uint64_t begin = all.end;
  all.end += (size + 0xffff) & ~std::uint64_t{0xffff};
  if (ftruncate(all.file, static_cast<off_t>(all.end)) != 0) return 0;
  all.buffers[++all.last_buffer] = {begin, size};
  return all.last_buffer;
}

int close_buffer(std::uint32_t handle) {
  const auto found = device().buffers.find(handle);
  if (found == device().buffers.end()) return EINVAL;
  fallocate(device().file, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(found->second.begin),
            static_cast<off_t>(found->second.size));
  device().buffers.erase(found);
  return 0;
}

int get_parameter(const drm_i915_getparam& asked) {
  switch (asked.param) {
    case I915_PARAM_REVISION:
      *asked.value = chip().revision;
      return 0;
    case I915_PARAM_CS_TIMESTAMP_FREQUENCY:
      *asked.value = chip().clock;
      return 0;
    case I915_PARAM_MMAP_GTT_VERSION:
      *asked.value = 4;  // with DRM_IOCTL_I915_GEM_MMAP_OFFSET
      return 0;
    case I915_PARAM_HAS_CONTEXT_ISOLATION:
      *asked.value = 1;
      return 0;
    default:
      return EINVAL;
  }
}

/// Copies what was asked for into the room that is there; without room, states how much is needed.
void give(drm_i915_query_item& item, const void* data, std::size_t bytes) {
  if (item.length >= static_cast<int>(bytes)) std::memcpy(reinterpret_cast<void*>(item.data_ptr), data, bytes);
  item.length = static_cast<int>(bytes);
}

void give_topology(drm_i915_query_item& item) {
  union {
    drm_i915_query_topology_info info;
    std::uint8_t bytes[512];
  } all{};
  const Chip& c = chip();
  all.info.max_slices = c.slices;
  all.info.max_subslices = c.subslices;
  all.info.max_eus_per_subslice = c.eus;
  all.info.subslice_offset = 1;  // a byte of slices comes first
  all.info.subslice_stride = 1;
  all.info.eu_offset = static_cast<std::uint16_t>(1 + c.slices);
  all.info.eu_stride = static_cast<std::uint16_t>(c.eus / 8);
  const std::size_t masks = 1u + c.slices + static_cast<std::size_t>(c.slices * c.subslices * c.eus / 8);
  std::uint8_t* const mask = all.bytes + sizeof all.info;
  std::memset(mask, 0xff, masks);
  mask[0] = static_cast<std::uint8_t>((1 << c.slices) - 1);
  std::memset(mask + 1, (1 << c.subslices) - 1, c.slices);
  give(item, all.bytes, sizeof all.info + masks);
}

void give_memory(drm_i915_query_item& item) {
  union {
    drm_i915_query_memory_regions info;
    std::uint8_t bytes[512];
  } all{};
  auto* const region = reinterpret_cast<drm_i915_memory_region_info*>(all.bytes + sizeof all.info);
  all.info.num_regions = chip().local_memory ? 2 : 1;
  for (std::uint32_t r = 0; r < all.info.num_regions; ++r) {
    region[r].region.memory_class =
        static_cast<std::uint16_t>(r == 0 ? I915_MEMORY_CLASS_SYSTEM : I915_MEMORY_CLASS_DEVICE);
    region[r].probed_size = region[r].unallocated_size = kMemory;
    if (r == 1) region[r].probed_cpu_visible_size = region[r].unallocated_cpu_visible_size = kMemory;
  }
  give(item, all.bytes, sizeof all.info + all.info.num_regions * sizeof *region);
}

int query(const drm_i915_query& asked) {
  auto* const items = reinterpret_cast<drm_i915_query_item*>(asked.items_ptr);
  for (std::uint32_t i = 0; i < asked.num_items; ++i) switch (items[i].query_id) {
      case DRM_I915_QUERY_TOPOLOGY_INFO:
      case DRM_I915_QUERY_GEOMETRY_SUBSLICES:
        give_topology(items[i]);
        break;
      case DRM_I915_QUERY_MEMORY_REGIONS:
        give_memory(items[i]);
        break;
      default:
        items[i].length = -EINVAL;
    }
  return 0;
}

int context_parameter(drm_i915_gem_context_param& asked) {
  asked.size = 0;
  switch (asked.param) {
    case I915_CONTEXT_PARAM_GTT_SIZE:
      asked.value = std::uint64_t{1} << 48;
      return 0;
    case I915_CONTEXT_PARAM_VM:
      asked.value = ++device().last_number;
      return 0;
    default:
      return EINVAL;
  }
}

int version(drm_version& asked) {
  const auto give_text = [](char* to, std::size_t& room, const char* text) {
    if (to) std::memcpy(to, text, std::min(room, std::strlen(text)));
    room = std::strlen(text);
  };
  asked.version_major = 1;
  asked.version_minor = 6;
  asked.version_patchlevel = 0;
  give_text(asked.name, asked.name_len, "i915");
  give_text(asked.date, asked.date_len, "20201103");
  give_text(asked.desc, asked.desc_len, "idle Intel Graphics");
  return 0;
}

int capability(drm_get_cap& asked) {
  switch (asked.capability) {
    case DRM_CAP_PRIME:
      asked.value = DRM_PRIME_CAP_IMPORT | DRM_PRIME_CAP_EXPORT;
      return 0;
    case DRM_CAP_SYNCOBJ:
      asked.value = 1;
      return 0;
    default:
      asked.value = 0;
      return 0;
  }
}

/// Returns an error number. Commands end at once and no buffer is ever busy.
int command(unsigned long request, void* data) {
  Device& all = device();
  const std::lock_guard lock(all.mutex);
  const auto as = [&]<class T>(T*) -> T& { return *static_cast<T*>(data); };
#define AS(type) as(static_cast<type*>(nullptr))
  switch (request) {
    case DRM_IOCTL_VERSION:
      return version(AS(drm_version));
    case DRM_IOCTL_GET_CAP:
      return capability(AS(drm_get_cap));
    case DRM_IOCTL_GEM_CLOSE:
      return close_buffer(AS(drm_gem_close).handle);
    case DRM_IOCTL_SYNCOBJ_CREATE:
      AS(drm_syncobj_create).handle = ++all.last_number;
      return 0;
    case DRM_IOCTL_SYNCOBJ_DESTROY:
    case DRM_IOCTL_SYNCOBJ_WAIT:
      return 0;
    case DRM_IOCTL_I915_GETPARAM:
      return get_parameter(AS(drm_i915_getparam));
    case DRM_IOCTL_I915_QUERY:
      return query(AS(drm_i915_query));
    case DRM_IOCTL_I915_GEM_GET_APERTURE:
      AS(drm_i915_gem_get_aperture).aper_size = AS(drm_i915_gem_get_aperture).aper_available_size = 4 * kGiB;
      return 0;
    case DRM_IOCTL_I915_GEM_CREATE:
    case DRM_IOCTL_I915_GEM_CREATE_EXT: {  // begins alike
      auto& asked = AS(drm_i915_gem_create);
      asked.handle = make_buffer(asked.size);
      return asked.handle == 0 ? ENOMEM : 0;
    }
    case DRM_IOCTL_I915_GEM_MMAP_OFFSET: {
      auto& asked = AS(drm_i915_gem_mmap_offset);
      const auto found = all.buffers.find(asked.handle);
      if (found == all.buffers.end()) return EINVAL;
      asked.offset = found->second.begin;
      return 0;
    }
    case DRM_IOCTL_I915_GEM_BUSY:
      AS(drm_i915_gem_busy).busy = 0;
      return 0;
    case DRM_IOCTL_I915_GEM_MADVISE:
      AS(drm_i915_gem_madvise).retained = 1;
      return 0;
    case DRM_IOCTL_I915_GEM_CONTEXT_CREATE:
    case DRM_IOCTL_I915_GEM_CONTEXT_CREATE_EXT:
      AS(drm_i915_gem_context_create).ctx_id = ++all.last_number;
      return 0;
    case DRM_IOCTL_I915_GEM_CONTEXT_GETPARAM:
      return context_parameter(AS(drm_i915_gem_context_param));
    case DRM_IOCTL_I915_GET_RESET_STATS:
      AS(drm_i915_reset_stats).reset_count = AS(drm_i915_reset_stats).batch_active =
          AS(drm_i915_reset_stats).batch_pending = 0;
      return 0;
    case DRM_IOCTL_I915_GEM_WAIT:
    case DRM_IOCTL_I915_GEM_SET_DOMAIN:
    case DRM_IOCTL_I915_GEM_SET_TILING:
    case DRM_IOCTL_I915_GEM_CONTEXT_SETPARAM:
    case DRM_IOCTL_I915_GEM_CONTEXT_DESTROY:
    case DRM_IOCTL_I915_GEM_EXECBUFFER2:
    case DRM_IOCTL_I915_GEM_EXECBUFFER2_WR:
      return 0;
    default:
      return EINVAL;
  }
#undef AS
}

drmDevicePtr describe() {
  struct All {
    drmDevice device;
    drmPciBusInfo bus;
    drmPciDeviceInfo pci;
    char* nodes[DRM_NODE_MAX];
    char node[32];
  };
  auto* const all = static_cast<All*>(std::calloc(1, sizeof(All)));  // of libdrm's drmFreeDevice
  all->bus = {0, 0, 2, 0};
  all->pci = {0x8086, chip().device, 0x8086, chip().device, static_cast<std::uint8_t>(chip().revision)};
  std::strcpy(all->node, kNode);
  all->nodes[DRM_NODE_RENDER] = all->node;
  all->device.nodes = all->nodes;
  all->device.available_nodes = 1 << DRM_NODE_RENDER;
  all->device.bustype = DRM_BUS_PCI;
  all->device.businfo.pci = &all->bus;
  all->device.deviceinfo.pci = &all->pci;
  return &all->device;
}

int open_as(const char* path, int flags, unsigned mode) {
  if (std::strcmp(path, kNode) == 0) return fcntl(device().file, F_DUPFD_CLOEXEC, 0);
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, unsigned) : 0;
  va_end(rest);
  return open_as(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const unsigned mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, unsigned) : 0;
  va_end(rest);
  return open_as(path, flags, mode);
}

int ioctl(int file, unsigned long request, ...) noexcept {
  va_list rest;
  va_start(rest, request);
  void* const data = va_arg(rest, void*);
  va_end(rest);
  if (((request >> 8) & 0xff) != DRM_IOCTL_BASE || !is_ours(file))
    return static_cast<int>(syscall(SYS_ioctl, file, request, data));
  const int error = command(request, data);
  if (error != 0) errno = error;
  return error == 0 ? 0 : -1;
}

// What libdrm finds out from /sys.
int drmGetDevices2(std::uint32_t, drmDevicePtr* devices, int room) {
  if (devices && room > 0) devices[0] = describe();
  return 1;
}

int drmGetDevice2(int, std::uint32_t, drmDevicePtr* found) {
  *found = describe();
  return 0;
}

int drmGetNodeTypeFromFd(int) { return DRM_NODE_RENDER; }
char* drmGetRenderDeviceNameFromFd(int) { return strdup(kNode); }
char* drmGetDeviceNameFromFd2(int) { return strdup(kNode); }
}
#pragma GCC visibility pop
