// fascia bench contact: what contact with tools costs in a step, and how many iterations it takes.
#pragma once

namespace fascia {

class Bench;
/// contact_cost.csv: times and dispatches of steps over points and meshes, beside the same meshes without tools.
/// contact_iterations.csv: iterations to 10, 1 and 0.1 % of exact steps, for each shape. Prints both.
void bench_contact(Bench& bench);

}  // namespace fascia
