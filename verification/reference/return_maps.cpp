#include "verification/reference/return_maps.hpp"

#include <cmath>

namespace talus::reference {

namespace {

/// Where f, which is positive at `a` and negative at `b`, changes sign: to the last digit.
template <class T, class F>
T change_of_sign(F f, T a, T b) {
  for (int k = 0; k < 400; ++k) {
    T const middle = (a + b) / 2;
    if (middle == a || middle == b) break;
    (f(middle) > 0 ? a : b) = middle;
  }
  return (a + b) / 2;
}

/// (3): the smaller root of the quadratic equation for the overstress, in the form in which nothing cancels.
template <class T>
T relaxed(MuI const& m, double G, T const& q_tr, T const& S, T const& P, double dt) {
  using std::sqrt;
  T const q_y = m.mu_1 * S, O = q_tr - q_y, L = (T(m.mu_2) - m.mu_1) * S, R = T(G) * dt * m.Q() * sqrt(P);
  if (O <= 0) return q_tr;
  if (L <= 0) return q_y;
  T const gap = O - L, twice = O + L + R + sqrt(T(gap * gap + R * (2 * (O + L) + R)));
  return q_y + 2 * O * L / twice;
}

/// (4), with the stress as the unknown.
template <class T>
T relaxed(Perzyna const& v, double G, T const& q_tr, T const& q_y, double dt) {
  using std::pow;
  if (q_tr <= q_y) return q_tr;
  auto const f = [&](T const& q) { return T(q_y * pow(T(1 + v.t_v * (q_tr - q) / (T(G) * dt)), T(v.s)) - q); };
  return change_of_sign<T>(f, q_y, q_tr);
}

/// A plastic step on the ellipse of slope M.
template <class T>
struct Search {
  CamClay const& law;
  double M;
  StressOf<T> const& trial;
  double K = law.elastic.K(), G = law.elastic.G();

  [[nodiscard]] T p_c(T const& p) const {
    T const eps_V = law.is_implicit ? T(trial.eps_V + (p - trial.p) / K) : trial.eps_V;
    return strength<T>(law.hardening, eps_V, K);
  }
  [[nodiscard]] T D(T const& p) const { return 2 * p - (1 - T(law.surface.beta)) * p_c(p); }
  [[nodiscard]] T P(T const& p) const { return p + law.surface.beta * p_c(p); }
  [[nodiscard]] T S2(T const& p) const { return (p_c(p) - p) * P(p); }
  [[nodiscard]] T S(T const& p) const {
    using std::sqrt;
    T const s = S2(p);
    return s > 0 ? T(sqrt(s)) : T(0);
  }
  [[nodiscard]] bool plastic() const { return trial.q * trial.q > T(M) * M * S2(trial.p); }

  /// Between 0 and the trial pressure, or between that and the centre of the ellipse of the trial state.
  [[nodiscard]] T critical() const {
    auto const falls = [this](T const& p) { return T(-D(p)); };
    if (D(trial.p) > 0) return change_of_sign<T>(falls, T(0), trial.p);
    return change_of_sign<T>(falls, trial.p, T((1 - T(law.surface.beta)) / 2 * p_c(trial.p)));
  }
  [[nodiscard]] StressOf<T> at(T const& p, T const& q) const { return {p, q, trial.eps_V + (p - trial.p) / K}; }

