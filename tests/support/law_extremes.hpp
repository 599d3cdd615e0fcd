#pragma once
/// Laws at extreme inputs: the lists of them, one step, and whether what comes out is sound.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string_view>

#include "core/type_list.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "models/laws/cam_clay_mu_i_consistent.hpp"
#include "models/laws/cam_clay_viscous.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "tests/support/law_states.hpp"
#include "tests/support/material_point.hpp"

namespace talus::extremes {

inline constexpr double eps = std::numeric_limits<double>::epsilon();
using MuIs = TypeList<law::CamClayMuI, law::CamClayMuISinh, law::CamClayMuIConsistent, law::CamClayMuIConsistentSinh>;
using All = TypeList<law::CamClay, law::CamClaySinh, law::CamClayPerzyna, law::CamClayDuvautLions, law::CamClayMuI,
                     law::CamClayMuISinh, law::CamClayMuIConsistent, law::CamClayMuIConsistentSinh>;

/// Calls f(law type, parameters) for every law of a list.
template <class List, class F>
void for_each_law(F&& f) {
  for_each_type(List{}, [&](auto type) {
    using L = typename decltype(type)::type;
    BOOST_TEST_CONTEXT(L::name) {
      f(type, typename L::Parameters{});
    }
  });
}
template <class Type>
using LawOf = typename Type::type;

/// Slope of the yield surface, under whatever name.
template <class P>
void set_slope(P& p, double slope) {
  if constexpr (requires { p.mu_1; })
    p.mu_1 = slope, p.mu_2 = std::max(p.mu_2, 2 * slope);
  else
    p.M = slope;
}

/// Stress and state after one step from a trial stress.
template <class L>
support::MaterialPoint<shape::Solid, L> stepped(L const& law, double p_tr, double q_tr, double dt = 1e-5,
                                                double eps_V = 0) {
  support::MaterialPoint<shape::Solid, L> point{law};
  point.state[field::plastic_volumetric_strain] = eps_V;
  point.step(support::strain_of<shape::Solid>(law, p_tr, q_tr), dt);
  return point;
}

/// Finite; q at most that of the trial; with all the time that a step can take on or under the surface, and between tip
/// and cap.
template <class L>
bool sound(L const& law, double p_tr, double q_tr, double dt, double eps_V = 0) {
  auto const point = stepped(law, p_tr, q_tr, dt, eps_V);
  bool good = std::isfinite(point.p()) && std::isfinite(point.q()) && std::isfinite(point.state.values[0]);
  for (double const value : law.derive(point.eps, point.state).values) good = good && std::isfinite(value);
  double const size = std::max(std::abs(p_tr), q_tr);
  good = good && point.q() <= q_tr * (1 + 64 * eps) + 64 * eps * size;
  if (!L::rate_dependent || dt > 1e200) {
    double const K = law.template bulk<shape::Solid>(), p_c = law.template strength<shape::Solid>(point.state);
    double const steep = 1 - law.hardening.slope(p_c, K) / K;
    double const slack = 64 * eps * (size + steep * std::max({p_c, std::abs(point.p()), point.q()})) + 1e-250;
    good = good && law.yield(point.eps, point.state) <= slack * (1 + law.surface.M);
  }
  return good;
}

/// True where a value of a named parameter is possible.
template <class P>
bool allows(std::string_view name, double value) {
  bool allowed = false;
  for_each_parameter<P>([&](auto const& row) {
    if (row.name == name) allowed = row.range.contains(value);
  });
  return allowed;
}

}  // namespace talus::extremes
