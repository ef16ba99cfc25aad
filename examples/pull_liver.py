"""Opens the shipped liver, grabs its top and lifts it by two centimeters; prints the force of the grab."""
import os

import fascia

simulation = fascia.Simulation.open(os.path.join(fascia.data_dir(), "assets/scenes/liver.json"), set=["grabs=[]"])
print(f"{simulation.vertex_count} vertices, {simulation.tet_count} tets on {simulation.context.renderer}")

x = simulation.positions
used = {v for row in range(simulation.surface_triangles.shape[0]) for v in [simulation.surface_triangles[row, 0]]}
top = max(used, key=lambda v: x[v, 1])
hand = simulation.grab_patch((x[top, 0], x[top, 1], x[top, 2]), 0.01)
start = hand.target
for step in range(1, 31):
    hand.target = (start[0], start[1] + 0.02 * step / 30, start[2])
    simulation.step()
    if step % 10 == 0:
        print(f"{simulation.time:.3f} s: lifted {1000 * (hand.target[1] - start[1]):.1f} mm, pulls up {hand.force[1]:.4f} N")
now = simulation.diagnostics()
print(f"largest stress {now.max_von_mises:.0f} Pa, volume {100 * now.volume_ratio:.2f} %, inverted tets {now.inverted}")
