#pragma once
/// Materials and stages out of the catalogue. They are instantiated one law, or one kernel and dimension, a translation
/// unit (law_unit.cpp.in, transfer_unit.cpp.in), so that their costs to compile add instead of multiplying. Who includes
/// this file links talus::catalogue; who includes make_here.hpp compiles them.

#include <memory>
#include <string>

#include "core/material.hpp"
#include "core/stages.hpp"

namespace talus {

/// A material of a law in a kinematics.
template <class Kinematics, class Law>
std::unique_ptr<Material<Kinematics::dimension>> make_material(std::string name, double density,
                                                               typename Law::Parameters const& parameters);

/// Stages of a kernel, a transfer and an integrator in D dimensions. rubs: a wall takes its friction from the material.
template <int D, class Kernel, class Transfer, class Integrator>
std::unique_ptr<Stages<D>> make_stages(typename Transfer::Parameters const& parameters, bool rubs);

/// Whether a transfer can be used with a kernel: an affine one needs a constant inertia.
template <class Kernel, class Transfer>
inline constexpr bool fit_together = !Transfer::affine || (Kernel::inertia > 0);

}  // namespace talus
