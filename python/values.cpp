#include "python/values.h"

#include <pybind11/stl.h>

#include "fascia/fascia.h"
#include "python/arrays.h"

namespace fascia::python {
namespace {

using namespace py::literals;

template <class T>
std::string text_of(const T& value) {
  return py::repr(value);
}

}  // namespace

void define_values(py::module_& m) {
  py::class_<Material>(m, "Material",
                       "An isotropic tissue material. Calls that receive a value out of range raise Error.")
      .def(py::init([](double young_modulus, double poisson_ratio, double density, double damping,
                       const std::string& model, double mooney_ratio) {
             return Material{young_modulus, poisson_ratio, density, damping, model, mooney_ratio};
           }),
           "young_modulus"_a = Material().young_modulus, "poisson_ratio"_a = Material().poisson_ratio,
           "density"_a = Material().density, "damping"_a = Material().damping, "model"_a = Material().model,
           "mooney_ratio"_a = Material().mooney_ratio, "Makes a material; every argument is a field.")
      .def_readwrite("young_modulus", &Material::young_modulus, "Young's modulus E [Pa], 1e-3 to 1e14.")
      .def_readwrite("poisson_ratio", &Material::poisson_ratio, "Poisson's ratio nu [-], -0.9 to 0.499.")
      .def_readwrite("density", &Material::density, "The density at rest [kg/m^3], 1e-3 to 1e6.")
      .def_readwrite("damping", &Material::damping, "The Kelvin-Voigt damping: viscosity over stiffness [s], 0 to 10.")
      .def_readwrite("mooney_ratio", &Material::mooney_ratio,
                     "The ratio C01 / (C10 + C01) [-] of the law mooney_rivlin, 0 to 1.")
      .def_readwrite("model", &Material::model, "The law: one of material_models().")
      .def(
          "__eq__", [](const Material& a, const Material& b) { return a == b; }, "Compares all fields.")
      .def("__repr__", [](const Material& a) {
        return "Material(young_modulus=" + text_of(py::float_(a.young_modulus)) +
               ", poisson_ratio=" + text_of(py::float_(a.poisson_ratio)) +
               ", density=" + text_of(py::float_(a.density)) + ", damping=" + text_of(py::float_(a.damping)) +
               ", model=" + text_of(py::str(a.model)) + ", mooney_ratio=" + text_of(py::float_(a.mooney_ratio)) + ")";
      });
  py::class_<Settings> settings(m, "Settings",
                                "The settings of the solver. Calls that receive a value out of range raise Error.");
  settings.def(py::init([](const py::kwargs& fields) {
                 Settings made;
                 const py::object object = py::cast(&made, py::return_value_policy::reference);
                 for (const auto& [name, value] : fields) {
                   if (!py::hasattr(object, name))
                     throw py::type_error("Settings has no field " + std::string(py::str(name)));
                   py::setattr(object, name, value);
                 }
                 return made;
               }),
               "Makes settings; keyword arguments set the fields. Raises TypeError for an unknown field.");
  settings.def_readwrite("method", &Settings::method, "The method, as in scene files.")
      .def_readwrite("acceleration", &Settings::acceleration, "The acceleration of the method, as in scene files.")
      .def_readwrite("integrator", &Settings::integrator,
                     "The time integrator, as in scene files: \"implicit_euler\", \"bdf2\" or \"sdirk2\".")
      .def_readwrite("iterations", &Settings::iterations, "The largest number of iterations per substep, 1 to 10000.")
      .def_readwrite("tolerance", &Settings::tolerance,
                     "The relative residual at which iterations stop [-], 0 to 1. With 0 all iterations run.")
      .def_readwrite("time_step", &Settings::time_step, "The length of one step [s], 1e-6 to 1.")
      .def_readwrite("substeps", &Settings::substeps, "The number of equal parts of a step, 1 to 1000.")
      .def_readwrite("frame_budget", &Settings::frame_budget,
                     "The wall time of a step [ms], 0 to 10000. With 0 there is no limit.")
      .def_readwrite("colors", &Settings::colors,
                     "The number of colors of gauss_seidel, 0 to 64. With 0 the mesh decides.")
      .def_readwrite("spectral_radius", &Settings::spectral_radius,
                     "The spectral radius of chebyshev [-], 0 to 0.9999. With 0 it is estimated.")
      .def_readwrite("window", &Settings::window, "The number of earlier iterations that anderson combines, 1 to 10.")
      .def_readwrite("rest_speed", &Settings::rest_speed,
                     "The speed [1/s], in sizes of the scene, below which tissue falls asleep. With 0 nothing does.")
      .def(
          "__eq__", [](const Settings& a, const Settings& b) { return a == b; }, "Compares all fields.");
  py::class_<Mesh>(m, "Mesh", "A tetrahedral mesh.")
      .def(py::init([](const py::object& positions, const py::object& tets, const py::object& regions) {
             Mesh mesh;
             mesh.positions = numbers_of(positions);
             mesh.tets = indices_of(tets);
             if (!regions.is_none())
               for (const double region : numbers_of(regions)) mesh.regions.push_back(static_cast<int>(region));
             return mesh;
           }),
           "positions"_a, "tets"_a, "regions"_a = py::none(),
           "Makes a mesh of positions [vertex_count, 3] [m], tets [tet_count, 4] and regions [tet_count]. Raises "
           "ValueError for numbers that are no indices.")
      .def_property_readonly(
          "positions", [](const py::object& self) { return view_of(self.cast<const Mesh&>().positions, 3, self); },
          "The positions at rest [m], [vertex_count, 3]; a view, read only.")
      .def_property_readonly(
          "tets", [](const py::object& self) { return view_of(self.cast<const Mesh&>().tets, 4, self); },
          "The vertices of each tet, [tet_count, 4]; a view, read only.")
      .def_property_readonly(
          "regions", [](const Mesh& mesh) { return mesh.regions; },
          "The region of each tet, [tet_count]; a copy. If it is empty, all regions are 0.")
      .def_property_readonly(
          "region_names", [](const Mesh& mesh) { return mesh.region_names; },
          "The names of regions by number, if a file has them; a copy.")
      .def_property_readonly(
          "groups", [](const Mesh& mesh) { return mesh.groups; },
          "The vertex sets of a file by name, each ascending; a copy.")
      .def_property_readonly("vertex_count", &Mesh::vertex_count, "The number of vertices.")
      .def_property_readonly("tet_count", &Mesh::tet_count, "The number of tets.");
  py::class_<Motion>(m, "Motion", "Vertices that follow a straight line from their rest positions.")
      .def(py::init([](const py::object& vertices, const Vec3& translate, double start, double duration) {
             return Motion{indices_of(vertices), translate, start, duration};
           }),
           "vertices"_a, "translate"_a, "start"_a = 0.0, "duration"_a = 0.0,
           "Moves the vertices by translate [m], from the time start for duration [s], and holds them there.");
  py::class_<Body>(m, "Body", "A mesh with materials, supports and motions.")
      .def(py::init([](const Mesh& mesh, const Material& material, const std::string& name, const py::object& fixed,
                       const std::map<int, Material>& region_materials, const std::vector<Motion>& motions,
                       const py::object& initial_velocity, const std::string& elements) {
             return Body{name,
                         mesh,
                         material,
                         region_materials,
                         indices_of(fixed),
                         motions,
                         initial_velocity.is_none() ? std::vector<double>() : numbers_of(initial_velocity),
                         elements};
           }),
           "mesh"_a, "material"_a = Material(), "name"_a = "body", "fixed"_a = py::tuple(),
           "region_materials"_a = std::map<int, Material>(), "motions"_a = std::vector<Motion>(),
           "initial_velocity"_a = py::none(), "elements"_a = Body().elements,
           "Makes a body. fixed has the indices of vertices that stay at rest; region_materials has the materials of "
           "single regions by number; initial_velocity is [vertex_count, 3] [m/s]; elements is linear or quadratic.");
  py::class_<Scene>(m, "Scene", "Bodies, gravity and settings.")
      .def(py::init([](const std::vector<Body>& bodies, const Vec3& gravity, const Settings& settings_of_scene,
                       const std::string& title) {
             return Scene{title, bodies, gravity, settings_of_scene};
           }),
           "bodies"_a, "gravity"_a = Scene().gravity, "settings"_a = Settings(), "title"_a = "",
           "Makes a scene of at least one body; gravity is in m/s^2.");
  py::class_<State>(m, "State", "A state of a simulation, to be restored later.")
      .def_readonly("time", &State::time, "The simulated time [s].")
      .def_property_readonly(
          "displacements",
          [](const py::object& self) { return view_of(self.cast<const State&>().displacements, 3, self); },
          "The displacements u = x - X [m], [vertex_count, 3]; a view, read only.")
      .def_property_readonly(
          "velocities", [](const py::object& self) { return view_of(self.cast<const State&>().velocities, 3, self); },
          "The velocities [m/s], [vertex_count, 3]; a view, read only.");
}

}  // namespace fascia::python
