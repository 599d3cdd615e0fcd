#pragma once
/// A choice among policies that are known by name alone.
///
/// A Choice lists its policies as types, so whoever sees it compiles all of them. Of a family that grows, as the laws
/// do, a document is read and written through the interface here, and each policy is compiled once, by itself:
///
///     struct Law : OpenPolicy { virtual ... what the program asks of a law ...; static Offers<Law> offers(); };
///     template <class L> struct LawOf final : Offered<Law, L> { ... };
///     Offer<Law> const offer = offer_of<LawOf<Hencky>>();

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/outline.hpp"
#include "core/config/read.hpp"
#include "core/errors.hpp"

namespace talus {

/// A policy with the parameters that a document gave it.
class OpenPolicy {
 public:
  OpenPolicy() = default;
  OpenPolicy(OpenPolicy const&) = delete;
  virtual ~OpenPolicy() = default;
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view title() const = 0;
  /// Adds the parameters to an object of the echo.
  virtual void write_parameters(nlohmann::json& object) const = 0;
};

/// What can be asked of a policy before it is chosen.
template <class Base>
struct Offer {
  std::string_view name;
  Alternative (*outline)();
  /// Pre: the value was examined and has no mistakes.
  std::shared_ptr<Base const> (*read)(nlohmann::json const& value, Reader& reader, std::string const& pointer);
};

template <class Base>
using Offers = std::span<Offer<Base> const* const>;

/// The part of a Base that a policy's table gives.
template <class Base, Policy P>
class Offered : public Base {
 public:
  explicit Offered(typename P::Parameters parameters) : parameters_(std::move(parameters)) {}
  [[nodiscard]] std::string_view name() const final { return P::name; }
  [[nodiscard]] std::string_view title() const final { return P::title; }
  void write_parameters(nlohmann::json& object) const final { detail::write_members(parameters_, object); }

 protected:
  typename P::Parameters parameters_;
};

/// The offer of a class that derives from Offered<Base, P>.
template <class Base, Policy P, class Derived>
constexpr Offer<Base> offer_of() {
  return {P::name, [] { return detail::outline_of_policy<P>(); },
          [](nlohmann::json const& value, Reader& reader, std::string const& pointer) -> std::shared_ptr<Base const> {
            typename P::Parameters parameters;
            detail::Filler{reader}.fill(&value, parameters, pointer);
            return std::make_shared<Derived>(std::move(parameters));
          }};
}

/// The one that was chosen of those that Base::offers() gives.
template <class Base>
class OpenChoice {
 public:
  [[nodiscard]] bool is_empty() const { return chosen_ == nullptr; }
  /// Throws: InputError if nothing was chosen.
  Base const* operator->() const {
    if (is_empty()) throw InputError("nothing was chosen where a choice is needed");
    return chosen_.get();
  }
  [[nodiscard]] std::string_view name() const { return (*this)->name(); }
  void write_parameters(nlohmann::json& object) const { (*this)->write_parameters(object); }

  [[nodiscard]] static std::vector<Alternative> alternatives() {
    std::vector<Alternative> list;
    for (Offer<Base> const* offer : Base::offers()) list.push_back(offer->outline());
    return list;
  }
  /// Pre: the value was examined and has no mistakes.
  [[nodiscard]] static OpenChoice read(nlohmann::json const& value, Reader& reader, std::string const& pointer) {
    OpenChoice choice;
    for (Offer<Base> const* offer : Base::offers())
      if (offer->name == detail::type_of(value)) choice.chosen_ = offer->read(value, reader, pointer);
    return choice;
  }

 private:
  std::shared_ptr<Base const> chosen_;
};

}  // namespace talus
