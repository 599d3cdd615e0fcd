#pragma once
/// A law of the catalogue as documents choose it.

#include "models/catalogue_kinematics.hpp"
#include "models/chosen_law.hpp"
#include "models/make.hpp"

namespace talus {

template <Law L>
class LawOf final : public Offered<ChosenLaw, L> {
 public:
  using Offered<ChosenLaw, L>::Offered;
  [[nodiscard]] bool has_friction() const override { return HasFriction<L>; }
  [[nodiscard]] MaterialOfSomeSpace material(std::string_view kinematics, std::string const& name,
                                             double density) const override {
    MaterialOfSomeSpace made;
    for_each_type(catalogue::Kinematics{}, [&]<class K>(std::type_identity<K>) {
      if (K::name == kinematics) made = make_material<K, L>(name, density, this->parameters_);
    });
    return made;
  }
};

}  // namespace talus
