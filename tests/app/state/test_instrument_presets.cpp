// Instruments to add: above the bodies, sized by them, and valid in a scene file.
#include "app/state/instrument_presets.h"

#include <catch2/catch.hpp>

#include "base/file.h"
#include "sim/scene/scene_write.h"
#include "sim/tool/shape_distance.h"
#include "sim/tool/tool.h"
#include "tests/support/support.h"

using namespace fascia;
using namespace fascia::test;
using Eigen::Vector3d;

TEST_CASE("every preset begins above the bodies, and scales with them") {
  for (const InstrumentPresetInfo& info : kInstrumentPresets)
    for (const double size : {0.01, 1.0}) {
      CAPTURE(info.name, size);
      const Eigen::AlignedBox3d bodies(Vector3d(-size, 0, -size), Vector3d(size, size, size));
      SceneTools scene;
      scene.instruments.push_back(preset_instrument(info.preset, bodies, {}));
      CHECK(scene.instruments.front().name == info.name);
      const Tool tool = tools_of(scene).front();
      double nearest = 1e300;
      for (std::size_t piece = 0; piece < tool.piece_count(); ++piece) {
        const RigidPose pose = tool.pose_of_piece(piece, tool.place(0));
        for (double x = -1; x <= 1; x += 0.1)
          for (double z = -1; z <= 1; z += 0.1)
            nearest = std::min(nearest, distance_to(tool.shape, pose.to_local(size * Vector3d(x, 1, z))).distance);
      }
      INFO("distance from the top " << nearest);
      CHECK(nearest > 0.02 * size);
      CHECK(nearest < size);
    }
}

TEST_CASE("a second instrument of a kind has another name") {
  const Eigen::AlignedBox3d bodies(Vector3d(0, 0, 0), Vector3d(1, 1, 1));
  CHECK(preset_instrument(InstrumentPreset::probe, bodies, {"probe"}).name == "probe 2");
  CHECK(preset_instrument(InstrumentPreset::probe, bodies, {"probe 2", "probe"}).name == "probe 3");
}

TEST_CASE("a scene with every preset is written and opens again") {
  const TemporaryFolder folder;
  Scene scene = open_scene(source_dir() / "assets/scenes/cube.json");
  const Eigen::AlignedBox3d bodies(Vector3d(-0.05, 0, -0.05), Vector3d(0.05, 0.1, 0.05));
  for (const InstrumentPresetInfo& info : kInstrumentPresets)
    scene.tools.instruments.push_back(preset_instrument(info.preset, bodies, {}));
  write_file(folder / "scene.json", scene_to_json(scene, folder.path()));
  CHECK(open_scene(folder / "scene.json").tools == scene.tools);
}
