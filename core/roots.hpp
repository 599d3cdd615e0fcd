#pragma once
/// The root of one equation in one unknown, for numbers, packs and dual numbers: Newton's iteration kept in a bracket.

#include "core/scalar.hpp"

namespace talus {

/// f(x) and f'(x): what the equation answers when asked at x.
template <class T>
struct WithDerivative {
  T value, derivative;
};

/// A root, the number of evaluations of the slowest lane, and whether every lane met its tolerance.
template <class T>
struct Root {
  T x;
  int iterations = 0;
  bool converged = false;
};

/// Evaluations after which the search gives up: twice the 53 bisections that a double can take.
inline constexpr int root_iteration_limit = 110;

/// Solves f(x) = 0 between two points where f has opposite signs (or is zero), in any order:
///
///   f(below) <= 0 <= f(above),    x <- x - f/f',
///
/// where that step stays in the bracket and is at most half the one before the last, else the middle of the bracket.
///
/// \param f         callable T -> WithDerivative<T>; asked at `start`, then only strictly inside the bracket, so it may
///                  be singular at the ends.
/// \param start     first guess, in the bracket.
/// \param tolerance a lane is done after a step of at most this size [unit of x], or of two units in the last place.
///
/// The root never leaves the bracket, whatever f answers: where f is NaN the bracket is halved. A bracket of a single
/// point is done at once; one that is not finite never converges. A lane that is done is frozen, so that its result
/// does not depend on its neighbours. The derivatives of a dual root are those of the last Newton step: exact to the
/// order of the tolerance.
/// Source: safeguards after Dekker (1969), in Constructive Aspects of the Fundamental Theorem of Algebra, 37-48, and
/// Brent (1973), Algorithms for Minimization without Derivatives, ch. 4, with Newton in place of the secant.
template <Scalar T, class F>
[[nodiscard]] Root<T> bracketed_newton(F const& f, T below, std::type_identity_t<T> above,
                                       std::type_identity_t<T> start, std::type_identity_t<T> tolerance) {
  constexpr double two_ulp = 2 * std::numeric_limits<double>::epsilon();
  Root<T> root{start};
  T last = abs(T(above - below)), before_last = last;
  auto active = !(last < T(0.0));  // every lane
  for (; root.iterations < root_iteration_limit; ++root.iterations) {
    if (!any(active)) break;
    WithDerivative<T> const at = f(root.x);
    auto const high = at.value > T(0.0);
    above = select<T>(high, root.x, above);
    below = select<T>(high, below, root.x);

    T const newton = root.x - at.value / at.derivative;
    auto const inside = newton > min(below, above) && newton < max(below, above);
    auto const shrinks = T(2.0) * abs(T(newton - root.x)) <= before_last;
    T const next = select<T>((inside && shrinks) || newton == root.x, newton, T(0.5) * (below + above));

    before_last = last;
    last = abs(T(next - root.x));
    root.x = select<T>(active, next, root.x);
    active = active && !(last <= max(tolerance, T(two_ulp * abs(root.x))));
  }
  root.converged = !any(active);
  return root;
}

}  // namespace talus
