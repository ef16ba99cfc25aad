// One scene that is simulated.
//
//   fascia::Scene scene;
//   scene.bodies.push_back({.mesh = fascia::make_box(4, 4, 4, {0.1, 0.1, 0.1})});
//   fascia::Simulation simulation(scene);
//   simulation.step(60);
//
// Vertices are those of the mesh, body after body, in the mesh's order; those in no tet are kept and do not move.
// Arrays of vertices are [vertex_count][3] numbers: x, y, z of the first vertex, of the second one, and so on. Every
// call may throw Error; those that need the graphics device may throw ContextLost.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "fascia/context.h"
#include "fascia/control.h"
#include "fascia/diagnostics.h"
#include "fascia/scene.h"
#include "fascia/state.h"

namespace fascia {
FASCIA_INLINE namespace api {
  struct OpenOptions {
    std::vector<std::string>
        set{};  // "solver.iterations=20": keys of the scene to be replaced, as --set of the program
    // The double-precision reference solver (Newton's method) instead of the GPU: exact, and slow
    bool reference = false;
    Control control{};
  };

  /// Where the arrays of a body begin.
  struct BodyRange {
    std::string name{};
    std::size_t vertex_begin = 0, vertex_count = 0, tet_begin = 0, tet_count = 0;
  };

  enum class Grab : std::uint32_t {};  // names a grab from its beginning to its release

  class FASCIA_EXPORT Simulation {
   public:
    /// Opens a scene (JSON) or a mesh alone, which is then held at its lowest vertices. Throws Error for what cannot be
    /// read or is out of range, Interrupted.
    static Simulation open(const std::string& path, Context context = Context::own(), const OpenOptions& options = {});
    /// From arrays. OpenOptions::set does not apply. Throws Error for arrays that do not fit together, positions that
    /// are not finite, indices out of range, a mesh without a usable tet, Interrupted.
    explicit Simulation(const Scene& scene, Context context = Context::own(), const OpenOptions& options = {});
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    ~Simulation();  // with the caller's context current, if it computes there

    const Context& context() const;
    std::vector<std::string> notes() const;  // repairs of the mesh and warnings, one line each

    // What does not change.
    std::size_t vertex_count() const;
    std::size_t tet_count() const;
    std::span<const double> rest_positions() const;  // [vertex_count][3] X [m]
    std::span<const std::uint32_t> tets()
        const;  // [tet_count][4] that are simulated: of positive volume, repeated and flat ones left out
    std::span<const std::uint32_t> surface_triangles() const;  // [triangle_count][3] vertices; normals point outwards
    std::span<const std::uint32_t> fixed() const;              // ascending; vertices of motions not included
    std::vector<double> masses() const;                        // [vertex_count] [kg] with the densities as they are now
    std::vector<BodyRange> bodies() const;

    // Time.
    /// Makes `count` steps of settings().time_step. Returns how many were made: fewer where `stop` was requested.
    int step(int count = 1, const std::stop_token& stop = {});
    double time() const;  // [s]
    void reset();         // to the scene's start; materials, settings, gravity and grabs stay
    bool asleep() const;  // whether steps only let time pass, since nothing moves (settings.rest_speed)
    /// A vertex that is no longer finite or has left the scene; none: the state is sound. Waits for the device.
    std::optional<std::uint32_t> diverged_vertex();
    /// Back to the last state that was found sound, at rest, after a vertex was lost. Throws Error with the reference
    /// solver.
    void restore_valid();
    /// Static equilibrium under the current weight and grabs and the ends of motions. The simulation continues from it.
    /// `stop` ends it unconverged; `news` is called after every part of the search. Throws Error where gravity pulls at
    /// a part that nothing holds.
    StaticReport solve_static(const std::stop_token& stop = {},
                              const std::function<void(const StaticReport&)>& news = {});

    // State. Reading waits for the device. Setting throws Error, and changes nothing, for another size or numbers that
    // are not finite; entries of fixed and led vertices are passed over.
    std::vector<double> positions() const;   // [vertex_count][3] x [m]
    std::vector<double> velocities() const;  // [vertex_count][3] v [m/s]
    void read_positions(
        std::span<double> to) const;  // the same without an allocation of the caller's; [vertex_count][3]
    void read_positions(std::span<float> to) const;
    void read_velocities(std::span<double> to) const;
    void read_velocities(std::span<float> to) const;
    void set_positions(std::span<const double> positions);    // [vertex_count][3] x [m]
    void set_velocities(std::span<const double> velocities);  // [vertex_count][3] v [m/s]
    State save() const;
    void restore(const State& state);  // of this scene, fixed and led vertices included
    /// Writes the state by the file's ending: .vtu, .msh, .csv or .obj (the surface). Throws Error for another ending
    /// or a failed write.
    void write(const std::string& path) const;
    /// The name of an OpenGL buffer with the current positions in float: vec4 [vertex_count] and maybe more, x y z in
    /// meters, w unused. For drawing in the same context without a copy. The name holds as long as the simulation; its
    /// content is brought up to date by this call alone. Throws Error without a GPU.
    unsigned position_buffer();

    // What can be changed at any time, and acts from the next step on.
    Settings settings() const;
    void set_settings(const Settings& settings);
    Vec3 gravity() const;  // [m/s^2]
    void set_gravity(const Vec3& gravity);
    std::size_t material_count() const;                  // one per body, and one per region with its own
    std::string material_name(std::size_t index) const;  // "beam: default", "liver: 2"
    Material material(std::size_t index) const;
    void set_material(std::size_t index, const Material& material);

    // Grabs: springs that pull tissue to a target, as a grab does. A force is that of the grab on the tissue [N], of
    // the state as it is now.
    /// Takes hold of the free ones of `vertices`, each with an equal share of `stiffness` [N/m]; 0: from the tissue.
    /// Until it is moved its target is where they are. Throws Error where none of them is free, or for an index out of
    /// range.
    Grab grab(std::span<const std::uint32_t> vertices, double stiffness = 0);
    Grab grab_vertex(std::uint32_t vertex, double stiffness = 0);
    /// Takes hold of a round patch around the place of the tissue that is nearest to `point` [m] in the current
    /// positions: firm in the middle, fading to the rim at `radius` [m].
    Grab grab_patch(const Vec3& point, double radius, double stiffness = 0);
    /// Leads the center of the grab (the mean of its vertices, weighted by their shares) to `target` [m]; its shape
    /// stays as it was taken.
    void move(Grab grab, const Vec3& target);
    Vec3 target(Grab grab) const;       // [m]
    double stiffness(Grab grab) const;  // of all of its springs together [N/m]
    Vec3 force(Grab grab) const;        // [N]
    void release(Grab grab);            // the name means nothing afterwards
    std::vector<Grab> grabs() const;    // in the order in which they were made

    // Measurements. They wait for the device.
    Diagnostics diagnostics();
    std::vector<Support> supports() const;  // body by body, the fixed vertices first
    TetFields tet_fields() const;
    std::vector<double> von_mises() const;  // [tet_count] [Pa]

   private:
    struct FASCIA_HIDDEN Impl;
    FASCIA_HIDDEN explicit Simulation(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
  };

}  // namespace api
}  // namespace fascia
