// Where labels stand: inside the picture, and clear of each other and of what else is drawn over it.
#pragma once
#include <vector>

namespace fascia {

/// A rectangle of a picture, y down.
struct Box {
  float left = 0, top = 0, right = 0, bottom = 0;
  bool operator==(const Box&) const = default;
};

class LabelPlaces {
 public:
  /// `gap` between labels and all else.
  LabelPlaces(const Box& picture, float gap) : picture_(picture), gap_(gap) {}

  void keep_clear(const Box& box) {
    taken_.push_back({box.left - gap_, box.top - gap_, box.right + gap_, box.bottom + gap_});
  }
  /// The free place for a label that is nearest to where it is wanted; where none is free, the one that hides least. It
  /// is taken then.
  Box place(const Box& wanted);

 private:
  float hidden(const Box& label) const;  // area of it that is taken

  Box picture_;
  float gap_;
  std::vector<Box> taken_;
};

}  // namespace fascia
