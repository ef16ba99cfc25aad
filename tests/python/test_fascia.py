"""The Python module: arguments and results, with and without numpy. Run with PYTHONPATH where the module is.

Arguments: the stub file, the folder of the examples.
"""
# Covers: arrays, module, values
import ast
import gc
import re
import subprocess
import sys
import unittest

import fascia

try:
    import numpy
except ImportError:
    numpy = None

STUB, EXAMPLES = sys.argv.pop(1), sys.argv.pop(1)
CONTEXT = fascia.Context.own("osmesa")


def cube(**fields):
    mesh = fascia.make_box(2, 2, 2, (0.1, 0.1, 0.1))
    lowest = [v for v in range(mesh.vertex_count) if mesh.positions[v, 1] == 0]
    return fascia.Scene([fascia.Body(mesh, fascia.Material(young_modulus=1e4), fixed=lowest)], **fields)


def simulation(**fields):
    return fascia.Simulation(cube(**fields), CONTEXT)


class Arrays(unittest.TestCase):
    def test_shapes_and_types(self):
        s = simulation()
        expected = "ndarray" if numpy else "memoryview"
        recovered = s.recovered_stress()
        self.assertEqual(tuple(recovered.cauchy.shape), (27, 6))
        self.assertEqual(recovered.max_von_mises, max(recovered.von_mises))
        self.assertLessEqual(recovered.p99_von_mises, recovered.max_von_mises)
        for array, shape in [(s.positions, (27, 3)), (s.tets, (48, 4)), (s.masses, (27,)), (s.green_strain(), (48, 6)), (s.fixed, (9,))]:
            self.assertEqual(type(array).__name__, expected)
            self.assertEqual(tuple(array.shape), shape)

    def test_views_are_read_only_and_keep_their_simulation(self):
        s = simulation()
        rest = s.rest_positions
        with self.assertRaises((TypeError, ValueError)):
            rest[0, 0] = 1
        del s
        self.assertEqual(rest[26, 0], 0.1)

    def test_views_of_every_owner_outlive_its_name(self):
        s = simulation()
        s.step()
        mesh, state = fascia.make_box(2, 2, 2, (0.1, 0.1, 0.1)), s.save()
        views = [mesh.positions, mesh.tets, state.displacements, state.velocities, s.rest_positions, s.tets, s.surface_triangles, s.fixed]
        stress = s.recovered_stress()
        copies = [s.positions, s.velocities, s.masses, s.von_mises(), s.green_strain(), s.det_f(), stress.cauchy, stress.von_mises]
        before = [memoryview(a).tobytes() for a in views + copies]
        del mesh, state, s, stress
        gc.collect()
        others = [simulation() for _ in range(3)]  # in the memory that may have become free
        self.assertEqual([memoryview(a).tobytes() for a in views + copies], before)
        self.assertEqual([memoryview(a).readonly for a in views], [True] * len(views))
        self.assertEqual([memoryview(a).readonly for a in copies], [False] * len(copies))
        del others

    @unittest.skipUnless(numpy, "numpy is not installed")
    def test_views_cannot_be_made_writeable(self):
        s = simulation()
        with self.assertRaises(ValueError):
            s.rest_positions.flags.writeable = True

    def test_a_grab_keeps_its_simulation(self):
        grab = simulation().grab([26], 50)
        gc.collect()
        self.assertEqual(grab.stiffness, 50)
        self.assertEqual(len(grab.force), 3)

    def test_empty_arrays(self):
        s = fascia.Simulation(fascia.Scene([fascia.Body(fascia.make_box(1, 1, 1, (1, 1, 1)))]), CONTEXT)
        self.assertEqual(tuple(s.fixed.shape), (0,))

    def test_quadratic_elements(self):
        body = fascia.Body(fascia.make_box(1, 1, 1, (1, 1, 1)), elements="quadratic")
        s = fascia.Simulation(fascia.Scene([body]), CONTEXT)
        self.assertEqual(tuple(s.positions.shape), (27, 3))
        with self.assertRaisesRegex(fascia.Error, "expected linear or quadratic"):
            fascia.Simulation(fascia.Scene([fascia.Body(fascia.make_box(1, 1, 1, (1, 1, 1)), elements="cubic")]), CONTEXT)

    def test_positions_are_a_copy_that_can_be_assigned(self):
        s = simulation(gravity=(0, 0, 0))
        x = s.positions
        x[26, 0] += 0.01
        self.assertEqual(s.positions[26, 0], 0.1)
        s.positions = x
        self.assertAlmostEqual(s.positions[26, 0], 0.11, places=7)
        s.positions = [[x[v, k] for k in range(3)] for v in range(27)]  # lists are accepted
        with self.assertRaisesRegex(fascia.Error, "expected 81"):
            s.positions = [1, 2, 3]
        with self.assertRaises(TypeError):
            s.positions = "nothing"

    @unittest.skipUnless(numpy, "numpy is not installed")
    def test_numpy_arrays_of_any_layout(self):
        s = simulation(gravity=(0, 0, 0))
        x = s.positions
        x[:, 0] += 0.02
        s.positions = numpy.asfortranarray(x)
        moved = s.positions
        free = numpy.setdiff1d(numpy.arange(27), s.fixed)
        numpy.testing.assert_allclose(moved[free], x[free], atol=1e-7)
        s.velocities = numpy.ones((27, 3), dtype=numpy.float32)
        numpy.testing.assert_allclose(s.velocities[free], 1)
        mesh = fascia.Mesh(numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]), numpy.array([[0, 1, 2, 3]], dtype=numpy.int64))
        self.assertEqual(mesh.tet_count, 1)

    def test_indices_must_be_indices(self):
        for bad in ([0, 1, 2, -1], [0, 1, 2, 0.5]):
            with self.assertRaises(ValueError):
                fascia.Mesh([[0, 0, 0]] * 4, bad)


