// The parts and instances of an Abaqus file, before its meshes are read.
#pragma once
#include <string>
#include <vector>

#include "sim/mesh/io/formats.h"

namespace fascia {

struct AbaqusInstance {
  std::string name, part;
};

struct AbaqusOutline {
  std::size_t parts = 0;
  std::vector<AbaqusInstance> instances;  // names differ beyond upper and lower case
};

/// Of the file and of those that it includes. `in` stands at the beginning and stays there.
AbaqusOutline abaqus_outline(Scanner in, const ReadBeside& read_beside);

}  // namespace fascia
