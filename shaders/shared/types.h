// Structures read by C++ and GLSL alike. Only float, int, uint, vec4 and ivec4: their layout is the same on both sides.
#ifndef FASCIA_SHARED_TYPES_H
#define FASCIA_SHARED_TYPES_H
#ifdef __cplusplus
namespace fascia::shared {
struct vec4 {
  float x, y, z, w;
};
#endif

// The values that every kernel of a stage of a substep can read (uniform block Step; sim/integrators/stage.h).
struct StepValues {
  vec4 gravity;   // xyz acceleration [m/s^2], w length l of the stage [s]
  vec4 solver;    // x spectral radius for Chebyshev acceleration, 0: estimated; y iterations, z tolerance, w 1 / mean
                  // mass [1/kg]
  vec4 material;  // for a scene with one material: x Young's modulus E [Pa], y Poisson's ratio [-], z damping [s], w
                  // model, with the fractions of sim/elasticity/feature_material.glsl
  vec4 guard;  // x distance from its prediction at which a vertex counts as diverged [m]; y duration of the stage [s],
               // z its extrapolation p [-], w the share of its forces in the substep
};

// Partial sums of one invocation of the diagnostic kernels; the CPU adds them in double precision.
struct TetPartial {
  vec4 range;  // x smallest J, y largest J, z largest |strain| (Frobenius), w largest von Mises stress [Pa]
  vec4 sums;   // x elastic energy [J], y inverted tets, z growth of the volume [m^3], w volume * |strain|^2 [m^3]
};
// Of what moves at the centroids of quadratic tets.
struct CentroidPartial {
  vec4 angular;  // xyz angular momentum about the origin [kg m^2/s], w kinetic energy [J]
  vec4 inertia;  // xyz mass times acceleration, as far as free vertices bear it [N]
};
struct VertexPartial {
  vec4 momentum;  // xyz [kg m/s], w kinetic energy of the own masses [J]
  vec4 angular;   // xyz of these about the origin [kg m^2/s], w potential energy of gravity, 0 at rest positions [J]
  vec4 reaction;  // xyz force of the supports on the body [N], w largest speed squared [m^2/s^2]
  vec4 residual;  // of free vertices, M over the mean mass: x |g|^2, y |M (u - u~)|^2, z |h^2 f|^2 + |h^2 M gravity|^2
                  // [m^2], w |M v|^2
  vec4 inertia;   // xyz own mass times acceleration of free vertices [N], w magnitude of the forces whose differences
                  // are its terms [N]
};

#ifdef __cplusplus
static_assert(sizeof(StepValues) % 16 == 0 && sizeof(TetPartial) % 16 == 0 && sizeof(CentroidPartial) % 16 == 0 &&
              sizeof(VertexPartial) % 16 == 0);
}  // namespace fascia::shared
#endif
#endif
