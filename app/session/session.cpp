#include "app/session/session.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "app/session/shown_look.h"

namespace fascia {
namespace {

constexpr double kFootDepth = 0.05;   // of the radius: a body with held vertices so near its lowest point stands on it
constexpr double kLeastTissue = 0.5;  // of the size in the picture that it has without instruments
constexpr double kLeftView = 1.25;    // times the size at rest, beyond which a body has left the view of frame()

const Eigen::Vector4f kPlainMetal(0, 0, 0, 0), kHighlight(0.95f, 0.62f, 0.30f, 0.45f);  // tints

std::vector<std::uint32_t> drawn_vertices(const VisualSurface& surface) {
  std::vector<std::uint32_t> vertices;
  for (const Triangle& t : surface.triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

double lowest_of(const VisualSurface& surface) {
  double lowest = std::numeric_limits<double>::max();
  for (const Triangle& t : surface.triangles)
    for (const std::uint32_t v : t) lowest = std::min(lowest, surface.rest_positions[v].y());
  return surface.triangles.empty() ? 0 : lowest;
}

// Positions of the tets' vertices.
std::vector<Eigen::Vector3d> places_of(const Model& model, const std::vector<Eigen::Vector3d>& displacement) {
  std::vector<char> used(model.rest_positions.size());
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) used[v] = 1;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t v = 0; v < used.size(); ++v)
    if (used[v])
      places.push_back(displacement.empty() ? model.rest_positions[v]
                                            : Eigen::Vector3d(model.rest_positions[v] + displacement[v]));
  return places;
}

void append_placed(const ShapeMesh& mesh, const RigidPose& pose, RigidSurface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  const Eigen::Matrix3f axes = pose.axes.cast<float>();
  const Eigen::Vector3f origin = pose.origin.cast<float>();
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    surface.positions.emplace_back() << axes * mesh.positions[v] + origin, 0;
    surface.normals.emplace_back() << axes * mesh.normals[v], 0;
  }
  const bool mirrored = axes.determinant() < 0;
  for (const Triangle& t : mesh.triangles)
    surface.triangles.push_back({first + t[0], first + t[mirrored ? 2 : 1], first + t[mirrored ? 1 : 2]});
}

std::vector<std::uint32_t> held_vertices(const Model& model) {
  const std::vector<char> held = model.held();
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < held.size(); ++v)
    if (held[v]) vertices.push_back(v);
  return vertices;
}

ShownValues together(const ShownValues& a, const ShownValues& b) {
  return {std::min(a.smallest, b.smallest), std::max(a.largest, b.largest), std::max(a.usual, b.usual)};
}

}  // namespace

Session::Session(Graphics& graphics, Scene scene, Model built, bool use_reference, const Progress& progress)
    : simulation(std::move(scene), std::move(built), graphics.programs.get(), use_reference, progress),
      surface_(drawn_surface(simulation.model)),
      description_(describe(graphics)) {
  renderer_.emplace(
      *simulation.programs(), surface_.triangles, static_cast<std::uint32_t>(surface_.rest_positions.size()),
      drawn_marks(simulation.model, held_vertices(simulation.model)), surface_.rest_positions, surface_.colors);
  const Model& model = simulation.model;
  box_min_.setConstant(1e300);
  box_max_.setConstant(-1e300);
  for (const Tet& tet : model.tets)
    for (const std::uint32_t v : tet) {
      box_min_ = box_min_.cwiseMin(model.rest_positions[v]);
      box_max_ = box_max_.cwiseMax(model.rest_positions[v]);
    }
  look.quality = graphics.live;
  look.center = 0.5 * (box_min_ + box_max_);
  look.radius = 0.5 * (box_max_ - box_min_).norm();
  const std::vector<char> held = model.held();
  for (std::size_t v = 0; v < held.size(); ++v)
    stands_ = stands_ || (held[v] && model.rest_positions[v].y() < box_min_.y() + kFootDepth * look.radius);
  forget_ground();
  if (simulation.scene.camera)
    look_from(*simulation.scene.camera);
  else
    frame();
  measure_extent();
  set_display(simulation.scene.display);
}

void Session::frame() {
  camera.frame(box_min_, box_max_);
  const Eigen::Vector3d tissue = 0.5 * (box_min_ + box_max_);
  const auto depth = [&](const Camera& view) { return (tissue - view.eye).dot(view.forward()); };
  const double alone = depth(camera);
  Eigen::AlignedBox3d shown(box_min_, box_max_);
  const std::vector<Tool>& tools = simulation.model.tools;
  for (std::size_t t = tools.size() - simulation.scene.tools.instruments.size(); t < tools.size(); ++t) {
    if (std::holds_alternative<PlaneShape>(tools[t].shape)) continue;
    Eigen::AlignedBox3d wider = shown;
    const ShapeMesh mesh = shape_mesh(tools[t].shape, look.radius);
    for (std::size_t piece = 0; piece < tools[t].piece_count(); ++piece) {
      const RigidPose pose = tools[t].pose_of_piece(piece, tools[t].place(0));
      for (const Eigen::Vector3f& p : mesh.positions) wider.extend(pose.to_scene(p.cast<double>()));
    }
    Camera view = camera;
    view.frame(wider.min(), wider.max());
    if (!(alone >= kLeastTissue * depth(view))) continue;
    shown = wider;
    camera = view;
  }
}

