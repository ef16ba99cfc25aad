// A fuzz target is one file, fuzz_NAME.cpp, with FUZZ_TARGET(NAME) { read `data`, use the result }. An input may be
// read or refused with an Error; everything else is a bug. The same file is built as a libFuzzer program (preset fuzz,
// scripts/fuzz.sh) and as a part of test_fuzz, which replays corpus/NAME/ and crashes/NAME/ and cheap mutations of them
// in every run of the tests.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "sim/mesh/io/mesh_io.h"

namespace fascia::fuzz {

using Target = void (*)(std::string_view data);

/// Whether the target read the input; false if it refused it with an Error, which must be one line of printable text.
bool run(Target target, std::string_view data);

/// Throws std::logic_error if a guarantee of a reader is violated.
void require(bool kept, const char* promise);

/// Checks the guarantees of every reader about a mesh that it returns.
void check_mesh(const TetMesh& mesh);
/// As check_mesh, or of a surface.
void check_file(const MeshFile& file);

#ifdef FASCIA_LIBFUZZER
#define FUZZ_TARGET(name)                                                              \
  static void target_##name(std::string_view data);                                    \
  extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) { \
    fascia::fuzz::run(target_##name, {reinterpret_cast<const char*>(bytes), size});    \
    return 0;                                                                          \
  }                                                                                    \
  static void target_##name(std::string_view data)
#else
/// All targets of the program, by name.
std::map<std::string, Target>& targets();

#define FUZZ_TARGET(name)                                                                                            \
  static void target_##name(std::string_view data);                                                                  \
  [[maybe_unused]] static const bool name##_is_known = fascia::fuzz::targets().emplace(#name, target_##name).second; \
  static void target_##name(std::string_view data)
#endif

}  // namespace fascia::fuzz
