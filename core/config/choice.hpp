#pragma once
/// A choice among policies: `{"type": "name", ...its parameters beside it}`.

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/config/parameters.hpp"
#include "core/errors.hpp"
#include "core/type_list.hpp"

namespace talus {

namespace detail {
/// Whether a table has a row of this name.
template <Described P>
constexpr bool has_row(std::string_view name) {
  bool found = false;
  for_each_parameter<P>([&](auto const& row) { found = found || row.name == name; });
  return found;
}
}  // namespace detail

/// What can be chosen: a type with a name for documents, a title for people, and described parameters.
/// It may also have a `source` (what to cite). No parameter may be called "type": that is the tag.
template <class P>
concept Policy = requires {
  { P::name } -> std::convertible_to<std::string_view>;
  { P::title } -> std::convertible_to<std::string_view>;
  typename P::Parameters;
  requires Described<typename P::Parameters>;
  requires !detail::has_row<typename P::Parameters>("type");
};

/// Where a policy comes from (author, year, doi); empty if it does not say.
template <Policy P>
constexpr std::string_view source_of() {
  if constexpr (requires { P::source; }) return P::source;
  return {};
}

/// The parameters of the one policy that was chosen out of a list.
///
/// A member `Choice<Laws> law;` is empty: the document must choose. A member
/// `Choice<Kernels> kernel = Choice<Kernels>::of<Quadratic>();` has a default.
template <class List>
class Choice;

template <Policy First, Policy... Rest>
class Choice<TypeList<First, Rest...>> {
 public:
  using Policies = TypeList<First, Rest...>;
  template <class Q>
  static constexpr bool offers = (std::same_as<Q, First> || ... || std::same_as<Q, Rest>);

  Choice() = default;

  /// This policy with these parameters.
  template <class Q>
  requires offers<Q>
  [[nodiscard]] static Choice of(typename Q::Parameters parameters = {}) {
    Choice choice;
    choice.chosen_ = Chosen<Q>{std::move(parameters)};
    return choice;
  }

  [[nodiscard]] bool is_empty() const { return std::holds_alternative<std::monostate>(chosen_); }

  template <class Q>
  requires offers<Q>
  [[nodiscard]] bool holds() const { return std::holds_alternative<Chosen<Q>>(chosen_); }

  /// f(std::type_identity<Q>{}, parameters of Q) for the policy Q that was chosen. All calls give the same type.
  /// Throws: InputError if nothing was chosen.
  template <class F>
  decltype(auto) visit(F&& f) const {
    using Result = std::invoke_result_t<F&, std::type_identity<First>, typename First::Parameters const&>;
    return std::visit(
        [&]<class C>(C const& chosen) -> Result {
          if constexpr (std::same_as<C, std::monostate>) {
            throw InputError("nothing was chosen where a choice is needed");
          } else {
            return f(std::type_identity<typename C::Of>{}, chosen.parameters);
          }
        },
        chosen_);
  }

  /// The name of the policy that was chosen. Throws: InputError if nothing was chosen.
  [[nodiscard]] std::string_view name() const {
    return visit([]<class Q>(std::type_identity<Q>, auto const&) -> std::string_view { return Q::name; });
  }

 private:
  /// Two policies may share one struct of parameters, so the alternative carries the policy.
  template <class Q>
  struct Chosen {
    using Of = Q;
    typename Q::Parameters parameters;
  };
  std::variant<std::monostate, Chosen<First>, Chosen<Rest>...> chosen_;
};

/// f(std::type_identity<Q>{}, parameters of Q) for the policy Q that was chosen.
template <class List, class F>
decltype(auto) visit(Choice<List> const& choice, F&& f) {
  return choice.visit(std::forward<F>(f));
}

}  // namespace talus
