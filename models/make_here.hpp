#pragma once
/// Materials and stages, compiled by the translation unit that includes this file: the catalogue's own, and programs
/// that do not link it because they are compiled for another instruction set.

#include <tuple>
#include <utility>

#include "core/type_list.hpp"
#include "models/make.hpp"

namespace talus {

template <class Kinematics, class Law>
std::unique_ptr<Material<Kinematics::dimension>> make_material(std::string name, double density,
                                                               typename Law::Parameters const& parameters) {
  return std::make_unique<MaterialOf<Kinematics, Law>>(std::move(name), density, parameters);
}

/// The makers of a law's material in these kinematics: who names them compiles them.
template <class Law, class... Kinematics>
auto makers_of(TypeList<Kinematics...>) {
  return std::tuple{&make_material<Kinematics, Law>...};
}

template <int D, class Kernel, class Transfer, class Integrator>
std::unique_ptr<Stages<D>> make_stages(typename Transfer::Parameters const& parameters, bool rubs) {
  return std::make_unique<StagesOf<D, Kernel, Transfer, Integrator>>(parameters, rubs);
}

}  // namespace talus
