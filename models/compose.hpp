#pragma once
/// From the document of a case to an experiment.

#include <memory>

#include "core/experiment.hpp"
#include "models/case.hpp"

namespace talus {

/// What a table cannot say: names that must exist, policies that must fit together, walls and bodies in the right
/// dimension. Each mistake as "pointer: what is wrong; what is allowed".
[[nodiscard]] std::vector<std::string> inconsistencies(Case const& document);

/// Dimension of the space of a kinematics by name; 0 for an unknown one.
[[nodiscard]] int dimension_of_kinematics(std::string_view name);

/// Composes a consistent case. Throws InputError with the pointer of what cannot be.
[[nodiscard]] std::unique_ptr<Experiment> compose(Case const& document);

}  // namespace talus
