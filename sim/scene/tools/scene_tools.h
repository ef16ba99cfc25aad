// Rigid things that tissue touches, as a scene states them (keys "contact", "ground", "obstacles", "instruments"):
// shapes, where they are, and how they move. All lengths in m, in the axes of the scene.
#pragma once
#include <Eigen/Core>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fascia {

struct SphereShape {
  Eigen::Vector3d center{0, 0, 0};
  double radius = 0;
  bool operator==(const SphereShape&) const = default;
};
struct CapsuleShape {  // all points within `radius` of the segment
  Eigen::Vector3d from{0, 0, 0}, to{0, 0, 0};
  double radius = 0;
  bool operator==(const CapsuleShape&) const = default;
};
struct BoxShape {
  Eigen::Vector3d center{0, 0, 0}, half_size{0, 0, 0};
  double round = 0;  // radius of its edges, within half_size
  bool operator==(const BoxShape&) const = default;
};
struct PlaneShape {  // the half space behind it is solid
  Eigen::Vector3d point{0, 0, 0}, normal{0, 1, 0};
  bool operator==(const PlaneShape&) const = default;
};
struct CylinderShape {  // with flat ends
  Eigen::Vector3d from{0, 0, 0}, to{0, 0, 0};
  double radius = 0;
  double round = 0;  // radius of the edges of its ends, within the cylinder
  bool operator==(const CylinderShape&) const = default;
};
struct SolidMesh;                          // sim/tool/solid_mesh.h
struct MeshShape {                         // inside of a closed surface
  std::string file;                        // as other paths of the scene
  double scale = 1;                        // [m] of a unit of the file
  std::shared_ptr<const SolidMesh> solid;  // of tools (Model::tools); absent in a scene
  bool operator==(const MeshShape& other) const { return file == other.file && scale == other.scale; }
};
using ToolShape = std::variant<SphereShape, CapsuleShape, BoxShape, PlaneShape, CylinderShape, MeshShape>;
/// As scenes call them, [ToolShape::index()].
inline constexpr std::array<const char*, std::variant_size_v<ToolShape>> kShapeNames = {"sphere", "capsule",  "box",
                                                                                        "plane",  "cylinder", "mesh"};

/// Two mirrored copies of a shape that turn about a hinge through the origin of the instrument. They point along the
/// instrument's axis nearest to the middle of the shape and close on the plane through that axis and the hinge.
struct JawsShape {
  ToolShape shape;
  Eigen::Vector3d axis{0, 0, 1};  // of the hinge
  double open_deg = 30;           // between the jaws, fully open
  bool operator==(const JawsShape&) const = default;
};

struct ContactSettings {
  double friction = 0.3;  // Coulomb's coefficient of tools that state none
  double thickness = 0;   // [m] of the tissue's skin: tools touch it at half of that from the surface
  double stiffness = 1;   // factor of the penalty that the solver chooses
  bool bodies = false;    // whether bodies touch each other
  bool self = false;      // whether the tissue of a body touches itself
  bool operator==(const ContactSettings&) const = default;
};

struct Ground {
  double height = 0;  // [m] along y
  std::optional<double> friction;
  bool operator==(const Ground&) const = default;
};

struct Obstacle {
  std::string name;
  ToolShape shape;
  Eigen::Vector3d position{0, 0, 0}, rotate_deg{0, 0, 0};  // rotated about x, then y, then z; then moved
  std::optional<double> friction;
  bool operator==(const Obstacle&) const = default;
};

struct Instrument {
  std::string name;
  std::variant<ToolShape, JawsShape> shape;
  std::optional<double> friction;

  struct Key {
    double time = 0;  // [s]
    Eigen::Vector3d position{0, 0, 0}, rotate_deg{0, 0, 0};
    double grip = 0;  // of jaws: 0 open to 1 closed
    bool operator==(const Key&) const = default;
  };
  std::vector<Key> path;  // times ascending, one at least; angles change along with the positions
  bool smooth = false;    // "interpolate": ease in and out at every key
  bool operator==(const Instrument&) const = default;
};

/// Everything that the bodies of a scene may touch.
struct SceneTools {
  ContactSettings contact;
  std::optional<Ground> ground;
  std::vector<Obstacle> obstacles;
  std::vector<Instrument> instruments;
  bool empty() const { return !ground && obstacles.empty() && instruments.empty(); }
  bool operator==(const SceneTools&) const = default;
};

/// f(shape, key) for the shapes of all obstacles and instruments; key: "obstacles[0].shape".
template <class Tools, class F>
void for_each_shape(Tools& tools, F&& f) {
  for (std::size_t o = 0; o < tools.obstacles.size(); ++o)
    f(tools.obstacles[o].shape, "obstacles[" + std::to_string(o) + "].shape");
  for (std::size_t i = 0; i < tools.instruments.size(); ++i) {
    const std::string key = "instruments[" + std::to_string(i) + "].";
    auto& shape = tools.instruments[i].shape;
    if (auto* jaws = std::get_if<JawsShape>(&shape))
      f(jaws->shape, key + "jaws.shape");
    else
      f(std::get<ToolShape>(shape), key + "shape");
  }
}

}  // namespace fascia
