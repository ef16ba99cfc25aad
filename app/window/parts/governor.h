// Lowers the quality of a window's pictures, one level at a time, while a software renderer cannot draw them fast
// enough, and raises it again. Only pictures in which something moves: a still picture, and everything that is not the
// window's own picture, has full quality. Steps are never affected.
#pragma once
#include <array>

#include "render/view/quality.h"

namespace fascia {

class Governor {
 public:
  static constexpr int kLevels = 2;  // below the full quality

  /// `acts` false: always full quality.
  explicit Governor(bool acts) : acts_(acts) {}

  /// After every frame: how long it took, and how long its picture took without steps [s]. Frames in which something
  /// was compiled say nothing.
  void follow(double frame, double picture, bool moves, bool compiled);
  /// Of the next picture: 0 is the full quality.
  int level() const { return moves_ ? level_ : 0; }
  bool acts() const { return acts_; }

 private:
  bool acts_;
  bool moves_ = false;
  int level_ = 0;
  double slow_ = 0, fast_ = 0;      // [s] for which frames have been slow or fast without a break
  double since_change_ = 1e9;       // [s]
  double frame_ = 0, picture_ = 0;  // averages over the last half second [s]
};

/// The quality of a moving picture at a level of Governor.
Quality lowered(Quality quality, int level);

/// What a level saves, for the panels; the first is the full quality.
inline constexpr std::array<const char*, Governor::kLevels + 1> kLevelNames{"full", "hard edges of shadows",
                                                                            "shadows of every 2nd picture"};

}  // namespace fascia
