// Labels of keys.
#include "app/ui/field_labels.h"

#include <catch2/catch.hpp>

using namespace fascia;

TEST_CASE("keys have labels, from the table or from their words") {
  CHECK(label_of_field("young_modulus") == "Young's modulus");
  CHECK(label_of_field("poisson_ratio") == "Poisson's ratio");
  CHECK(label_of_field("color") == "Heat map");
  CHECK(label_of_field("color_map") == "Color map");
  CHECK(label_of_field("rest_speed") == "Rest speed");
  CHECK(label_of_field("a_b_c") == "A b c");
  CHECK(label_of_field("") == "");
}
