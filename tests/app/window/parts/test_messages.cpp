// The message of a window: an error becomes one, and stays longer than other messages.
#include <catch2/catch.hpp>
#include <cmath>
#include <new>

#include "app/window/parts/messages.h"
#include "app/window/parts/opening_screen.h"
#include "base/error.h"

using namespace fascia;

TEST_CASE("a failure becomes an error, a cancellation a message, and success leaves none") {
  Messages messages;
  CHECK_FALSE(messages.any());
  CHECK_FALSE(messages.is_error());
  CHECK(messages.attempt([] {}));
  CHECK_FALSE(messages.any());
  CHECK_FALSE(messages.attempt([] { throw Error("a.json", "is empty", "expected a scene"); }));
  CHECK(messages.is_error());
  CHECK_THAT(messages.text(), Catch::Contains("a.json: is empty"));
  CHECK_FALSE(messages.attempt([] { throw std::bad_alloc(); }));
  CHECK(messages.text() == "Out of memory");
  CHECK_FALSE(messages.attempt([] { throw Cancelled{"liver.json"}; }));
  CHECK(messages.text() == "liver.json was not opened");
  CHECK_FALSE(messages.is_error());
  messages.clear();
  CHECK_FALSE(messages.any());
}

TEST_CASE("a message disappears by itself soon, an error does not") {
  Messages messages;
  CHECK(std::isinf(messages.seconds_left()));
  messages.say("Saved");
  CHECK(messages.seconds_left() > 1);
  CHECK(messages.seconds_left() <= 4);
  messages.say("No such file", true);
  CHECK(messages.seconds_left() > 1000);
}