void Session::lay_ground(double below) {
  if (const std::optional<Ground>& ground = simulation.scene.tools.ground) {
    laid_ground_ = look.ground_height = ground->height;
    return;
  }
  laid_ground_ = look.ground_height = below - (stands_ ? 0 : 0.4 * look.radius);
}

void Session::forget_ground() { lay_ground(lowest_of(surface_)); }

void Session::follow_ground(Session* beside, bool now) {
  if (!display().ground || simulation.scene.tools.ground) return;
  measure_lowest(now);
  if (!beside) return;
  beside->measure_lowest(now);
  look.ground_height = beside->look.ground_height = std::min(look.ground_height, beside->look.ground_height);
}

void Session::set_material_entries(const std::vector<MaterialEntries>& entries) {
  simulation.set_material_entries(entries);
  lowest_.reset();
}

void Session::lift_ground(Session* beside) {
  for (Session* session : {this, beside})
    if (session) session->look.ground_height = session->laid_ground_;
  settle_ground(beside);
}

void Session::measure_lowest(bool now) {
  if (surface_.triangles.empty()) return;
  GpuSolver& solver = *simulation.gpu();
  if (!lowest_) lowest_.emplace(*simulation.programs(), solver.positions(), drawn_vertices(surface_));
  std::optional<double> lowest = lowest_->take(false);
  if (now || !lowest_->pending()) {
    solver.publish();
    lowest_->request();
  }
  if (now) lowest = lowest_->take(true);
  if (lowest) look.ground_height = std::min(look.ground_height, *lowest);
}

void Session::measure_extent() { extent = camera.extent(places_of(simulation.model, {})); }

void Session::frame_bodies(double aspect, const Eigen::Vector2d& part) {
  const std::vector<Eigen::Vector3d> places = places_of(simulation.model, simulation.state().displacement);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places) box.extend(place);
  if (box.isEmpty() || !box.diagonal().allFinite()) return;
  camera.reach = 1;
  camera.fit(box.min(), box.max(), aspect, part);
  extent = camera.extent(places);
  lay_ground(std::min(box_min_.y(), box.min().y()));
}

void Session::frame_with_motion() {
  Eigen::AlignedBox3d box(box_min_, box_max_);
  const std::vector<Eigen::Vector3d> places = places_of(simulation.model, simulation.state().displacement);
  for (const Eigen::Vector3d& place : places) box.extend(place);
  if (!box.diagonal().allFinite() || box.diagonal().norm() < kLeftView * (box_max_ - box_min_).norm()) return;
  camera.frame(box.min(), box.max());
  extent = camera.extent(places);
}

void Session::look_from(const CameraSettings& view) {
  camera.eye = view.eye;
  camera.target = view.target;
  camera.up = view.up;
  camera.fov_deg = view.fov_deg;
}

void Session::set_display(const DisplaySettings& display) {
  const bool other_range = display.color != this->display().color || display.range != this->display().range;
  simulation.scene.display = display;
  simulation.gpu()->set_color(display.color);
  if (other_range) forget_range();
  show(display, look);
  if ((needs_regions() || display.section || display.tets) && !regions_)
    regions_ = drawn_regions(simulation.scene, simulation.model, surface_);
  if (needs_regions() != renderer_->has_regions())
    renderer_->set_regions(needs_regions() ? regions_->of_triangle : std::vector<std::uint32_t>());
  if (display.section || display.tets)
    renderer_->set_tets({regions_->tets, regions_->of_tet, closed_around_tets(simulation.model)});
  show_error();
}

void Session::follow_error() {
  const bool shown = display().color == ColorBy::error;
  if (true_error.update(simulation, shown || follow_true_error) && shown) show_error();
  if (RecoveredMap::has(display().color) && recovered.update(simulation, display().color)) show_error();
}

void Session::measure_error() {
  if (display().color == ColorBy::error) true_error.measure(simulation);
  if (RecoveredMap::has(display().color)) recovered.measure(simulation, display().color);
  show_error();
}

void Session::forget_errors() {
  true_error.forget();
  recovered.forget();
}

