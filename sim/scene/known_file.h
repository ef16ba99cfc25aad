// A file that a scene refers to, as it was when the scene was written (scene key "files"): so that another one in its
// place is noticed, and a scene can carry what it needs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace fascia {

inline constexpr std::uint64_t kMostCarried = std::uint64_t{1} << 30;  // [bytes] of a file that a scene carries

struct KnownFile {
  /// As the scene's keys have it. Of a file that another one names (.mtl of .obj, .ele of .node): as seen from the
  /// scene.
  std::string path;
  std::uint64_t size = 0, hash = 0;             // of the content: bytes, content_hash
  std::shared_ptr<const std::string> deflated;  // the content, where the scene carries it (base/deflate.h)

  bool operator==(const KnownFile& other) const {
    return path == other.path && size == other.size && hash == other.hash && !deflated == !other.deflated;
  }
};

/// A file that was read for a scene (Model::files).
struct ReadFile {
  std::string key;   // of the scene: "bodies[0].mesh"
  std::string name;  // as that file names it, where it is one beside it; else empty
  KnownFile file;
  std::filesystem::path place;  // on disk; empty where the scene carries it
};

std::uint64_t content_hash(std::string_view content);
/// Whether a file on disk has this content. One that cannot be read does not.
bool has_content(const std::filesystem::path& place, const KnownFile& file);
/// Of a file that is carried. `where`: the scene's file. Throws Error for content that is damaged.
std::string carried_content(const KnownFile& file, const std::string& where);

}  // namespace fascia
