// Undo and redo of changes by users.
#include "app/state/undo_history.h"

#include <catch2/catch.hpp>

using namespace fascia;

namespace {

Tunables one_material() {
  Tunables tunables;
  tunables.materials.push_back({Material{}, {{"core", MaterialOverride{}}}});
  return tunables;
}

}  // namespace

TEST_CASE("every change is one entry, undone and redone in order") {
  UndoHistory history;
  std::vector<Tunables> states{one_material()};
  history.restart(states[0]);
  CHECK_FALSE(history.can_undo());
  for (int i = 1; i <= 4; ++i) {
    Tunables next = states.back();
    next.solver.iterations += i;
    states.push_back(next);
    history.follow(next);
    history.follow(next);  // no change
  }
  CHECK(history.entries().size() == 4);
  for (int i = 3; i >= 1; --i) {
    const Tunables back = history.undo();
    CHECK(back == states[i]);
    history.accept(back);
  }
  CHECK(history.redone_next().text == "Iterations: 11 to 13");
  const Tunables again = history.redo();
  CHECK(again == states[2]);
  history.accept(again);
  history.follow(again);
  CHECK(history.can_redo());

  INFO("a new change ends what could be done again");
  Tunables other = again;
  other.gravity.x() = 1;
  history.follow(other);
  CHECK_FALSE(history.can_redo());
  CHECK(history.entries().size() == 3);

  INFO("changes by a replay are no entries");
  Tunables replayed = other;
  replayed.solver.substeps = 3;
  history.accept(replayed);
  history.follow(replayed);
  CHECK(history.entries().size() == 3);

  INFO("the oldest go");
  for (int i = 0; i < 300; ++i) {
    replayed.solver.iterations = 50 + i % 7;
    history.follow(replayed);
  }
  CHECK(history.entries().size() == UndoHistory::kMostEntries);
  while (history.can_undo()) history.accept(history.undo());
}

TEST_CASE("several changes at once are one entry, and a restart forgets all of them") {
  UndoHistory history;
  Tunables now = one_material();
  history.restart(now);
  CHECK(history.complete());
  now.solver.iterations = 12;
  now.display.wireframe = true;
  now.gravity.y() = -1;
  history.follow(now);
  REQUIRE(history.entries().size() == 1);
  CHECK(history.undone_next().text.ends_with(" and 2 more"));
  CHECK(history.undone_next().before == one_material());
  CHECK(history.undone_next().after == now);
  for (std::size_t i = 0; i < UndoHistory::kMostEntries; ++i) {
    now.solver.iterations += 1;
    history.follow(now);
  }
  CHECK_FALSE(history.complete());
  CHECK(history.done() == UndoHistory::kMostEntries);
  history.restart(now);
  CHECK(history.complete());
  CHECK(history.entries().empty());
  CHECK_FALSE(history.can_undo());
  CHECK_FALSE(history.can_redo());
  history.follow(now);
  CHECK(history.entries().empty());
}
