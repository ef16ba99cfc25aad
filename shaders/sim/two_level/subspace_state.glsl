// Indices into the array that the subspace kernels share (floats).
#define SUBSPACE_OBJECTIVE 0u   // of the state before the last step [kg m^2]
#define SUBSPACE_STEP 1u        // 3: factors of z_f, z_c and p in the change of the displacement
#define SUBSPACE_LAST_STEP 4u   // 3: factors of z_f, z_c and p in the new p
#define SUBSPACE_EARLIER 8u     // 2, in contact: objectives before that
#define SUBSPACE_ACCEPTED 7u    // 1 if the last step is kept: the gradient then belongs to a new base
