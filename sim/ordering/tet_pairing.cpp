#include "sim/ordering/tet_pairing.h"

#include <algorithm>
#include <array>

#include "sim/mesh/tet_faces.h"

namespace fascia {
namespace {

// The even permutations that move a corner to the last place.
constexpr int kCornerLast[4][4] = {{1, 3, 2, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 1, 2, 3}};

// The corner of `a` that `b` does not have; -1 if there is not exactly one.
int corner_apart(const Tet& a, const Tet& b) {
  int apart = -1;
  for (int k = 0; k < 4; ++k) {
    if (std::find(b.begin(), b.end(), a[k]) != b.end()) continue;
    if (apart >= 0) return -1;
    apart = k;
  }
  return apart;
}

Tet with_last(const Tet& tet, int corner) {
  const int* order = kCornerLast[corner];
  return {tet[order[0]], tet[order[1]], tet[order[2]], tet[order[3]]};
}

// Matches tets across faces.
class Matching {
 public:
  explicit Matching(const std::vector<Tet>& tets)
      : tets_(tets), across_(tets_across_faces(tets)), partner_(tets.size(), kNoTet), choices_(tets.size(), 0) {
    for (std::size_t k = 0; k < across_.size(); ++k) choices_[k / 4] += across_[k] != kNoTet;
    for (std::uint32_t t = 0; t < tets.size(); ++t)
      if (choices_[t] == 1) forced_.push_back(t);
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      take_forced();
      if (partner_[t] == kNoTet) match(t);
    }
    take_forced();
  }
  std::uint32_t partner(std::uint32_t t) const { return partner_[t]; }

 private:
  void take_forced() {
    while (!forced_.empty()) {
      const std::uint32_t t = forced_.back();
      forced_.pop_back();
      if (partner_[t] == kNoTet) match(t);
    }
  }
  // Matches with the neighbor that has the fewest choices, if any is free.
  void match(std::uint32_t t) {
    std::uint32_t best = kNoTet;
    for (std::uint32_t k = 4 * t; k < 4 * t + 4; ++k) {
      const std::uint32_t other = across_[k];
      if (other == kNoTet || partner_[other] != kNoTet) continue;
      Tet a = tets_[t], b = tets_[other];
      if (align_at_face(a, b) && (best == kNoTet || choices_[other] < choices_[best])) best = other;
    }
    if (best == kNoTet) return;
    partner_[t] = best;
    partner_[best] = t;
    for (const std::uint32_t gone : {t, best})
      for (std::uint32_t k = 4 * gone; k < 4 * gone + 4; ++k) {
        const std::uint32_t other = across_[k];
        if (other != kNoTet && partner_[other] == kNoTet && --choices_[other] == 1) forced_.push_back(other);
      }
  }

  const std::vector<Tet>& tets_;
  std::vector<std::uint32_t> across_, partner_;
  std::vector<char> choices_;  // number of free neighbors of each tet
  std::vector<std::uint32_t> forced_;
};

}  // namespace

bool align_at_face(Tet& a, Tet& b) {
  const int x = corner_apart(a, b), y = corner_apart(b, a);
  if (x < 0 || y < 0) return false;
  const Tet first = with_last(a, x);
  Tet second = with_last(b, y);
  for (int turn = 0; turn < 3 && second[0] != first[0]; ++turn)
    std::rotate(second.begin(), second.begin() + 1, second.begin() + 3);
  if (second[0] != first[0] || second[1] != first[2] || second[2] != first[1]) return false;
  a = first;
  b = second;
  return true;
}

TetPairing pair_tets(const std::vector<Tet>& tets, const std::vector<std::uint32_t>& order) {
  std::vector<Tet> ordered;
  ordered.reserve(order.size());
  for (const std::uint32_t t : order) ordered.push_back(tets[t]);
  const Matching matching(ordered);
  TetPairing pairing;
  pairing.order.reserve(order.size());
  std::vector<std::uint32_t> single, second;
  for (std::uint32_t t = 0; t < ordered.size(); ++t) {
    const std::uint32_t other = matching.partner(t);
    if (other == kNoTet) single.push_back(order[t]);
    if (other == kNoTet || other < t) continue;
    pairing.order.push_back(order[t]);
    second.push_back(order[other]);
  }
  pairing.pair_count = static_cast<std::uint32_t>(second.size());
  pairing.order.insert(pairing.order.end(), single.begin(), single.end());
  pairing.order.insert(pairing.order.end(), second.begin(), second.end());
  return pairing;
}

}  // namespace fascia
