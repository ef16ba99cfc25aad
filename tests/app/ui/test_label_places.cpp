// Labels stay inside the picture, without overlap with each other and with existing content.
#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "app/ui/label_places.h"

using namespace fascia;

namespace {

bool overlap(const Box& a, const Box& b) {
  constexpr float kTouching = 0.05f;
  return std::min(a.right, b.right) - std::max(a.left, b.left) > kTouching &&
         std::min(a.bottom, b.bottom) - std::max(a.top, b.top) > kTouching;
}

}  // namespace

TEST_CASE("a label without obstacles is placed where it is wanted", "[label_places]") {
  LabelPlaces places({0, 0, 800, 600}, 3);
  places.keep_clear({600, 200, 780, 400});
  const Box wanted{100, 100, 160, 124};
  CHECK(places.place(wanted) == wanted);
  const Box again = places.place(wanted);
  CAPTURE(again.left, again.top);
  CHECK_FALSE(overlap(again, wanted));
}

TEST_CASE("labels stay inside the picture and hide nothing as long as there is space", "[label_places]") {
  std::mt19937 random(7);
  const auto number = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  int moved = 0, placed = 0;
  for (int picture = 0; picture < 200; ++picture) {
    const Box edges{number(0, 200), 0, number(600, 1200), number(300, 800)};
    LabelPlaces places(edges, 3);
    std::vector<Box> taken;
    for (int i = 0; i < 3; ++i) {
      const float left = number(edges.left, edges.right), top = number(0, edges.bottom);
      taken.push_back({left, top, left + number(10, 150), top + number(10, 150)});
      places.keep_clear(taken.back());
    }
    for (int i = 0; i < 8; ++i) {
      // Most labels are wanted close together, some outside the picture.
      const float left = i < 6 ? edges.left + 0.6f * (edges.right - edges.left) : number(-200, 1400),
                  top = i < 6 ? 0.5f * edges.bottom : number(-200, 1000);
      const Box wanted{left, top, left + 60, top + 24}, box = places.place(wanted);
      CAPTURE(picture, i, wanted.left, wanted.top, box.left, box.top);
      CHECK(box.right - box.left == Approx(60));
      CHECK(box.left >= edges.left);
      CHECK(box.right <= edges.right + 0.01f);
      CHECK(box.top >= edges.top);
      CHECK(box.bottom <= edges.bottom + 0.01f);
      for (const Box& other : taken) CHECK_FALSE(overlap(box, other));
      taken.push_back(box);
      ++placed;
      moved += !(box == wanted);
    }
  }
  CAPTURE(moved, placed);
  CHECK(moved > placed / 2);
  CHECK(moved < placed);
}

TEST_CASE("a label without free space stays inside the picture", "[label_places]") {
  LabelPlaces places({0, 0, 100, 40}, 3);
  places.keep_clear({0, 0, 100, 40});
  const Box box = places.place({90, 30, 150, 54});
  CAPTURE(box.left, box.top);
  CHECK(box.left >= 0);
  CHECK(box.right <= 100);
  CHECK(box.top >= 0);
  CHECK(box.bottom <= 40);
}
