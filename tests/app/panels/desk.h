// A session and panels over pictures.
#pragma once
#include "app/overlay/overlay.h"
#include "app/panels/panels.h"
#include "tests/support/headless.h"
#include "tests/support/support.h"

namespace fascia::test {

struct Desk {
  Graphics graphics = open_graphics(headless(), false);
  Overlay overlay{graphics};
  Session session{graphics, open_scene(source_dir() / "assets/scenes/cube.json"), false};
  WindowState state;
};

}  // namespace fascia::test
