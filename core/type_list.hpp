#pragma once
/// A list of types, and a loop over it.

#include <cstddef>
#include <type_traits>

namespace talus {

template <class... T>
struct TypeList {
  static constexpr std::size_t size = sizeof...(T);
};

/// Calls f(std::type_identity<T>{}) for every T of the list, in order.
template <class... T, class F>
constexpr void for_each_type(TypeList<T...>, F&& f) {
  (f(std::type_identity<T>{}), ...);
}

}  // namespace talus
