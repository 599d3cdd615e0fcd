#pragma once
/// What the tests of bodies share.

#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

#include "core/errors.hpp"
#include "models/bodies/shapes/box.hpp"

namespace talus::body {

/// The box between two corners.
template <int D>
Box::In<D> box(Coordinates min, Coordinates max) {
  return Box::In<D>({std::move(min), std::move(max)});
}

/// Expects that making something is refused with a message that has `because` in it.
template <class F>
void refuses(F make, std::string const& because) {
  BOOST_CHECK_EXCEPTION((void)make(), InputError, [&](InputError const& e) {
    BOOST_TEST_INFO("message: " << e.what());
    return std::string(e.what()).find(because) != std::string::npos;
  });
}

}  // namespace talus::body
