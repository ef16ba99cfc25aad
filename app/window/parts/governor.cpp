#include "app/window/parts/governor.h"

#include <algorithm>
#include <cmath>

namespace fascia {
namespace {

// Frames longer than kSlow for kUntilLower lower the quality, if pictures are a reason; frames shorter than kFast for
// kUntilHigher raise it. The gap is wider than what a level saves, so that levels do not alternate. [s]
constexpr double kSlow = 0.040, kFast = 0.025, kUntilLower = 0.5, kUntilHigher = 2, kBetweenChanges = 1;
constexpr double kPictureMatters = 0.012;
constexpr double kAveragedOver = 0.25, kGap = 0.5;  // a longer frame is a moved window or a suspended program

}  // namespace

void Governor::follow(double frame, double picture, bool moves, bool compiled) {
  moves_ = moves;
  if (!acts_ || !moves || compiled || frame > kGap) return;
  const double newest = frame_ > 0 ? 1 - std::exp(-frame / kAveragedOver) : 1;
  frame_ += newest * (frame - frame_);
  picture_ += newest * (picture - picture_);
  since_change_ += frame;
  slow_ = frame_ > kSlow && picture_ > kPictureMatters ? slow_ + frame : 0;
  fast_ = frame_ < kFast ? fast_ + frame : 0;
  const int change = slow_ >= kUntilLower ? 1 : fast_ >= kUntilHigher ? -1 : 0;
  const int next = std::clamp(level_ + change, 0, kLevels);
  if (next == level_ || since_change_ < kBetweenChanges) return;
  level_ = next;
  slow_ = fast_ = since_change_ = 0;
}

Quality lowered(Quality quality, int level) {
  if (level >= 1) quality.shadow_taps = 1;
  if (level >= 2) quality.shadow_every = 2;  // an older map would throw shadows of tissue that has moved on
  return quality;
}

}  // namespace fascia
