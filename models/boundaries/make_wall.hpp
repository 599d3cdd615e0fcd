#pragma once
/// Walls out of their parts: shape x contact x motion.

#include <concepts>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "core/config/choice.hpp"
#include "core/errors.hpp"
#include "core/wall.hpp"

namespace talus {

/// The geometry of a wall at rest: `In<D>` answers as core/wall.hpp says of `Wall`, for the dimensions it supports.
template <class S>
concept WallShape = Policy<S> &&
    requires(typename S::template In<2> const shape, Point<2> const& x, std::span<Surface<2>> out) {
  { S::supports(2) } -> std::same_as<bool>;
  requires std::constructible_from < typename S::template In<2>,
  typename S::Parameters const& > ;
  { shape.surfaces(x, out) } -> std::same_as<int>;
  { shape.distance(x) } -> std::same_as<double>;
};

/// What a wall does to what touches it.
template <class C>
concept WallContact = Policy<C> && requires(typename C::Parameters const& parameters) {
  { C::rule(parameters) } -> std::same_as<ContactRule>;
};

/// How a wall moves, without turning: where it is, from where the document has it, and how fast.
template <class M>
concept WallMotion = Policy<M> && requires(typename M::template In<2> const motion, double t) {
  { M::supports(2) } -> std::same_as<bool>;
  requires std::constructible_from < typename M::template In<2>,
  typename M::Parameters const& > ;
  { motion.offset(t) } -> std::same_as<Point<2>>;
  { motion.velocity(t) } -> std::same_as<Point<2>>;
};

/// A shape that moves. What it does to what touches it is data: contacts add no types.
template <int D, WallShape Shape, WallMotion Motion>
class WallOf final : public Wall<D> {
 public:
  WallOf(std::string its_name, ContactRule rule, typename Shape::Parameters const& shape,
         typename Motion::Parameters const& motion)
      : Wall<D>(std::move(its_name), rule), shape_(shape), motion_(motion) {}

  int surfaces(Point<D> const& x, double t, std::span<Surface<D>> out) const override {
    return shape_.surfaces(x - motion_.offset(t), out);
  }
  [[nodiscard]] double distance(Point<D> const& x, double t) const override {
    return shape_.distance(x - motion_.offset(t));
  }
  [[nodiscard]] Point<D> velocity(double t) const override { return motion_.velocity(t); }

 private:
  typename Shape::template In<D> shape_;
  typename Motion::template In<D> motion_;
};

namespace detail {
/// What `make` makes; an InputError of its gets the wall's name.
template <class F>
auto for_wall(std::string const& name, F const& make) {
  try {
    return make();
  } catch (InputError const& error) {
    throw InputError("wall '" + name + "': " + error.what());
  }
}
}  // namespace detail

/// A wall of these parts. Throws InputError where a part is not there in D dimensions or refuses its parameters; the
/// message names the wall.
template <int D, WallShape Shape, WallMotion Motion>
[[nodiscard]] std::unique_ptr<Wall<D>> make_wall(std::string const& name, typename Shape::Parameters const& shape,
                                                 ContactRule const& rule, typename Motion::Parameters const& motion) {
  if constexpr (!Shape::supports(D) || !Motion::supports(D)) {
    throw InputError("wall '" + name + "': " + std::string(Shape::supports(D) ? Motion::name : Shape::name) +
                     " is not available in " + std::to_string(D) + " dimensions");
  } else {
    return detail::for_wall(name, [&]() -> std::unique_ptr<Wall<D>> {
      return std::make_unique<WallOf<D, Shape, Motion>>(name, rule, shape, motion);
    });
  }
}
template <int D, WallShape Shape, WallContact Contact, WallMotion Motion>
[[nodiscard]] std::unique_ptr<Wall<D>> make_wall(std::string const& name, typename Shape::Parameters const& shape,
                                                 typename Contact::Parameters const& contact,
                                                 typename Motion::Parameters const& motion) {
  auto const rule = detail::for_wall(name, [&] { return Contact::rule(contact); });
  return make_wall<D, Shape, Motion>(name, shape, rule, motion);
}

}  // namespace talus
