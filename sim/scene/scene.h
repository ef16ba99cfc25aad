// A scene as its JSON file states it (format: docs/guide/scenes.md), before any mesh is read.
// The reader is strict: an unknown key (with the nearest known one), a wrong type or a value out of range is an Error
// "file: bodies[0].materials.default.young_modulus: is -5; expected 0.001 to 1e+14 Pa"; a syntax error is
// "file:line:column: ...".
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sim/material/material.h"
#include "sim/scene/known_file.h"
#include "sim/scene/mesh_frame.h"
#include "sim/scene/scene_grab.h"
#include "sim/scene/scene_selection.h"
#include "sim/scene/settings/display.h"
#include "sim/scene/settings/solver_settings.h"
#include "sim/scene/tools/scene_tools.h"

namespace fascia {

struct Transform {  // applied scale, then rotation, then translation
  double scale = 1;
  Eigen::Vector3d rotate_deg = Eigen::Vector3d::Zero();  // about x, then y, then z
  Eigen::Vector3d translate = Eigen::Vector3d::Zero();   // [m]
  bool operator==(const Transform&) const = default;
};

struct PrescribedMotion {           // path from rest to target over [start, start + duration], constant afterwards
  std::optional<Selection> select;  // with translate/rotate/scale
  Eigen::Vector3d translate = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
  double angle_deg = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double scale = 1;                // about center
  std::string targets;             // or: CSV `index,x,y,z` of final positions [m]
  double start = 0, duration = 0;  // [s]
  bool operator==(const PrescribedMotion&) const = default;
};

/// One entry of "materials": only the given keys replace those of "default".
struct MaterialOverride {
  std::optional<double> young_modulus, poisson_ratio, density, damping;
  std::optional<MaterialModel> model;
  std::optional<double> mooney_ratio = std::nullopt;
  const TissueLook* look = nullptr;
  std::optional<std::array<double, 3>> color = std::nullopt;
  bool operator==(const MaterialOverride&) const = default;
};

/// Of the displacements in a body's tets: linear between four corners, or quadratic with a vertex in the middle of
/// every edge, too (sim/elements).
enum class ElementOrder { linear, quadratic };
inline constexpr std::array kElementOrders = {ElementOrder::linear, ElementOrder::quadratic};
inline const char* name_of(ElementOrder order) { return order == ElementOrder::linear ? "linear" : "quadratic"; }

struct Body {
  std::string name;               // no other body or tool has it; that of the mesh's file, if the scene has none
  std::string mesh;               // as written (Scene::resolve); tets, or a closed surface to be filled with tets
  std::optional<int> resolution;  // cells along the longest side for the filling; absent: several thousand tets
  ElementOrder elements = ElementOrder::linear;
  LengthUnit unit = LengthUnit::m;  // of the mesh's coordinates
  UpAxis up = UpAxis::y;            // of the mesh's axes, turned to y before the transform
  Transform transform;
  Material material;                                                       // "default"
  std::vector<std::pair<std::string, MaterialOverride>> region_materials;  // region number or group name
  std::vector<TetRegion> regions;                                          // over those of the mesh file
  std::vector<Selection> fixed;
  std::vector<PrescribedMotion> prescribed;
  std::variant<Eigen::Vector3d, std::string> initial_velocity = Eigen::Vector3d(0, 0, 0);  // [m/s] or CSV path
  std::string surface;  // drawn instead of the tets' boundary
  bool operator==(const Body&) const = default;
};

/// From the mesh file's coordinates to the scene's: `unit`, then `up`, then `transform`.
Eigen::Affine3d placement(const Body& body);

/// Values of a mesh opened on its own that its user left open. They are chosen once the mesh is read
/// (sim/bare_mesh/settled_model.h).
struct Unsettled {
  bool unit = true, up = true, supports = true, stiffness = true, law = true;
  std::vector<std::string> overrides;  // those of open_scene, to open the mesh again
  bool operator==(const Unsettled&) const = default;
};

struct CameraSettings {
  Eigen::Vector3d eye{0, 0.3, 1}, target{0, 0, 0}, up{0, 1, 0};
  double fov_deg = 40;  // across the shorter side of the picture
  bool operator==(const CameraSettings&) const = default;
};

/// One place of a camera that moves in pictures and videos. A value that a key omits is that of the key before, and
/// that of the camera in the first one.
struct CameraKey {
  double time = 0;                      // [s] simulated
  std::optional<Eigen::Vector3d> eye;   // [m]; or the next three, around the target
  std::optional<double> orbit_deg;      // from the camera's place about `up`, to the right
  std::optional<double> elevation_deg;  // of the eye above the plane through the target across `up`, -89 to 89
  std::optional<double> zoom;           // 2: half the camera's distance from its target
  std::optional<Eigen::Vector3d> target;
  std::optional<double> fov_deg;
  bool operator==(const CameraKey&) const = default;
};

/// Scene keys "camera.keys" and "camera.smooth".
struct CameraMotion {
  std::vector<CameraKey> keys;  // times ascending; empty: the camera stands still
  bool smooth = true;           // a curve through the keys, else straight from key to key
  bool operator==(const CameraMotion&) const = default;
};

struct Scene {
  std::filesystem::path file;  // of the scene, or of a mesh opened on its own
  std::string title;
  Eigen::Vector3d gravity{0, -9.81, 0};
  std::vector<Body> bodies;
  std::vector<ScriptedGrab> grabs;
  std::size_t option_grabs = 0;  // number of those, at the end, that --grab added: messages name the option
  SceneTools tools;
  SolverSettings solver;
  std::optional<CameraSettings> camera;  // absent: framed on the bodies
  CameraMotion camera_motion;
  DisplaySettings display;
  double duration = 2;                 // [s] of `run` and `--video` when neither --steps nor --time is given
  std::vector<KnownFile> files;        // known data of all or some files that the paths above name
  std::vector<std::string> notes;      // of the reader, one line each: files found at other places
  std::optional<Unsettled> unsettled;  // of a mesh opened on its own; a scene file is taken as it is
  bool operator==(const Scene&) const = default;

  /// Resolves a path as written: relative to the scene file's folder, or with "assets:" to the folder of the shipped
  /// files.
  std::filesystem::path resolve(const std::string& path) const;
  const KnownFile* recorded(const std::string& path) const;  // in `files`; null if unknown
  bool carries(const std::string& path) const;
};

/// Opens a scene (JSON) or a mesh on its own, which leaves `unsettled` values. `overrides` are --set texts
/// "KEY=VALUE", or "--grab TEXT" or "--instrument TEXT" (sim/scene/grab_text.h); a KEY that starts with a key of bodies
/// (materials., fixed., transform., ...) means body 0. An override's error names "--set KEY".
Scene open_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});
/// As open_scene of a scene file with this content.
Scene read_scene_content(const std::filesystem::path& path, std::string_view content,
                         const std::vector<std::string>& overrides = {});

/// The scene as JSON text that open_scene reads back to the same scene, with paths relative to `folder`
/// (sim/scene/scene_paths.h).
std::string scene_to_json(const Scene& scene, const std::filesystem::path& folder);
/// The same without `files`: the definition of the scene, without the origin of its files.
std::string parameters_to_json(const Scene& scene, const std::filesystem::path& folder);

}  // namespace fascia
