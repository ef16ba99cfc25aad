// The Python module `fascia`, which uses only the public headers.
#include <pybind11/functional.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "fascia/fascia.h"
#include "python/arrays.h"

namespace fascia::python {
namespace {

using namespace py::literals;

/// A grab in Python refers to its simulation, so that its methods can query it.
struct Held {
  py::object owner;
  Grab grab;
  Simulation& simulation() const { return owner.cast<Simulation&>(); }
};

template <class T>
std::string text_of(const T& value) {
  return py::repr(value);
}

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

void define_values(py::module_& m) {
  py::class_<Material>(m, "Material", "Isotropic tissue material.")
      .def(py::init([](double young_modulus, double poisson_ratio, double density, double damping,
                       const std::string& model, double mooney_ratio) {
             return Material{young_modulus, poisson_ratio, density, damping, model, mooney_ratio};
           }),
           "young_modulus"_a = Material().young_modulus, "poisson_ratio"_a = Material().poisson_ratio,
           "density"_a = Material().density, "damping"_a = Material().damping, "model"_a = Material().model,
           "mooney_ratio"_a = Material().mooney_ratio)
      .def_readwrite("young_modulus", &Material::young_modulus, "E [Pa]")
      .def_readwrite("poisson_ratio", &Material::poisson_ratio, "nu [-]")
      .def_readwrite("density", &Material::density, "[kg/m^3]")
      .def_readwrite("damping", &Material::damping, "viscosity over stiffness [s]")
      .def_readwrite("mooney_ratio", &Material::mooney_ratio, "C01 / (C10 + C01) of the model mooney_rivlin")
      .def_readwrite("model", &Material::model, "one of material_models()")
      .def("__eq__", [](const Material& a, const Material& b) { return a == b; })
      .def("__repr__", [](const Material& a) {
        return "Material(young_modulus=" + text_of(py::float_(a.young_modulus)) +
               ", poisson_ratio=" + text_of(py::float_(a.poisson_ratio)) +
               ", density=" + text_of(py::float_(a.density)) + ", damping=" + text_of(py::float_(a.damping)) +
               ", model=" + text_of(py::str(a.model)) + ", mooney_ratio=" + text_of(py::float_(a.mooney_ratio)) + ")";
      });
  py::class_<Settings> settings(m, "Settings", "How steps are solved. Keyword arguments set the fields.");
  settings.def(py::init([](const py::kwargs& fields) {
    Settings made;
    const py::object object = py::cast(&made, py::return_value_policy::reference);
    for (const auto& [name, value] : fields) {
      if (!py::hasattr(object, name)) throw py::type_error("Settings has no field " + std::string(py::str(name)));
      py::setattr(object, name, value);
    }
    return made;
  }));
  settings.def_readwrite("method", &Settings::method)
      .def_readwrite("acceleration", &Settings::acceleration)
      .def_readwrite("iterations", &Settings::iterations, "per substep, at most")
      .def_readwrite("tolerance", &Settings::tolerance,
                     "relative residual at which iterations stop; 0: all of them run")
      .def_readwrite("time_step", &Settings::time_step, "of one step [s]")
      .def_readwrite("substeps", &Settings::substeps)
      .def_readwrite("frame_budget", &Settings::frame_budget, "wall time of a step [ms]; 0: no limit")
      .def_readwrite("colors", &Settings::colors)
      .def_readwrite("spectral_radius", &Settings::spectral_radius)
      .def_readwrite("window", &Settings::window)
      .def_readwrite("rest_speed", &Settings::rest_speed, "[1/s] what is slower falls asleep; 0: nothing does")
      .def("__eq__", [](const Settings& a, const Settings& b) { return a == b; });
  py::class_<Mesh>(m, "Mesh",
                   "A tetrahedral mesh: positions [vertex_count, 3] [m], tets [tet_count, 4], regions [tet_count].")
      .def(py::init([](const py::object& positions, const py::object& tets, const py::object& regions) {
             Mesh mesh;
             mesh.positions = numbers_of(positions);
             mesh.tets = indices_of(tets);
             if (!regions.is_none())
               for (const double region : numbers_of(regions)) mesh.regions.push_back(static_cast<int>(region));
             return mesh;
           }),
           "positions"_a, "tets"_a, "regions"_a = py::none())
      .def_property_readonly(
          "positions", [](const py::object& self) { return view_of(self.cast<const Mesh&>().positions, 3, self); },
          "[vertex_count, 3] [m], read only")
      .def_property_readonly(
          "tets", [](const py::object& self) { return view_of(self.cast<const Mesh&>().tets, 4, self); },
          "[tet_count, 4], read only")
      .def_property_readonly("regions", [](const Mesh& mesh) { return mesh.regions; })
      .def_property_readonly("region_names", [](const Mesh& mesh) { return mesh.region_names; })
      .def_property_readonly("groups", [](const Mesh& mesh) { return mesh.groups; })
      .def_property_readonly("vertex_count", &Mesh::vertex_count)
      .def_property_readonly("tet_count", &Mesh::tet_count);
  py::class_<Motion>(m, "Motion", "Vertices that move along a straight line and then stay.")
      .def(py::init([](const py::object& vertices, const Vec3& translate, double start, double duration) {
             return Motion{indices_of(vertices), translate, start, duration};
           }),
           "vertices"_a, "translate"_a, "start"_a = 0.0, "duration"_a = 0.0);
  py::class_<Body>(m, "Body", "A mesh with materials and supports.")
      .def(py::init([](const Mesh& mesh, const Material& material, const std::string& name, const py::object& fixed,
                       const std::map<int, Material>& region_materials, const std::vector<Motion>& motions,
                       const py::object& initial_velocity) {
             return Body{name,
                         mesh,
                         material,
                         region_materials,
                         indices_of(fixed),
                         motions,
                         initial_velocity.is_none() ? std::vector<double>() : numbers_of(initial_velocity)};
           }),
           "mesh"_a, "material"_a = Material(), "name"_a = "body", "fixed"_a = py::tuple(),
           "region_materials"_a = std::map<int, Material>(), "motions"_a = std::vector<Motion>(),
           "initial_velocity"_a = py::none());
  py::class_<Scene>(m, "Scene", "Bodies, gravity [m/s^2] and solver settings.")
      .def(py::init([](const std::vector<Body>& bodies, const Vec3& gravity, const Settings& settings_of_scene,
                       const std::string& title) {
             return Scene{title, bodies, gravity, settings_of_scene};
           }),
           "bodies"_a, "gravity"_a = Scene().gravity, "settings"_a = Settings(), "title"_a = "");
  py::class_<State>(m, "State", "A state that can be restored.")
      .def_readonly("time", &State::time, "[s]")
      .def_property_readonly(
          "displacements",
          [](const py::object& self) { return view_of(self.cast<const State&>().displacements, 3, self); })
      .def_property_readonly(
          "velocities", [](const py::object& self) { return view_of(self.cast<const State&>().velocities, 3, self); });
}

void define_measures(py::module_& m) {
  py::class_<Diagnostics>(m, "Diagnostics", "Energies [J], momenta, forces on the tissue [N] and quality of the state.")
      .def_readonly("time", &Diagnostics::time)
      .def_readonly("kinetic", &Diagnostics::kinetic)
      .def_readonly("elastic", &Diagnostics::elastic)
      .def_readonly("gravitational", &Diagnostics::gravitational)
      .def_readonly("volume_ratio", &Diagnostics::volume_ratio)
      .def_readonly("min_det_f", &Diagnostics::min_det_f)
      .def_readonly("max_det_f", &Diagnostics::max_det_f)
      .def_readonly("inverted", &Diagnostics::inverted)
      .def_readonly("max_strain", &Diagnostics::max_strain)
      .def_readonly("max_von_mises", &Diagnostics::max_von_mises)
      .def_readonly("max_speed", &Diagnostics::max_speed)
      .def_readonly("momentum", &Diagnostics::momentum)
      .def_readonly("angular_momentum", &Diagnostics::angular_momentum)
      .def_readonly("reaction", &Diagnostics::reaction)
      .def_readonly("grab_force", &Diagnostics::grab_force)
      .def_readonly("residual", &Diagnostics::residual)
      .def_readonly("iterations", &Diagnostics::iterations);
  py::class_<Support>(m, "Support", "Force [N] of fixed vertices, or of those of a motion, on a body.")
      .def_readonly("body", &Support::body)
      .def_readonly("motion", &Support::motion)
      .def_readonly("force", &Support::force);
  py::class_<StaticReport>(m, "StaticReport")
      .def_readonly("iterations", &StaticReport::iterations)
      .def_readonly("newton_iterations", &StaticReport::newton_iterations)
      .def_readonly("relative_residual", &StaticReport::relative_residual)
      .def_readonly("converged", &StaticReport::converged);
  py::class_<Held>(m, "Grab", "Springs that pull tissue to a target.")
      .def_property(
          "target", [](const Held& h) { return h.simulation().target(h.grab); },
          [](const Held& h, const Vec3& target) { h.simulation().move(h.grab, target); }, "where the center is led [m]")
      .def_property_readonly(
          "force", [](const Held& h) { return h.simulation().force(h.grab); }, "on the tissue [N]")
      .def_property_readonly(
          "stiffness", [](const Held& h) { return h.simulation().stiffness(h.grab); }, "[N/m]")
      .def("release", [](const Held& h) { h.simulation().release(h.grab); });
}

Context chosen(const std::optional<Context>& context, bool reference) {
  return context ? *context : reference ? Context::none() : Context::own();
}

void step(Simulation& simulation, int count) {
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
                      "The OpenGL context that simulations compute in. Share one among several simulations.")
      .def_static("own", &Context::own, "kind"_a = "auto",
                  "A context without a window: \"auto\", \"egl\" or \"osmesa\".")
      .def_static(
          "current", [] { return Context::current(); }, "The context that is current on this thread.")
      .def_static("none", &Context::none, "No OpenGL: for the reference solver.")
      .def_property_readonly("kind", &Context::kind)
      .def_property_readonly("renderer", &Context::renderer)
      .def_property_readonly("software", &Context::software);
  py::class_<Simulation>(m, "Simulation", "One scene that is simulated. Arrays of vertices are [vertex_count, 3].")
      .def(py::init([](const Scene& scene, const std::optional<Context>& context, bool reference) {
             return Simulation(scene, chosen(context, reference), {.reference = reference});
           }),
           "scene"_a, "context"_a = py::none(), "reference"_a = false)
      .def_static(
          "open",
          [](const std::string& path, const std::optional<Context>& context, const std::vector<std::string>& set,
             bool reference, const std::function<void(double, const std::string&)>& progress) {
            return Simulation::open(path, chosen(context, reference), {set, reference, control_of(progress)});
          },
          "path"_a, "context"_a = py::none(), "set"_a = std::vector<std::string>(), "reference"_a = false,
          "progress"_a = py::none(),
          "Opens a scene (JSON) or a mesh; `set` replaces keys: [\"solver.iterations=20\"]. `progress` is called with "
          "share and text.")
      .def_property_readonly("context", &Simulation::context)
      .def_property_readonly("notes", &Simulation::notes)
      .def_property_readonly("vertex_count", &Simulation::vertex_count)
      .def_property_readonly("tet_count", &Simulation::tet_count)
      .def_property_readonly(
          "rest_positions",
          [](const py::object& self) { return view_of(self.cast<const Simulation&>().rest_positions(), 3, self); },
          "[vertex_count, 3] [m], read only, not copied")
      .def_property_readonly(
          "tets", [](const py::object& self) { return view_of(self.cast<const Simulation&>().tets(), 4, self); },
          "[tet_count, 4], read only, not copied")
      .def_property_readonly(
          "surface_triangles",
          [](const py::object& self) { return view_of(self.cast<const Simulation&>().surface_triangles(), 3, self); },
          "[triangle_count, 3], read only, not copied")
      .def_property_readonly(
          "fixed", [](const py::object& self) { return view_of(self.cast<const Simulation&>().fixed(), 1, self); })
      .def_property_readonly(
          "masses", [](const Simulation& s) { return array_of(s.masses()); }, "[vertex_count] [kg]")
      .def_property_readonly("bodies",
                             [](const Simulation& s) {
                               py::list names;
                               for (const BodyRange& b : s.bodies())
                                 names.append(py::dict("name"_a = b.name, "vertex_begin"_a = b.vertex_begin,
                                                       "vertex_count"_a = b.vertex_count, "tet_begin"_a = b.tet_begin,
                                                       "tet_count"_a = b.tet_count));
                               return names;
                             })
      .def("step", &step, "count"_a = 1, "Makes steps of settings.time_step.")
      .def("solve_static", &solve_static, "Goes on from the static equilibrium.")
      .def("reset", &Simulation::reset)
      .def_property_readonly("time", &Simulation::time, "[s]")
      .def_property_readonly("asleep", &Simulation::asleep)
      .def("diverged_vertex", &Simulation::diverged_vertex,
           "A vertex that is no longer finite or has left the scene; None: the state is valid.")
      .def("restore_valid", &Simulation::restore_valid)
      .def_property(
          "positions", [](const Simulation& s) { return array_of(s.positions(), 3); },
          [](Simulation& s, const py::object& x) { s.set_positions(numbers_of(x)); }, "[vertex_count, 3] [m]; a copy")
      .def_property(
          "velocities", [](const Simulation& s) { return array_of(s.velocities(), 3); },
          [](Simulation& s, const py::object& v) { s.set_velocities(numbers_of(v)); },
          "[vertex_count, 3] [m/s]; a copy")
      .def("save", &Simulation::save)
      .def("restore", &Simulation::restore, "state"_a)
      .def("write", &Simulation::write, "path"_a, "Writes the state: .vtu, .msh, .csv or .obj.")
      .def_property("settings", &Simulation::settings, &Simulation::set_settings, "a copy: assign it to change it")
      .def_property("gravity", &Simulation::gravity, &Simulation::set_gravity, "[m/s^2]")
      .def_property_readonly("material_names",
                             [](const Simulation& s) {
                               std::vector<std::string> names;
                               for (std::size_t i = 0; i < s.material_count(); ++i) names.push_back(s.material_name(i));
                               return names;
                             })
      .def("material", &Simulation::material, "index"_a = 0)
      .def("set_material", &Simulation::set_material, "index"_a, "material"_a)
      .def(
          "grab",
          [](const py::object& self, const py::object& vertices, double stiffness) {
            return Held{self, self.cast<Simulation&>().grab(indices_of(vertices), stiffness)};
          },
          "vertices"_a, "stiffness"_a = 0.0,
          "Grabs vertices; stiffness of all springs together [N/m], 0: from the tissue.")
      .def(
          "grab_patch",
          [](const py::object& self, const Vec3& point, double radius, double stiffness) {
            return Held{self, self.cast<Simulation&>().grab_patch(point, radius, stiffness)};
          },
          "point"_a, "radius"_a, "stiffness"_a = 0.0)
      .def("diagnostics", &Simulation::diagnostics)
      .def("supports", &Simulation::supports)
      .def(
          "von_mises", [](const Simulation& s) { return array_of(s.von_mises()); }, "[tet_count] [Pa]")
      .def(
          "green_strain", [](const Simulation& s) { return array_of(s.tet_fields().green_strain, 6); },
          "[tet_count, 6] xx, yy, zz, yz, xz, xy")
      .def(
          "det_f", [](const Simulation& s) { return array_of(s.tet_fields().det_f); }, "[tet_count]");
}

}  // namespace
}  // namespace fascia::python

PYBIND11_MODULE(fascia, m) {
  using namespace fascia;
  namespace py = pybind11;
  m.doc() = "Real-time simulation of soft tissue on the GPU.";
  m.attr("__version__") = version();
  const py::object error = py::register_exception<Error>(m, "Error", PyExc_RuntimeError);
  py::register_exception<ContextLost>(m, "ContextLost", error);  // the last registered exceptions are tried first
  py::register_exception<Interrupted>(m, "Interrupted", error);
  python::define_arrays(m);
  python::define_values(m);
  python::define_measures(m);
  python::define_simulation(m);
  m.def("make_box", &make_box, py::arg("nx"), py::arg("ny"), py::arg("nz"), py::arg("size"),
        "Box [0, size] of cells, six tets each.");
  m.def(
      "read_mesh", [](const std::string& path) { return read_mesh(path); }, py::arg("path"));
  m.def("tissue", &tissue, py::arg("name"), "A material from the literature: \"liver\".");
  m.def("tissues", &tissues);
  m.def("material_models", &material_models);
  m.def("solver_pairs", &solver_pairs, "Method and acceleration of all solver choices, best first.");
  m.def("data_dir", &data_dir);
  m.def("set_data_dir", &set_data_dir, py::arg("folder"));
}
