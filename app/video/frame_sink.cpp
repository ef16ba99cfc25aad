#include "app/video/frame_sink.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/usage_error.h"
#include "app/video/picture_sequence.h"
#include "app/video/recorder.h"
#include "base/error.h"
#include "base/file.h"

namespace fascia {
namespace {

// Single files that contain a picture: neither audio only nor playlists.
constexpr auto kContainers = std::to_array<std::string_view>(
    {".mp4",  ".webm", ".gif",  ".mkv", ".mov",   ".avi",  ".m4v", ".ogv", ".ogg",  ".mpg", ".mpeg", ".wmv",
     ".flv",  ".ts",   ".m2ts", ".mts", ".m2t",   ".vob",  ".dvd", ".mxf", ".3gp",  ".3g2", ".f4v",  ".ismv",
     ".isma", ".asf",  ".wtv",  ".rm",  ".swf",   ".gxf",  ".dv",  ".psp", ".nut",  ".roq", ".cpk",  ".apng",
     ".webp", ".avif", ".y4m",  ".yuv", ".rgb",   ".ivf",  ".obu", ".264", ".h264", ".265", ".h265", ".hevc",
     ".h261", ".h263", ".m1v",  ".m2v", ".mjpeg", ".mjpg", ".drc", ".vc2"});

constexpr const char* kPattern = "expected a number of pictures as in frames/%05d.png";

bool is_pattern(const std::filesystem::path& path) { return path.filename().string().find('%') != std::string::npos; }

}  // namespace

void require_frames(const std::string& option, const std::filesystem::path& path) {
  const std::string ending = lower_ending(path), where = option + " " + path.string();
  std::error_code ec;
  if (std::filesystem::exists(path, ec) && !std::filesystem::is_regular_file(path, ec))
    throw UsageError(where, "is not a regular file", "expected a regular file or a new name");
  if (ending == ".png") {
    if (!picture_names(path))
      throw UsageError(where, "has no place for the number of a picture", "expected one as in frames/%05d.png");
    return;
  }
  if (is_pattern(path)) throw UsageError(where, "is a pattern of other files than pictures", kPattern);
  if (std::find(kContainers.begin(), kContainers.end(), ending) == kContainers.end())
    throw UsageError(where, "is not a video format",
                     "expected .mp4, .webm, .gif, .mkv, .mov, .avi, another video that ffmpeg writes, or pictures as "
                     "frames/%05d.png");
  require_writable(path);
}

std::unique_ptr<FrameSink> open_frames(const std::filesystem::path& path, const FrameFormat& format,
                                       const Provenance& provenance) {
  if (lower_ending(path) == ".png") return std::make_unique<PictureSequence>(path, format, without_moment(provenance));
  if (is_pattern(path)) throw Error(path.string(), "is a pattern of other files than pictures", kPattern);
  return std::make_unique<Recorder>(path, format, without_moment(provenance));
}

}  // namespace fascia
