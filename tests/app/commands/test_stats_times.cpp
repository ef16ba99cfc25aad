// The time of a step has the same definition in the panel Statistics and in stats.json.
// Covers: app/state/window_state
#include <catch2/catch.hpp>

#include "app/state/window_state.h"
#include "sim/output/stats.h"

using namespace fascia;

TEST_CASE("the panel shows the same time of a step as stats.json: of one step, the median", "[stats]") {
  Statistics statistics;
  std::vector<double> all;
  statistics.add_steps(900, 1, true, all);  // including compilation
  statistics.add_steps(40, 4, false, all);  // four steps in a frame
  statistics.add_steps(12, 1, false, all);
  statistics.add_steps(400, 1, false, all);  // delayed by a wait
  CHECK(all == std::vector<double>{900, 10, 10, 10, 10, 12, 400});
  CHECK(statistics.solve.count() == 6);
  CHECK(statistics.solve.median() == 10);
  CHECK(percentiles({10, 10, 10, 10, 12, 400}).median == statistics.solve.median());
  CHECK(percentiles(all).median == 10);

  INFO("of the last 30");
  for (int i = 0; i < 30; ++i) statistics.add_steps(20 + i, 1, false, all);
  CHECK(statistics.solve.median() == percentiles({all.end() - 30, all.end()}).median);
  CHECK(RecentValues().median() == 0);
}
