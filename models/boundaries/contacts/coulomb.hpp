#pragma once

#include <string_view>
#include <tuple>

#include "core/config/parameters.hpp"
#include "core/contact.hpp"

namespace talus::wall {

/// v_n >= w_n, and the impulse N along the normal slows the slip by at most mu N; the wall never pulls.
/// A block slides down a slope theta with g (sin theta - mu cos theta).
/// Source: Coulomb (1785), in Mémoires de mathématique et de physique 10, 161-332 (from memory).
struct Coulomb {
  static constexpr std::string_view name = "coulomb", title = "Coulomb friction, free separation",
                                    source = "Coulomb (1785), Mém. math. phys. 10, 161-332";

  struct Parameters {
    double friction = 0.5;
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::friction, "friction", "mu_b", "1", "coefficient of friction", non_negative)
              .required()};
    }
  };

  [[nodiscard]] static constexpr ContactRule rule(Parameters const& p) { return {.friction = p.friction}; }
};

}  // namespace talus::wall