// One buffer has the values of each of these heat maps; none are known before the first measurement.
void Session::show_error() {
  const bool is_recovered = RecoveredMap::has(display().color);
  if (!is_recovered && display().color != ColorBy::error) return;
  std::vector<float> values(simulation.model.rest_positions.size(), 0);
  if (is_recovered && !recovered.values(display().color).empty()) values = recovered.values(display().color);
  if (!is_recovered && true_error.result()) values = true_error.result()->distance;
  simulation.gpu()->set_vertex_errors(values);
}

std::optional<ShownValues> Session::measure_shown(bool now) {
  GpuSolver& solver = *simulation.gpu();
  ShownRange& range = *solver.shown_range();
  const bool wait = now || !shown_;  // without a range the colors would have another meaning for some frames
  if (const auto shown = range.take(false); shown && !wait) shown_ = shown;
  if (wait || !range.pending()) {
    solver.publish();
    range.request();
  }
  if (wait) shown_ = range.take(true);
  return shown_;
}

void Session::follow_range(Session* beside, bool now) {
  if (!simulation.gpu()->shown_range()) return;
  compared_ = measure_shown(now);
  if (const auto other =
          beside && beside->display().color == display().color ? beside->measure_shown(now) : std::nullopt)
    compared_ = compared_ ? together(*compared_, *other) : *other;
  if (!display().range) {
    if (compared_) fascia::follow_range(*compared_, display().color, range_only_grows, range_);
    if (range_) look.range = *range_;
  }
  if (beside) beside->look.range = look.range;
}

std::array<bool, 2> Session::beyond_range() const {
  if (!look.heat_map || !compared_) return {false, false};
  const double rounding = 1e-6 * static_cast<double>(look.range.cwiseAbs().maxCoeff());
  return {compared_->smallest<look.range.x() - rounding, compared_->largest> look.range.y() + rounding};
}

void Session::forget_range() {
  shown_.reset();
  compared_.reset();
  range_.reset();
  if (!display().range) look.range = Look().range;
}

void Session::show_grabbed() {
  std::vector<std::uint32_t> grabbed;
  if (display().marks.grabs)
    for (const GrabSpring& spring : simulation.springs()) grabbed.push_back(spring.vertex);
  if (grabbed == grabbed_) return;
  renderer_->set_grabbed(drawn_marks(simulation.model, grabbed));
  grabbed_ = std::move(grabbed);
}

bool Session::needs_regions() const { return display().color == ColorBy::region || paints_.size() > 1; }

// Materials may change between any two pictures: each region has the paint of its material.
void Session::show_paints() {
  const Model& model = simulation.model;
  std::vector<TissuePaint> paints;
  for (const Material& material : model.materials) paints.push_back(paint_of(material));
  if (std::equal(paints.begin() + 1, paints.end(), paints.begin())) {
    paints.resize(1);
  } else {
    if (!regions_) regions_ = drawn_regions(simulation.scene, model, surface_);
    const std::vector<TissuePaint> of_material = std::exchange(paints, {});
    for (const std::uint32_t tet : regions_->first_tet) paints.push_back(of_material[model.tet_material[tet]]);
  }
  if (paints == paints_) return;
  paints_ = std::move(paints);
  renderer_->set_paints(paints_);
  if (needs_regions() != renderer_->has_regions())
    renderer_->set_regions(needs_regions() ? regions_->of_triangle : std::vector<std::uint32_t>());
}

// The ground that tissue touches is the drawn one.
void Session::show_tools() {
  const std::vector<Tool>& tools = simulation.model.tools;
  if (tools.empty()) return;
  const std::vector<ToolPlace> places = simulation.tool_places();
  if (places == shown_places_ && highlighted == shown_highlight_) return;
  if (tool_meshes_.empty())
    for (const Tool& tool : tools) tool_meshes_.push_back(shape_mesh(tool.shape, 2 * look.radius));
  RigidSurface surface;
  for (std::size_t t = simulation.scene.tools.ground ? 1 : 0; t < tools.size(); ++t)
    for (std::size_t piece = 0; piece < tools[t].piece_count(); ++piece) {
      append_placed(tool_meshes_[t], tools[t].pose_of_piece(piece, places[t]), surface);
      if (highlighted) surface.tints.resize(surface.positions.size(), t == *highlighted ? kHighlight : kPlainMetal);
    }
  renderer_->set_rigid(surface);
  shown_places_ = places;
  shown_highlight_ = highlighted;
}

void Session::draw(Framebuffer& framebuffer, std::span<const GrabArrow> grabs, const gl::Buffer* positions) {
  GpuSolver& solver = *simulation.gpu();
  solver.publish();
  show_grabbed();
  show_paints();
  show_tools();
  framebuffer.bind();
  if (!display().marks.grabs) grabs = {};
  renderer_->draw(SurfaceView{positions ? positions : &solver.positions()}, camera, look, grabs, framebuffer);
  framebuffer.resolve();
}

}  // namespace fascia