class Simulating(unittest.TestCase):
    def test_support_carries_the_weight(self):
        s = simulation()
        self.assertTrue(s.solve_static().converged)
        self.assertAlmostEqual(s.supports()[0].force[1], 9.81, places=4)
        self.assertAlmostEqual(sum(s.masses), 1, places=12)

    def test_free_fall(self):
        scene = fascia.Scene([fascia.Body(fascia.make_box(2, 2, 2, (0.1, 0.1, 0.1)))])
        s = fascia.Simulation(scene, CONTEXT)
        s.step(60)
        self.assertAlmostEqual(s.positions[0, 1], -9.81 / 3600 * 60 * 61 / 2, places=4)  # implicit Euler
        self.assertAlmostEqual(s.time, 1, places=6)
        s.step(0)
        with self.assertRaisesRegex(fascia.Error, "step: count: is -1"):
            s.step(-1)
        self.assertAlmostEqual(s.time, 1, places=6)

    def test_grab(self):
        s = simulation(gravity=(0, 0, 0))
        grab = s.grab([26], 50)
        grab.target = (0.13, 0.1, 0.1)
        self.assertTrue(s.solve_static().converged)
        self.assertAlmostEqual(grab.force[0], 50 * (0.13 - s.positions[26, 0]), places=4)
        grab.release()
        with self.assertRaises(fascia.Error):
            grab.force

    def test_values_are_set_by_assignment(self):
        s = simulation()
        s.settings = fascia.Settings(iterations=7)
        self.assertEqual(s.settings.iterations, 7)
        with self.assertRaisesRegex(fascia.Error, "settings.iterations: is 0"):
            s.settings = fascia.Settings(iterations=0)
        with self.assertRaises(TypeError):
            fascia.Settings(iteration=7)
        s.gravity = (1, 2, 3)
        self.assertEqual(tuple(s.gravity), (1, 2, 3))
        s.set_material(0, fascia.tissue("liver"))
        self.assertEqual(s.material(0), fascia.tissue("liver"))

    def test_save_and_restore(self):
        s = simulation()
        s.step(3)
        kept = s.save()
        x = s.positions
        s.step(3)
        s.restore(kept)
        self.assertEqual([s.positions[26, k] for k in range(3)], [x[26, k] for k in range(3)])
        self.assertEqual(s.time, kept.time)

    def test_progress_may_end_the_opening(self):
        def refuse(share, what):
            raise KeyError(what)
        scene = fascia.data_dir() + "/assets/scenes/cube.json"
        with self.assertRaises(KeyError):
            fascia.Simulation.open(scene, CONTEXT, progress=refuse)
        self.assertEqual(fascia.Simulation.open(scene, CONTEXT, set=["solver.iterations=3"]).settings.iterations, 3)


