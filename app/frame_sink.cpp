#include "app/frame_sink.h"

#include "app/picture_sequence.h"
#include "app/recorder.h"
#include "sim/error.h"
#include "sim/file.h"

namespace fascia {

std::unique_ptr<FrameSink> open_frames(const std::filesystem::path& path, const FrameFormat& format, const Provenance& provenance) {
  if (lower_ending(path) == ".png") return std::make_unique<PictureSequence>(path, format, without_moment(provenance));
  if (path.filename().string().find('%') != std::string::npos)
    throw Error(path.string(), "is a pattern of other files than pictures", "expected a number of pictures as in frames/%05d.png");
  return std::make_unique<Recorder>(path, format, without_moment(provenance));
}

}  // namespace fascia
