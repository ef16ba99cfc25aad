// fascia bench contact: what contact with tools costs in a step, and how many iterations it takes.
#pragma once

namespace fascia {

class Bench;
/// contact_cost.csv: times and dispatches of steps over points and meshes, beside the same meshes without tools.
/// contact_iterations.csv: iterations to 10, 1 and 0.1 % of exact steps, for each shape. contact_probe.csv: the error
/// of a motion under a sliding probe. Prints them.
void bench_contact(Bench& bench);
void bench_contact_probe(Bench& bench);  // its last part

}  // namespace fascia