def public(names):
    return {n for n in names if not n.startswith("_")}


EXCEPTIONS = ("Error", "ContextLost", "Interrupted")


class Documentation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(STUB) as file:
            tree = ast.parse(file.read())
        cls.classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        cls.functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}

    def members(self):
        """Name, Python's object and the stub's node of each function, method, property and field."""
        for name, node in self.functions.items():
            yield name, getattr(fascia, name), node
        for owner, owner_node in self.classes.items():
            for node in owner_node.body:
                name = node.target.id if isinstance(node, ast.AnnAssign) else getattr(node, "name", None)
                if name:
                    yield f"{owner}.{name}", vars(getattr(fascia, owner))[name], node

    def test_stub_has_the_names_of_the_module(self):
        self.assertEqual(public(dir(fascia)), set(self.classes) | set(self.functions))
        listed = [name for name, _, _ in self.members()]
        self.assertEqual(len(listed), len(set(listed)))
        for name in set(self.classes) - set(EXCEPTIONS):
            own = {n.split(".")[1] for n in listed if n.startswith(name + ".")}
            self.assertEqual(public(dir(getattr(fascia, name))), public(own), name)

    def test_stub_has_the_parameters(self):
        checked = 0
        for name, value, node in self.members():
            if isinstance(value, property) or isinstance(node, ast.AnnAssign) or name == "Settings.__init__":
                continue
            signature = getattr(value, "__func__", value).__doc__.splitlines()[0]
            given = [a for a in re.findall(r"[(,] ?(\w+): ", signature) if a != "self"]
            arguments = [a.arg for a in node.args.args if a.arg != "self"]
            self.assertEqual(given, arguments, name)
            self.assertEqual(len(re.findall(r"\w+: [^=]*? = ", signature)), len(node.args.defaults), f"defaults of {name}")
            checked += 1
        self.assertGreater(checked, 30)

    def test_stub_knows_what_can_be_assigned(self):
        for name, value, node in self.members():
            if isinstance(value, property):
                self.assertEqual(value.fset is not None, isinstance(node, ast.AnnAssign), name)

    def test_everything_has_a_description(self):
        self.assertIn("Units are SI", fascia.__doc__)
        for name in self.classes:
            self.assertTrue(getattr(fascia, name).__doc__, name)
        for name, value, _ in self.members():
            text = getattr(value, "__func__", value).__doc__
            if not isinstance(value, property):
                text = text.partition("\n\n")[2]  # behind the signature
            self.assertRegex(text.strip(), r"(?s)^\S.*\.$", name)


class Examples(unittest.TestCase):
    def run_example(self, name):
        result = subprocess.run([sys.executable, EXAMPLES + "/" + name], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def test_sweep_modulus(self):
        rows = re.findall(r"modulus (\S+) Pa: sinks (\S+) mm, clamp carries (\S+) N", self.run_example("sweep_modulus.py"))
        self.assertEqual([float(r[0]) for r in rows], [1e5, 2e5, 4e5, 8e5])
        for _, _, force in rows:
            self.assertAlmostEqual(float(force), 1000 * 0.2 * 0.04**2 * 9.81, places=3)
        # Small displacements are proportional to the inverse of the modulus; the last two are below a tenth of the length.
        self.assertAlmostEqual(float(rows[2][1]) / float(rows[3][1]), 2, delta=0.02)

    def test_pull_liver(self):
        out = self.run_example("pull_liver.py")
        forces = [float(f) for f in re.findall(r"pulls up (\S+) N", out)]
        self.assertEqual(len(forces), 3)
        self.assertTrue(0 < forces[0] < forces[1] < forces[2], out)
        self.assertIn("inverted tets 0", out)


if __name__ == "__main__":
    unittest.main()
