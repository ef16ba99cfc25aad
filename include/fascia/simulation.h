// The simulation of one scene: opening, steps, state, settings, grabs and measurements.
//
//   fascia::Scene scene;
//   scene.bodies.push_back({.mesh = fascia::make_box(4, 4, 4, {0.1, 0.1, 0.1})});
//   fascia::Simulation simulation(scene);
//   simulation.step(60);
//
// The vertices of a simulation are those of the meshes, body after body, in each mesh's order. Vertices in no tet are
// kept and do not move. Arrays over the vertices are [vertex_count][3] numbers: x, y, z of the first vertex, of the
// second one, and so on. Any call can throw Error; calls that need the graphics device can throw ContextLost.
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
  /// Options of opening a scene.
  struct OpenOptions {
    /// Values of the scene file to replace, for example "solver.iterations=20". The syntax is that of the program's
    /// option --set.
    std::vector<std::string> set{};
    /// If true, the double-precision reference solver (Newton's method) replaces the GPU. It is exact and slow.
    bool reference = false;
    /// Progress and cancellation of the opening.
    Control control{};
  };

  /// The range of a body in the arrays of a simulation (Simulation::bodies()).
  struct BodyRange {
    std::string name{};            // The name of the body.
    std::size_t vertex_begin = 0;  // The index of the body's first vertex.
    std::size_t vertex_count = 0;  // The number of the body's vertices.
    std::size_t tet_begin = 0;     // The index of the body's first tet in Simulation::tets().
    std::size_t tet_count = 0;     // The number of the body's tets.
  };

  /// The identifier of a grab, from its beginning to its release.
  enum class Grab : std::uint32_t {};

  /// One scene that is simulated. A simulation can be moved and not copied.
  class FASCIA_EXPORT Simulation {
   public:
    // Opening and closing.
    /// Opens a scene (.json) or a mesh. What a mesh without a scene leaves open is chosen for it and stated in notes().
    /// Throws Error for files that cannot be read, values out of range and a context without OpenGL (unless
    /// OpenOptions::reference is set), and Interrupted if OpenOptions::control stops the work.
    static Simulation open(const std::string& path, Context context = Context::own(), const OpenOptions& options = {});
    /// Makes a simulation from arrays. Throws Error for arrays of wrong size, numbers that are not finite, values and
    /// indices out of range, a mesh without a usable tet, a non-empty OpenOptions::set and a context without OpenGL
    /// (unless OpenOptions::reference is set), and Interrupted if OpenOptions::control stops the work.
    explicit Simulation(const Scene& scene, Context context = Context::own(), const OpenOptions& options = {});
    /// Moves a simulation. The source can afterwards only be assigned to or destroyed.
    Simulation(Simulation&&) noexcept;
    Simulation& operator=(Simulation&&) noexcept;
    /// Ends the simulation. If it computes in the caller's context, that context must be current.
    ~Simulation();

    /// Returns the context that the simulation computes in.
    const Context& context() const;
    /// Returns the repairs of the mesh and the warnings of the opening, one line each.
    std::vector<std::string> notes() const;

    // Constants. The spans stay valid as long as the simulation lives.
    /// Returns the number of vertices.
    std::size_t vertex_count() const;
    /// Returns the number of simulated tets.
    std::size_t tet_count() const;
    /// Returns the rest positions X [m], [vertex_count][3].
    std::span<const double> rest_positions() const;
    /// Returns the vertices of the simulated tets, [tet_count][4]. All tets have positive volume; repeated and flat
    /// tets of the mesh are left out.
    std::span<const std::uint32_t> tets() const;
    /// Returns the vertices of the surface triangles, [triangle_count][3]. The normals point outwards.
    std::span<const std::uint32_t> surface_triangles() const;
    /// Returns the indices of the fixed vertices, ascending. Vertices of motions are not among them.
    std::span<const std::uint32_t> fixed() const;
    /// Returns the lumped masses of the vertices with the current densities [kg], [vertex_count]. Their sum is the
    /// mass. Their sums with velocities are the momentum of linear tets, but not that of quadratic ones, half of whose
    /// mass moves with the centroid: Diagnostics::momentum has that of both.
    std::vector<double> masses() const;
    /// Returns the ranges of the bodies, in the order of the scene.
    std::vector<BodyRange> bodies() const;

    // Time.
    /// Makes `count` steps of Settings::time_step, none if it is 0. Returns the number of steps made. It is smaller
    /// than `count` if `stop` was requested; this is not an error. Throws Error if `count` is negative.
    int step(int count = 1, const std::stop_token& stop = {});
    /// Returns the simulated time [s].
    double time() const;
    /// Returns to the start of the scene. Materials, settings, gravity and grabs stay as they are.
    void reset();
    /// Returns true if nothing moves, so that steps only advance the time (Settings::rest_speed).
    bool asleep() const;
    /// Returns the index of a vertex that has diverged: it is not finite, or it has left the scene. The result is empty
    /// if the state is valid. The call waits for the device.
    std::optional<std::uint32_t> diverged_vertex();
    /// Returns to the last valid state, at rest, after a divergence. Throws Error with the reference solver.
    void restore_valid();
    /// Finds the static equilibrium under the current weight and grabs and the ends of motions. The simulation
    /// continues from it. A request of `stop` ends the search; the report then has converged = false. `news` receives
    /// the report after every part of the search. Throws Error if gravity pulls at a part without support.
    StaticReport solve_static(const std::stop_token& stop = {},
                              const std::function<void(const StaticReport&)>& news = {});

    // State. Calls that read wait for the device. Calls that set throw Error, and change nothing, for arrays of wrong
    // size and numbers that are not finite. set_positions() and set_velocities() ignore the values at fixed and moved
    // vertices.
    /// Returns the positions x [m], [vertex_count][3].
    std::vector<double> positions() const;
    /// Returns the velocities v [m/s], [vertex_count][3].
    std::vector<double> velocities() const;
    /// Writes the positions x [m] into the caller's array, [vertex_count][3]. Throws Error for another size.
    void read_positions(std::span<double> to) const;
    /// Writes the positions x [m] in float, [vertex_count][3]. Throws Error for another size.
    void read_positions(std::span<float> to) const;
    /// Writes the velocities v [m/s] into the caller's array, [vertex_count][3]. Throws Error for another size.
    void read_velocities(std::span<double> to) const;
    /// Writes the velocities v [m/s] in float, [vertex_count][3]. Throws Error for another size.
    void read_velocities(std::span<float> to) const;
    /// Sets the positions x [m], [vertex_count][3]. The velocities stay as they are.
    void set_positions(std::span<const double> positions);
    /// Sets the velocities v [m/s], [vertex_count][3]. The positions stay as they are.
    void set_velocities(std::span<const double> velocities);
    /// Returns the state: displacements [m], velocities [m/s] and time [s].
    State save() const;
    /// Continues from a state of this scene. The values at fixed and moved vertices apply as well. Throws Error, and
    /// changes nothing, for arrays of wrong size, numbers that are not finite and a negative time.
    void restore(const State& state);
    /// Writes the state to a file. The file's ending decides the format: .vtu, .msh, .csv, .obj (the surface) or .inp.
    /// Throws Error for another ending and for a file that cannot be written.
    void write(const std::string& path) const;
    /// Returns the name of an OpenGL buffer with the current positions in float: at least [vertex_count] vec4 of x, y,
    /// z [m] and an unused w. A program draws it in the same context without a copy. The name is valid as long as the
    /// simulation lives; only this call updates the content. Throws Error for a simulation without OpenGL.
    unsigned position_buffer();

    // Parameters. They can be changed at any time and act from the next step on.
    /// Returns the settings of the solver.
    Settings settings() const;
    /// Sets the settings of the solver. Throws Error for values out of range, and for a method that cannot simulate the
    /// laws of the scene.
    void set_settings(const Settings& settings);
    /// Returns the acceleration of gravity [m/s^2].
    Vec3 gravity() const;
    /// Sets the acceleration of gravity [m/s^2]. Throws Error for numbers that are not finite.
    void set_gravity(const Vec3& gravity);
    /// Returns the number of materials: one for each body, and one for each region with a material of its own.
    std::size_t material_count() const;
    /// Returns the name of a material, for example "beam: default" or "liver: 2". Throws Error for an index out of
    /// range.
    std::string material_name(std::size_t index) const;
    /// Returns a material. Throws Error for an index out of range.
    Material material(std::size_t index) const;
    /// Sets a material. Throws Error for an index or values out of range, and for a law that the current method cannot
    /// simulate.
    void set_material(std::size_t index, const Material& material);

    // Grabs. A grab is a set of springs that pull tissue to a target. A call for a grab that does not exist, or that
    // was released, throws Error.
    /// Grabs the free vertices among `vertices`: the faces of the surface whose corners are all among them, evenly, or
    /// each alike where they span no face. `stiffness` [N/m] is that of all together; with 0 it follows from the
    /// tissue. The target is the current center until move() changes it. Throws Error if no vertex is free, for an
    /// index out of range and for a negative stiffness.
    Grab grab(std::span<const std::uint32_t> vertices, double stiffness = 0);
    /// Grabs one vertex. Units and errors are those of grab().
    Grab grab_vertex(std::uint32_t vertex, double stiffness = 0);
    /// Grabs a round patch around the point of the tissue that is nearest to `point` [m] in the current positions. The
    /// springs are stiff in the middle and fade out at `radius` [m]. `stiffness` [N/m] is that of all springs together;
    /// with 0 it follows from the tissue. Throws Error if no vertex of the patch is free, for a radius that is not
    /// positive, for a negative stiffness and for numbers that are not finite.
    Grab grab_patch(const Vec3& point, double radius, double stiffness = 0);
    /// Moves the target of the grab to `target` [m]. The springs then pull the center of the grab (the mean of its
    /// vertices, weighted by their shares) to the target; its shape is that at the beginning of the grab. Throws Error
    /// for numbers that are not finite.
    void move(Grab grab, const Vec3& target);
    /// Returns the target [m].
    Vec3 target(Grab grab) const;
    /// Returns the stiffness of all springs of the grab together [N/m].
    double stiffness(Grab grab) const;
    /// Returns the force of the grab on the tissue in the current state [N].
    Vec3 force(Grab grab) const;
    /// Ends a grab. Its identifier is invalid afterwards.
    void release(Grab grab);
    /// Returns the grabs, in the order in which they were made.
    std::vector<Grab> grabs() const;

    // Measurements. These calls wait for the device.
    /// Returns energies, momenta, forces and the quality of the current state.
    Diagnostics diagnostics();
    /// Returns the forces of the supports [N], body by body, the fixed vertices first.
    std::vector<Support> supports() const;
    /// Returns stresses [Pa], volume ratios and strains of all tets. TetFields states the shapes.
    TetFields tet_fields() const;
    /// Returns the von Mises stress of all tets [Pa], [tet_count].
    std::vector<double> von_mises() const;
    /// Returns the stress recovered at the vertices [Pa]. RecoveredStress states the shapes. The CPU computes it, which
    /// takes as long as some steps.
    RecoveredStress recovered_stress() const;

   private:
    struct FASCIA_HIDDEN Impl;
    FASCIA_HIDDEN explicit Simulation(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
  };

}  // namespace api
}  // namespace fascia
