#pragma once
/// The law that a document chose, behind an interface: what reads a case or composes it sees no law's page, so that a
/// law is compiled once, in a unit of its own (law_unit.cpp.in).

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "core/config/open_choice.hpp"

namespace talus {

template <int D>
class Material;

using MaterialOfSomeSpace = std::variant<std::unique_ptr<Material<2>>, std::unique_ptr<Material<3>>>;

class ChosenLaw : public OpenPolicy {
 public:
  /// Every law of the catalogue.
  [[nodiscard]] static Offers<ChosenLaw> offers();

  /// Whether a wall can take its friction from the law.
  [[nodiscard]] virtual bool has_friction() const = 0;
  /// A material of this law. kinematics: a name of the catalogue's; density [kg/m^3].
  [[nodiscard]] virtual MaterialOfSomeSpace material(std::string_view kinematics, std::string const& name,
                                                     double density) const = 0;
};

}  // namespace talus
