#include "fascia/fascia.h"

TEST_CASE("Errors keep their types across the library's boundary") {
  try {
    fascia::read_mesh("/nowhere/at.msh");
    FAIL("expected an Error");
  } catch (const std::runtime_error& error) {
    CHECK(dynamic_cast<const fascia::Error*>(&error));
    CHECK_FALSE(dynamic_cast<const fascia::Interrupted*>(&error));
    CHECK(std::string(error.what()).starts_with("/nowhere/at.msh: "));
  }
  CHECK(std::string(fascia::Error("where", "what", "expected this").what()) == "where: what; expected this");
}
