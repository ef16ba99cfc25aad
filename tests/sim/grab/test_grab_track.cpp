#include <catch2/catch.hpp>

#include <random>

#include "sim/grab/grab_track.h"

using namespace fascia;
using Eigen::Vector3d;

namespace {

// Springs as a grab creates them: the original place of each vertex plus the offset.
std::vector<GrabSpring> springs_of(const std::vector<Vector3d>& taken, const Vector3d& offset,
                                   std::uint32_t first = 0) {
  std::vector<GrabSpring> springs;
  for (const Vector3d& at : taken) springs.push_back({first++, at + offset, 100});
  return springs;
}

std::vector<Vector3d> places(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-0.3, 0.3);
  std::vector<Vector3d> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back({coordinate(random), coordinate(random), coordinate(random)});
  return result;
}

}  // namespace

TEST_CASE("springs that a grab moves are one move, and the move gives back their bits") {
  const std::vector<Vector3d> taken = places(80, 1);
  GrabTrack track;
  track.restart(springs_of(taken, {0.01, -0.02, 0.003}));
  Vector3d offset(0.01, -0.02, 0.003);
  for (int step = 0; step < 500; ++step) {
    offset += Vector3d(1.7e-3, 1e-5 * step, -3.3e-4);
    std::vector<GrabSpring> springs = springs_of(taken, offset);
    const std::vector<GrabSpring> asked = springs;
    const auto move = track.follow(springs);
    REQUIRE(move);
    CHECK(move->parts.size() == 1);
    REQUIRE(track.fits(*move));
    REQUIRE(track.moved(*move) == springs);
    for (std::size_t i = 0; i < springs.size(); ++i)  // a few roundings of numbers below 2
      REQUIRE((springs[i].target - asked[i].target).lpNorm<Eigen::Infinity>() <= 16 * 2.3e-16 * 2);
  }
}

TEST_CASE("two grabs are a move of two parts") {
  const std::vector<Vector3d> left = places(20, 2), right = places(30, 3);
  const auto both = [&](const Vector3d& a, const Vector3d& b) {
    std::vector<GrabSpring> springs = springs_of(left, a), more = springs_of(right, b, 100);
    springs.insert(springs.end(), more.begin(), more.end());
    return springs;
  };
  GrabTrack track;
  track.restart(both({0, 0, 0}, {0, 0, 0}));
  std::vector<GrabSpring> springs = both({0.1, 0, 0}, {0, -0.2, 0.05});
  const auto move = track.follow(springs);
  REQUIRE(move);
  REQUIRE(move->parts.size() == 2);
  CHECK(move->parts[0].count == 20);
  CHECK(move->parts[1].count == 30);
  CHECK(track.moved(*move) == springs);
}

TEST_CASE("springs with another grip are not a move") {
  const std::vector<Vector3d> taken = places(30, 4);
  GrabTrack track;
  const std::vector<GrabSpring> base = springs_of(taken, {0, 0, 0});
  track.restart(base);
  const auto is_move = [&](std::vector<GrabSpring> springs) { return track.follow(springs).has_value(); };
  CHECK(is_move(base));
  std::vector<GrabSpring> other = base;
  other[7].stiffness = 99;
  CHECK_FALSE(is_move(other));
  other = base;
  other[7].vertex = 1000;
  CHECK_FALSE(is_move(other));
  other = base;
  other.pop_back();
  CHECK_FALSE(is_move(other));
  CHECK_FALSE(is_move({}));
  other = base;
  for (std::size_t i = 0; i < other.size(); ++i)
    other[i].target *= 1 + 0.1 * static_cast<double>(i);  // stretched, not moved
  CHECK_FALSE(is_move(other));
  CHECK_FALSE(track.fits({{{31, {0, 0, 0}}}}));
  CHECK_FALSE(track.fits({{{29, {0, 0, 0}}}}));
}
