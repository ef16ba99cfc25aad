"""Sweeps the modulus of a beam that is clamped at one end: prints the deflection of its tip and the force of the clamp."""
import sys

import fascia

LENGTH, SIDE = 0.2, 0.04  # [m]


def beam(young_modulus):
    mesh = fascia.make_box(10, 2, 2, (LENGTH, SIDE, SIDE))
    clamped = [v for v in range(mesh.vertex_count) if mesh.positions[v, 0] == 0]
    return fascia.Scene([fascia.Body(mesh, fascia.Material(young_modulus=young_modulus), fixed=clamped)])


context = fascia.Context.own()  # one for all simulations, so that kernels are compiled once
moduli = [1e5, 2e5, 4e5, 8e5]  # [Pa]
sinks = []
for modulus in moduli:
    simulation = fascia.Simulation(beam(modulus), context)
    assert simulation.solve_static().converged
    tip = max(range(simulation.vertex_count), key=lambda v: tuple(simulation.rest_positions[v, k] for k in range(3)))
    sink = simulation.rest_positions[tip, 1] - simulation.positions[tip, 1]
    print(f"modulus {modulus:g} Pa: sinks {1000 * sink:.4f} mm, clamp carries {simulation.supports()[0].force[1]:.4f} N")
    sinks.append(sink)

if len(sys.argv) > 1:  # sweep_modulus.py PICTURE.png
    import matplotlib.pyplot as plot

    plot.loglog(moduli, sinks, "o-")
    plot.xlabel("Young's modulus [Pa]")
    plot.ylabel("tip sinks by [m]")
    plot.savefig(sys.argv[1])
