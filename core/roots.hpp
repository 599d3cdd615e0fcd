#pragma once
/// The root of one equation in one unknown, for numbers, packs and dual numbers: Newton's iteration kept in a bracket.

#include "core/scalar.hpp"

namespace talus {

/// f(x) and f'(x): what the equation answers when asked at x.
template <class T>
struct WithDerivative {
  T value, derivative;
};

/// f(x), f'(x), and f''(x), which may be rough.
template <class T>
struct WithCurvature {
  T value, derivative, second;
};

/// A root, how often the equation was asked, and whether every lane met its tolerance.
template <class T>
struct Root {
  T x;
  int iterations = 0;
  bool converged = false;
};

/// A dual number: its derivatives want the step at the root itself.
template <class T>
inline constexpr bool has_derivatives = requires(T const& x) {
  x.derivative(0);
};

/// Evaluations after which the guarded search gives up: twice the 53 bisections that a double can take.
inline constexpr int root_iteration_limit = 110;

namespace detail {

/// What a step may be when the search ends: the tolerance, or two units in the last place.
template <Scalar T>
[[nodiscard]] T least_step(T x, T tolerance) {
  return max(tolerance, T(2 * std::numeric_limits<double>::epsilon() * abs(x)));
}

/// Newton's step f/f', to be taken from x.
template <Scalar T>
[[nodiscard]] T step_of(WithDerivative<T> const& at) {
  return at.value / at.derivative;
}
/// Halley's, f f'/(f'^2 - f f''/2), where it is between two thirds and twice as long; else Newton's.
template <Scalar T>
[[nodiscard]] T step_of(WithCurvature<T> const& at) {
  T const straight = at.derivative * at.derivative, bent = T(0.5) * at.value * at.second;
  return at.value * at.derivative / (straight - select<T>(T(2.0) * abs(bent) < straight, bent, 0.0));
}

/// Whether the step after this one will not be longer than the least: seldom known.
template <Scalar T>
[[nodiscard]] auto foreseen_end(WithDerivative<T> const& /*at*/, T step, T /*before*/, T /*least*/) {
  return step < T(0.0);
}
/// By what the last two steps tell of a convergence of second order, and by what the curvature tells of one.
template <Scalar T>
[[nodiscard]] auto foreseen_end(WithCurvature<T> const& at, T step, T before, T least) {
  T const straight = at.derivative * at.derivative, bent = T(0.5) * abs(T(at.value * at.second));
  return T(10.0) * step * step * step < least * before * before && T(10.0) * step * bent < least * straight;
}

/// Steps after which a free iteration ends: fewer are taken wherever its order shows.
inline constexpr int free_limit = 20;

/// Where Newton's iteration got to, and the lanes in which that is the root.
template <Scalar T, class Condition>
struct Course {
  T x;
  Condition done;
  int iterations = 0;
};

/// Newton's iteration for as long as all goes well: x stays strictly inside the bracket, and each step is at most half
/// of the one before, the first of the bracket. This is all that most equations ask, and it costs a third of looking
/// after the bracket.
template <Scalar T, class F>
[[nodiscard]] auto free_newton(F const& f, T below, T above, T start, T tolerance) {
  T const low = min(below, above), high = max(below, above);
  Course<T, decltype(below == above)> course{start, below == above};
  T before = high - low;
  for (auto active = low < high; any(active) && course.iterations < free_limit; ++course.iterations) {
    auto const at = f(course.x);
    T const next = course.x - step_of(at), step = abs(T(next - course.x));
    active = active && next > low && next < high && T(2.0) * step <= before;
    course.x = select<T>(active, next, course.x);
    T const least = least_step(next, tolerance);
    auto ends = step <= least;
    if constexpr (!has_derivatives<T>)
      if (course.iterations > 0) ends = ends || foreseen_end(at, step, before, least);
    course.done = course.done || (active && ends);
    active = active && !ends;
    before = step;
  }
  return course;
}

}  // namespace detail

/// Solves f(x) = 0 between two points where f has opposite signs (or is zero), in any order:
///
///   f(below) <= 0 <= f(above),    x <- x - f/f'   or, with f'', Halley's   x <- x - f f'/(f'^2 - f f''/2),
///
/// where that step stays in the bracket and is at most half the one before the last, else the middle of the bracket.
///
/// \param f         callable T -> WithDerivative<T> or WithCurvature<T>; asked at `start`, then only strictly inside
///                  the bracket, so it may be singular at the ends.
/// \param start     first guess, in the bracket.
/// \param tolerance a lane is done after a step of at most this size [unit of x], or of two units in the last place;
///                  with f'' also before such a step, where it is foreseen.
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
  auto const course = detail::free_newton<T>(f, below, above, start, tolerance);
  Root<T> root{course.x, course.iterations};
  auto active = !course.done;
  T last = abs(T(above - below)), before_last = last;
  for (int guarded = 0; any(active) && guarded < root_iteration_limit; ++guarded, ++root.iterations) {
    auto const at = f(root.x);
    auto const high = at.value > T(0.0);
    above = select<T>(high, root.x, above);
    below = select<T>(high, below, root.x);

    T const newton = root.x - detail::step_of(at);
    auto const inside = newton > min(below, above) && newton < max(below, above);
    auto const shrinks = T(2.0) * abs(T(newton - root.x)) <= before_last;
    T const next = select<T>((inside && shrinks) || newton == root.x, newton, T(0.5) * (below + above));

    before_last = last;
    last = abs(T(next - root.x));
    root.x = select<T>(active, next, root.x);
    active = active && !(last <= detail::least_step(root.x, tolerance));
  }
  root.converged = !any(active);
  return root;
}

}  // namespace talus
