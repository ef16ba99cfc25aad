// Student's t distribution, for intervals of estimates whose noise is estimated, too.
#pragma once

namespace fascia {

/// The t with probability 0.95 between -t and t at this number of degrees of freedom (at least 1); infinite degrees of
/// freedom: the normal distribution.
double student_95(double degrees_of_freedom);

}  // namespace fascia
