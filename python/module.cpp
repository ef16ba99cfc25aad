// The Python module `fascia`, which uses only the public headers.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "fascia/fascia.h"
#include "python/arrays.h"
#include "python/values.h"

namespace fascia::python {
namespace {

using namespace py::literals;

/// A grab in Python refers to its simulation, so that its methods can query it.
struct Held {
  py::object owner;
  Grab grab;
  Simulation& simulation() const { return owner.cast<Simulation&>(); }
};

/// A Control whose stop is Ctrl-C, checked at every progress report.
Control control_of(const std::function<void(double, const std::string&)>& progress) {
  Control control;
  control.progress = [progress](double share, const char* what) {
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (progress) progress(share, what);
  };
  return control;
}

void define_measures(py::module_& m) {
  py::class_<Diagnostics>(m, "Diagnostics", "Measurements of the current state and of the last step.")
      .def_readonly("time", &Diagnostics::time, "The simulated time [s].")
      .def_readonly("kinetic", &Diagnostics::kinetic, "The kinetic energy [J].")
      .def_readonly("elastic", &Diagnostics::elastic, "The elastic energy [J].")
      .def_readonly("gravitational", &Diagnostics::gravitational,
                    "The energy of the weight [J]; 0 at the rest positions.")
      .def_readonly("volume_ratio", &Diagnostics::volume_ratio,
                    "The volume of all tets together over their volume at rest [-].")
      .def_readonly("min_det_f", &Diagnostics::min_det_f, "The smallest J = det F of all tets [-].")
      .def_readonly("max_det_f", &Diagnostics::max_det_f, "The largest J = det F of all tets [-].")
      .def_readonly("inverted", &Diagnostics::inverted, "The number of tets with J <= 0.")
      .def_readonly("max_strain", &Diagnostics::max_strain, "The largest Frobenius norm of the Green strain [-].")
      .def_readonly("max_von_mises", &Diagnostics::max_von_mises, "The largest von Mises stress [Pa].")
      .def_readonly("max_speed", &Diagnostics::max_speed, "The largest speed of a vertex [m/s].")
      .def_readonly("momentum", &Diagnostics::momentum, "The linear momentum [kg m/s], three numbers.")
      .def_readonly("angular_momentum", &Diagnostics::angular_momentum,
                    "The angular momentum about the origin [kg m^2/s], three numbers.")
      .def_readonly("reaction", &Diagnostics::reaction, "The force of all supports on the tissue [N], three numbers.")
      .def_readonly("grab_force", &Diagnostics::grab_force, "The force of all grabs on the tissue [N], three numbers.")
      .def_readonly("residual", &Diagnostics::residual,
                    "The relative residual of the last step [-]; NaN before the first step.")
      .def_readonly("iterations", &Diagnostics::iterations,
                    "The iterations of the last substep, if the tolerance or Newton's method ends them, else None.");
  py::class_<Support>(m, "Support", "The force of fixed vertices, or of those of a motion, on a body.")
      .def_readonly("body", &Support::body, "The index of the body.")
      .def_readonly("motion", &Support::motion, "The index of the motion in the body; None for the fixed vertices.")
      .def_readonly("force", &Support::force, "The force on the tissue [N], three numbers.");
  py::class_<RecoveredStress>(m, "RecoveredStress", "The Cauchy stress recovered at the vertices.")
      .def_property_readonly(
          "cauchy", [](const RecoveredStress& s) { return array_of(s.cauchy, 6); },
          "The stress [Pa], [vertex_count, 6]: xx, yy, zz, yz, xz, xy; a copy.")
      .def_property_readonly(
          "von_mises", [](const RecoveredStress& s) { return array_of(s.von_mises); },
          "The von Mises stress [Pa], [vertex_count]; a copy.")
      .def_readonly("max_von_mises", &RecoveredStress::max_von_mises, "The largest von Mises stress [Pa].")
      .def_readonly("p99_von_mises", &RecoveredStress::p99_von_mises,
                    "The von Mises stress that 1 % of the volume exceeds [Pa].");
  py::class_<StaticReport>(m, "StaticReport", "The result of the search for a static equilibrium.")
      .def_readonly("iterations", &StaticReport::iterations, "The iterations of the scene's method.")
      .def_readonly("newton_iterations", &StaticReport::newton_iterations, "The iterations of Newton's method.")
      .def_readonly("relative_residual", &StaticReport::relative_residual,
                    "The forces out of balance over the largest of weight and inner forces [-].")
      .def_readonly("converged", &StaticReport::converged,
                    "True if the relative residual is at most 1e-5, or at most the tolerance if that is not 0.");
  py::class_<Held>(m, "Grab", "Springs that pull tissue to a target. After release() every other call raises Error.")
      .def_property(
          "target", [](const Held& h) { return h.simulation().target(h.grab); },
          [](const Held& h, const Vec3& target) { h.simulation().move(h.grab, target); },
          "The point [m] to which the springs pull the center of the grab; can be assigned.")
      .def_property_readonly(
          "force", [](const Held& h) { return h.simulation().force(h.grab); },
          "The force on the tissue in the current state [N], three numbers.")
      .def_property_readonly(
          "stiffness", [](const Held& h) { return h.simulation().stiffness(h.grab); },
          "The stiffness of all springs together [N/m].")
      .def(
          "release", [](const Held& h) { h.simulation().release(h.grab); }, "Ends the grab.");
}

Context chosen(const std::optional<Context>& context, bool reference) {
  return context ? *context : reference ? Context::none() : Context::own();
}

void step(Simulation& simulation, int count) {
  if (count <= 0) simulation.step(count);  // throws Error if it is negative
  for (int i = 0; i < count; ++i) {
    {
      const py::gil_scoped_release others;
      simulation.step();
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

StaticReport solve_static(Simulation& simulation) {
  std::stop_source stop;
  bool interrupted = false;
  StaticReport report;
  {
    const py::gil_scoped_release others;
    report = simulation.solve_static(stop.get_token(), [&](const StaticReport&) {
      const py::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() == 0) return;
      interrupted = true;
      stop.request_stop();
    });
  }
  if (interrupted) throw py::error_already_set();
  return report;
}

void define_simulation(py::module_& m) {
  py::class_<Context>(m, "Context",
                      "The OpenGL context that simulations compute in. Several simulations can share one.")
      .def_static("own", &Context::own, "kind"_a = "auto",
                  "Makes a context without a window; kind is \"auto\", \"egl\" or \"osmesa\". Raises Error if that "
                  "fails.")
      .def_static(
          "current", [] { return Context::current(); },
          "Adopts the context that is current on this thread. Raises Error if there is none with OpenGL 4.3.")
      .def_static("none", &Context::none, "Makes a context without OpenGL, for the reference solver.")
      .def_property_readonly("kind", &Context::kind, "\"egl\", \"osmesa\", \"current\" or \"none\".")
      .def_property_readonly("renderer", &Context::renderer, "The name of the renderer; empty for none().")
      .def_property_readonly("software", &Context::software, "True if the CPU computes what OpenGL is asked for.");
  py::class_<Simulation>(m, "Simulation",
                         "One scene that is simulated. Arrays over the vertices are [vertex_count, 3]. A simulation "
                         "is used on one thread.")
      .def(py::init([](const Scene& scene, const std::optional<Context>& context, bool reference) {
             return Simulation(scene, chosen(context, reference), {.reference = reference});
           }),
           "scene"_a, "context"_a = py::none(), "reference"_a = false,
           "Makes a simulation of a scene. With reference=True the double-precision reference solver replaces the GPU. "
           "Raises Error for arrays that do not fit together and values out of range.")
      .def_static(
          "open",
          [](const std::string& path, const std::optional<Context>& context, const std::vector<std::string>& set,
             bool reference, const std::function<void(double, const std::string&)>& progress) {
            return Simulation::open(path, chosen(context, reference), {set, reference, control_of(progress)});
          },
          "path"_a, "context"_a = py::none(), "set"_a = std::vector<std::string>(), "reference"_a = false,
          "progress"_a = py::none(),
          "Opens a scene (.json) or a mesh. set replaces values of the scene: [\"solver.iterations=20\"]. progress is "
          "called with the completed share, 0 to 1, and the name of the next part; an exception of it ends the "
          "opening. "
          "Raises Error for what cannot be read or is out of range.")
      .def_property_readonly("context", &Simulation::context, "The context that the simulation computes in.")
      .def_property_readonly("notes", &Simulation::notes,
                             "The repairs of the mesh and the warnings of the opening, one line each.")
      .def_property_readonly("vertex_count", &Simulation::vertex_count, "The number of vertices.")
      .def_property_readonly("tet_count", &Simulation::tet_count, "The number of simulated tets.")
      .def_property_readonly(
          "rest_positions",
          [](const py::object& self) { return view_of(self.cast<const Simulation&>().rest_positions(), 3, self); },
          "The rest positions [m], [vertex_count, 3]; a view, read only.")
      .def_property_readonly(
          "tets", [](const py::object& self) { return view_of(self.cast<const Simulation&>().tets(), 4, self); },
          "The vertices of the simulated tets, [tet_count, 4]; a view, read only.")
      .def_property_readonly(
          "surface_triangles",
          [](const py::object& self) { return view_of(self.cast<const Simulation&>().surface_triangles(), 3, self); },
          "The vertices of the surface triangles, [triangle_count, 3]; a view, read only.")
      .def_property_readonly(
          "fixed", [](const py::object& self) { return view_of(self.cast<const Simulation&>().fixed(), 1, self); },
          "The indices of the fixed vertices, ascending, [fixed_count]; a view, read only.")
      .def_property_readonly(
          "masses", [](const Simulation& s) { return array_of(s.masses()); },
          "The lumped masses of the vertices [kg], [vertex_count]; a copy. Quadratic tets have another momentum "
          "(diagnostics).")
      .def_property_readonly(
          "bodies",
          [](const Simulation& s) {
            py::list names;
            for (const BodyRange& b : s.bodies())
              names.append(py::dict("name"_a = b.name, "vertex_begin"_a = b.vertex_begin,
                                    "vertex_count"_a = b.vertex_count, "tet_begin"_a = b.tet_begin,
                                    "tet_count"_a = b.tet_count));
            return names;
          },
          "The bodies: a list of dicts with name, vertex_begin, vertex_count, tet_begin and tet_count.")
      .def("step", &step, "count"_a = 1, "Makes steps of settings.time_step. Ctrl-C ends it after a step.")
      .def("solve_static", &solve_static,
           "Finds the static equilibrium, from which the simulation continues. Ctrl-C ends it. Raises Error if gravity "
           "pulls at a part without support.")
      .def("reset", &Simulation::reset, "Returns to the start of the scene; settings, materials and grabs stay.")
      .def_property_readonly("time", &Simulation::time, "The simulated time [s].")
      .def_property_readonly("asleep", &Simulation::asleep,
                             "True if nothing moves, so that steps only advance the time.")
      .def("diverged_vertex", &Simulation::diverged_vertex,
           "Returns a vertex that is not finite or has left the scene; None if the state is valid.")
      .def("restore_valid", &Simulation::restore_valid,
           "Returns to the last valid state, at rest. Raises Error with the reference solver.")
      .def_property(
          "positions", [](const Simulation& s) { return array_of(s.positions(), 3); },
          [](Simulation& s, const py::object& x) { s.set_positions(numbers_of(x)); },
          "The positions [m], [vertex_count, 3]; a copy. Assign an array to set them; values at fixed and moved "
          "vertices "
          "are ignored. Raises Error for another size.")
      .def_property(
          "velocities", [](const Simulation& s) { return array_of(s.velocities(), 3); },
          [](Simulation& s, const py::object& v) { s.set_velocities(numbers_of(v)); },
          "The velocities [m/s], [vertex_count, 3]; a copy. Assign an array to set them; values at fixed and moved "
          "vertices are ignored. Raises Error for another size.")
      .def("save", &Simulation::save, "Returns the state.")
      .def("restore", &Simulation::restore, "state"_a, "Continues from a state of this scene.")
      .def("write", &Simulation::write, "path"_a,
           "Writes the state to a file; its ending decides the format: .vtu, .msh, .csv or .obj. Raises Error for "
           "another ending or a failed write.")
      .def_property("settings", &Simulation::settings, &Simulation::set_settings,
                    "The settings of the solver; a copy. Assign settings to change them.")
      .def_property("gravity", &Simulation::gravity, &Simulation::set_gravity,
                    "The acceleration of gravity [m/s^2], three numbers; a copy. Assign three numbers to change it.")
      .def_property_readonly(
          "material_names",
          [](const Simulation& s) {
            std::vector<std::string> names;
            for (std::size_t i = 0; i < s.material_count(); ++i) names.push_back(s.material_name(i));
            return names;
          },
          "The names of the materials: one for each body and for each region with a material of its own.")
      .def("material", &Simulation::material, "index"_a = 0,
           "Returns a copy of a material. Raises Error for an index out of range.")
      .def("set_material", &Simulation::set_material, "index"_a, "material"_a,
           "Sets a material. Raises Error for an index or values out of range.")
      .def(
          "grab",
          [](const py::object& self, const py::object& vertices, double stiffness) {
            return Held{self, self.cast<Simulation&>().grab(indices_of(vertices), stiffness)};
          },
          "vertices"_a, "stiffness"_a = 0.0,
          "Grabs the free ones of the vertices. stiffness is that of all springs together [N/m]; with 0 it follows "
          "from "
          "the tissue. Raises Error if no vertex is free.")
      .def(
          "grab_patch",
          [](const py::object& self, const Vec3& point, double radius, double stiffness) {
            return Held{self, self.cast<Simulation&>().grab_patch(point, radius, stiffness)};
          },
          "point"_a, "radius"_a, "stiffness"_a = 0.0,
          "Grabs a round patch around the tissue nearest to point [m]; the springs fade out at radius [m]. stiffness "
          "as "
          "in grab(). Raises Error if no vertex is free.")
      .def("diagnostics", &Simulation::diagnostics, "Returns energies, momenta, forces and the quality of the state.")
      .def("supports", &Simulation::supports, "Returns the forces of the supports, body by body.")
      .def(
          "von_mises", [](const Simulation& s) { return array_of(s.von_mises()); },
          "Returns the von Mises stress of all tets [Pa], [tet_count].")
      .def("recovered_stress", &Simulation::recovered_stress,
           "Returns the stress recovered at the vertices. The CPU computes it, which takes as long as some steps.")
      .def(
          "green_strain", [](const Simulation& s) { return array_of(s.tet_fields().green_strain, 6); },
          "Returns the Green strain of all tets [-], [tet_count, 6]: xx, yy, zz, yz, xz, xy; tensor shears.")
      .def(
          "det_f", [](const Simulation& s) { return array_of(s.tet_fields().det_f); },
          "Returns J = det F of all tets [-], [tet_count].");
}

}  // namespace
}  // namespace fascia::python

PYBIND11_MODULE(fascia, m) {
  using namespace fascia;
  namespace py = pybind11;
  m.doc() =
      "Real-time simulation of soft tissue on the GPU.\n\n"
      "Units are SI. Arrays are numpy arrays where numpy is installed, else memoryviews of the same shape; arguments "
      "may "
      "also be lists. docs/guide/library.md has an introduction.";
  m.attr("__version__") = version();
  const py::object error = py::register_exception<Error>(m, "Error", PyExc_RuntimeError);
  error.attr("__doc__") = "The base of all exceptions of fascia: one line, \"where: what; what was expected\".";
  // Those that are registered last are tried first.
  py::register_exception<ContextLost>(m, "ContextLost", error).attr("__doc__") =
      "The graphics device was reset; simulations of its context can only be destroyed.";
  py::register_exception<Interrupted>(m, "Interrupted", error).attr("__doc__") = "The work was stopped.";
  python::define_arrays(m);
  python::define_values(m);
  python::define_measures(m);
  python::define_simulation(m);
  m.def("make_box", &make_box, py::arg("nx"), py::arg("ny"), py::arg("nz"), py::arg("size"),
        "Makes the box from 0 to size [m] of nx * ny * nz cells with six tets each. Raises Error for counts below 1.");
  m.def(
      "read_mesh", [](const std::string& path) { return read_mesh(path); }, py::arg("path"),
      "Reads a Gmsh, VTK, TetGen, Medit, Abaqus, FEBio or Vega mesh. Raises Error for what cannot be read.");
  m.def(
      "tissue", &tissue, py::arg("name"),
      "Returns the material of a tissue from the literature, for example \"liver\". Raises Error for an unknown name.");
  m.def("tissues", &tissues, "Returns the names of the tissues.");
  m.def("material_models", &material_models, "Returns the names of the laws.");
  m.def("solver_pairs", &solver_pairs, "Returns method and acceleration of all pairs, the best pair first.");
  m.def("data_dir", &data_dir, "Returns the folder with shaders and shipped scenes. Raises Error if there is none.");
  m.def("set_data_dir", &set_data_dir, py::arg("folder"),
        "Sets the data folder for contexts that are made afterwards. Raises Error if it holds no shaders.");
}
