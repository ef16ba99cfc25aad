// A file that a scene refers to, as it was when the scene was written (scene key "files"): a changed file is then
// noticed, and a scene can carry the files that it needs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace fascia {

inline constexpr std::uint64_t kMostCarried = std::uint64_t{1} << 30;  // [bytes] of a file that a scene carries

struct KnownFile {
  /// As written in the scene's keys. For a file that another one names (.mtl of .obj, .ele of .node): the path as seen
  /// from the scene.
  std::string path;
  std::uint64_t size = 0, hash = 0;             // of the content: bytes, content_hash
  std::shared_ptr<const std::string> deflated;  // the content, if the scene carries it (base/deflate.h)

  bool operator==(const KnownFile& other) const {
    return path == other.path && size == other.size && hash == other.hash && !deflated == !other.deflated;
  }
};

/// A file that was read for a scene (Model::files).
struct ReadFile {
  std::string key;   // of the scene: "bodies[0].mesh"
  std::string name;  // the name in the file that refers to it, for such a file; else empty
  KnownFile file;
  std::filesystem::path place;  // on disk; empty if the scene carries it
};

std::uint64_t content_hash(std::string_view content);
/// Whether a file on disk has this content. False if it cannot be read.
bool has_content(const std::filesystem::path& place, const KnownFile& file);
/// The content of a carried file. `where`: the scene's file. Throws Error if the content is damaged.
std::string carried_content(const KnownFile& file, const std::string& where);

}  // namespace fascia
