#include "models/walls.hpp"

#include "models/boundaries/make_wall.hpp"

namespace talus {

ContactRule contact_of(WallEntry const& entry) {
  return entry.contact.visit([]<class C>(std::type_identity<C>, auto const& contact) { return C::rule(contact); });
}

template <int D>
std::unique_ptr<Wall<D>> wall_of(WallEntry const& entry) {
  std::unique_ptr<Wall<D>> wall;
  ContactRule const rule = contact_of(entry);
  entry.shape.visit([&]<class S>(std::type_identity<S>, auto const& shape) {
    entry.motion.visit([&]<class M>(std::type_identity<M>, auto const& motion) {
      if constexpr (S::supports(D)) wall = make_wall<D, S, M>(entry.name, shape, rule, motion);
    });
  });
  return wall;
}

template std::unique_ptr<Wall<2>> wall_of(WallEntry const&);
template std::unique_ptr<Wall<3>> wall_of(WallEntry const&);

}  // namespace talus
