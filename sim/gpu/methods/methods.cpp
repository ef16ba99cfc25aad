#include "sim/gpu/methods/methods.h"

#include <algorithm>
#include <iterator>

#include "sim/gpu/methods/exact_xpbd.h"
#include "sim/gpu/methods/gauss_seidel.h"
#include "sim/gpu/methods/jacobi.h"
#include "sim/gpu/methods/two_level.h"
#include "sim/gpu/methods/vertex_descent.h"

namespace fascia {
namespace {

using Inputs = MethodInputs;
using Made = std::unique_ptr<StepMethod>;

constexpr MethodKernels kMethods[] = {
    {Method::two_level,
     [](const Inputs& i) -> Made {
       return std::make_unique<TwoLevelMethod>(i.programs, i.model, i.buffers, i.settings);
     }},
    {Method::vertex_descent,
     [](const Inputs& i) -> Made { return std::make_unique<VertexDescentMethod>(i.model, i.buffers); }},
    {Method::exact_xpbd, [](const Inputs& i) -> Made { return std::make_unique<ExactXpbdMethod>(i.buffers); }},
    {Method::mass_splitting, [](const Inputs& i) -> Made { return std::make_unique<JacobiMethod>(i.buffers, true); }},
    {Method::gauss_seidel,
     [](const Inputs& i) -> Made { return std::make_unique<GaussSeidelMethod>(i.model, i.buffers, i.settings.colors); },
     true},
    {Method::jacobi, [](const Inputs& i) -> Made { return std::make_unique<JacobiMethod>(i.buffers, false); }},
};

}  // namespace

const MethodKernels& kernels_of(Method method) {
  return *std::find_if(std::begin(kMethods), std::end(kMethods),
                       [&](const MethodKernels& kernels) { return kernels.method == method; });
}

}  // namespace fascia