  /// (1) and (2).
  [[nodiscard]] StressOf<T> project() const {
    T const M2 = T(M) * M;
    if (D(trial.p) == 0) return at(trial.p, M * S(trial.p));
    auto const q = [&](T const& p) { return T(trial.q / (1 + 2 * G * (trial.p - p) / (K * M2 * D(p)))); };
    auto const inside = [&](T const& p) {
      T const q_p = q(p);
      return T(M2 * S2(p) - q_p * q_p);
    };
    T const p = change_of_sign<T>(inside, critical(), trial.p), D_p = D(p), near = (1 + law.surface.beta) / 2 * p_c(p);
    return at(p, D_p < near && D_p > -near ? T(M * S(p)) : q(p));  // of two equal numbers the one in which less cancels
  }
  /// (6); between tip and cap alone there is an S.
  template <class Relaxed>
  [[nodiscard]] StressOf<T> flow(Relaxed q) const {
    if (D(trial.p) == 0) return at(trial.p, q(trial.p));
    T const side = D(trial.p) > 0 ? 1 : -1;
    auto const residual = [&](T const& p) {
      T const s2 = S2(p);
      if (P(p) <= 0 || s2 <= 0) return T(-1);
      T const q_p = q(p);
      return T(side * ((trial.p - p) * s2 - K / (2 * T(G)) * (trial.q - q_p) * q_p * D(p)));
    };
    T const p = change_of_sign<T>(residual, critical(), trial.p);
    return at(p, q(p));
  }
};

}  // namespace

template <class T>
StressOf<T> cam_clay_projection(CamClay const& law, StressOf<T> const& trial) {
  Search<T> const search{law, law.surface.M, trial};
  return search.plastic() ? search.project() : trial;
}

template <class T>
StressOf<T> cam_clay_two_stage(CamClay const& law, MuI const& m, StressOf<T> const& trial, double dt) {
  Search<T> const search{law, m.mu_1, trial};
  if (!search.plastic()) return trial;
  auto const stage = search.project();  // its q is mu_1 S without the digits that p loses near cap and tip
  T const S = stage.q / T(m.mu_1), by_p = search.P(stage.p), below_cap = search.p_c(stage.p) - stage.p;
  T const P = below_cap > by_p ? T(S * S / below_cap) : by_p;
  return search.at(stage.p, relaxed<T>(m, search.G, trial.q, S, P, dt));
}
template <class T>
StressOf<T> cam_clay_two_stage(CamClay const& law, Perzyna const& v, StressOf<T> const& trial, double dt) {
  Search<T> const search{law, law.surface.M, trial};
  if (!search.plastic()) return trial;
  auto const m = search.project();
  return search.at(m.p, relaxed<T>(v, search.G, trial.q, m.q, dt));
}
template <class T>
StressOf<T> cam_clay_duvaut_lions(CamClay const& law, DuvautLions const& v, StressOf<T> const& trial, double dt) {
  Search<T> const search{law, law.surface.M, trial};
  if (!search.plastic()) return trial;
  auto const m = search.project();
  T const part = 1 / (1 + T(v.t_v) / dt);
  return search.at(trial.p + part * (m.p - trial.p), trial.q + part * (m.q - trial.q));
}

template <class T>
StressOf<T> cam_clay_consistent(CamClay const& law, MuI const& m, StressOf<T> const& trial, double dt) {
  Search<T> const search{law, m.mu_1, trial};
  if (!search.plastic()) return trial;
  return search.flow([&](T const& p) { return relaxed<T>(m, search.G, trial.q, search.S(p), search.P(p), dt); });
}
template <class T>
StressOf<T> cam_clay_consistent(CamClay const& law, Perzyna const& v, StressOf<T> const& trial, double dt) {
  Search<T> const search{law, law.surface.M, trial};
  if (!search.plastic()) return trial;
  return search.flow([&](T const& p) { return relaxed<T>(v, search.G, trial.q, T(search.M * search.S(p)), dt); });
}

namespace {

/// The step on a cone, with the viscosity q(q_y).
template <class T, class Relaxed>
StressOf<T> on_cone(Elasticity const& elastic, Cone const& cone, StressOf<T> const& trial, Relaxed q) {
  T const q_y = cone.M * trial.p + cone.c;
  if (q_y < 0) {
    T const tip = -T(cone.c) / cone.M;
    return {tip, T(0), trial.eps_V + (tip - trial.p) / elastic.K()};
  }
  return {trial.p, trial.q > q_y ? q(q_y) : trial.q, trial.eps_V};
}

}  // namespace

template <class T>
StressOf<T> cone_step(Elasticity const& elastic, Cone const& cone, StressOf<T> const& trial) {
  return on_cone(elastic, cone, trial, [](T const& q_y) { return q_y; });
}
template <class T>
StressOf<T> cone_step(Elasticity const& elastic, Cone const& cone, Perzyna const& v, StressOf<T> const& trial,
                      double dt) {
  return on_cone(elastic, cone, trial, [&](T const& q_y) { return relaxed<T>(v, elastic.G(), trial.q, q_y, dt); });
}
template <class T>
StressOf<T> cone_step(Elasticity const& elastic, Cone const& cone, DuvautLions const& v, StressOf<T> const& trial,
                      double dt) {
  return on_cone(elastic, cone, trial,
                 [&](T const& q_y) { return T(q_y + (trial.q - q_y) * v.t_v / (T(v.t_v) + dt)); });
}

using D = double;
using E = long double;
using R = Digits;
template StressOf<D> cam_clay_projection(CamClay const&, StressOf<D> const&);
template StressOf<R> cam_clay_projection(CamClay const&, StressOf<R> const&);
template StressOf<E> cam_clay_projection(CamClay const&, StressOf<E> const&);
template StressOf<D> cam_clay_two_stage(CamClay const&, MuI const&, StressOf<D> const&, double);
template StressOf<R> cam_clay_two_stage(CamClay const&, MuI const&, StressOf<R> const&, double);
template StressOf<E> cam_clay_two_stage(CamClay const&, MuI const&, StressOf<E> const&, double);
template StressOf<D> cam_clay_two_stage(CamClay const&, Perzyna const&, StressOf<D> const&, double);
template StressOf<R> cam_clay_two_stage(CamClay const&, Perzyna const&, StressOf<R> const&, double);
template StressOf<E> cam_clay_two_stage(CamClay const&, Perzyna const&, StressOf<E> const&, double);
template StressOf<D> cam_clay_duvaut_lions(CamClay const&, DuvautLions const&, StressOf<D> const&, double);
template StressOf<R> cam_clay_duvaut_lions(CamClay const&, DuvautLions const&, StressOf<R> const&, double);
template StressOf<E> cam_clay_duvaut_lions(CamClay const&, DuvautLions const&, StressOf<E> const&, double);
template StressOf<D> cam_clay_consistent(CamClay const&, MuI const&, StressOf<D> const&, double);
template StressOf<R> cam_clay_consistent(CamClay const&, MuI const&, StressOf<R> const&, double);
template StressOf<E> cam_clay_consistent(CamClay const&, MuI const&, StressOf<E> const&, double);
template StressOf<D> cam_clay_consistent(CamClay const&, Perzyna const&, StressOf<D> const&, double);
template StressOf<R> cam_clay_consistent(CamClay const&, Perzyna const&, StressOf<R> const&, double);
template StressOf<E> cam_clay_consistent(CamClay const&, Perzyna const&, StressOf<E> const&, double);
template StressOf<D> cone_step(Elasticity const&, Cone const&, StressOf<D> const&);
template StressOf<R> cone_step(Elasticity const&, Cone const&, StressOf<R> const&);
template StressOf<E> cone_step(Elasticity const&, Cone const&, StressOf<E> const&);
template StressOf<D> cone_step(Elasticity const&, Cone const&, Perzyna const&, StressOf<D> const&, double);
template StressOf<R> cone_step(Elasticity const&, Cone const&, Perzyna const&, StressOf<R> const&, double);
template StressOf<E> cone_step(Elasticity const&, Cone const&, Perzyna const&, StressOf<E> const&, double);
template StressOf<D> cone_step(Elasticity const&, Cone const&, DuvautLions const&, StressOf<D> const&, double);
template StressOf<R> cone_step(Elasticity const&, Cone const&, DuvautLions const&, StressOf<R> const&, double);
template StressOf<E> cone_step(Elasticity const&, Cone const&, DuvautLions const&, StressOf<E> const&, double);

}  // namespace talus::reference
