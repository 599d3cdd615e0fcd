#pragma once
/// From the document of a case to an experiment.

#include <memory>

#include "core/config/read.hpp"
#include "core/experiment.hpp"
#include "models/case.hpp"

namespace talus {

/// What a table cannot say: names that must exist, policies that must fit together, walls and bodies in the right
/// dimension. Each mistake as "pointer: what is wrong; what is allowed".
[[nodiscard]] std::vector<std::string> inconsistencies(Case const& document);

/// Refuses half-spaces that face each other where nothing is left between them, at the start or until the end.
void check_gaps(Case const& document, int dimension, std::vector<std::string>& wrong);

/// Warns of what is possible but seldom meant: walls thinner than a particle reaches, one particle
/// a cell, steps beyond the bound, expectations after the end. `base`: pointer of the case within the document.
void add_suspicions(Case const& values, std::string const& base, Reader& reader);

/// Dimension of the space of a kinematics by name; 0 for an unknown one.
[[nodiscard]] int dimension_of_kinematics(std::string_view name);

/// Composes a consistent case; adds to the warnings where particles begin inside a wall. Throws InputError with the
/// pointer of what cannot be.
[[nodiscard]] std::unique_ptr<Experiment> compose(Case const& document, std::vector<std::string>& warnings);

}  // namespace talus
