#pragma once
/// The manual's pages: tables of parameters in Markdown.

#include <string>
#include <vector>

#include "core/config/outline.hpp"

namespace talus {

/// A table: name, symbol, unit, default, range, meaning. What is within a group or list has a row of its own, its name
/// after that of the group ("grain/diameter", "bodies/0/density").
[[nodiscard]] std::string parameter_table(std::vector<Outline> const& parameters);

/// A policy's page: its title, the name to write in a document, its source and its table.
[[nodiscard]] std::string policy_page(Alternative const& policy);

/// The page of a policy.
template <Policy P>
[[nodiscard]] std::string policy_page() {
  return policy_page(detail::outline_of_policies(TypeList<P>{}).front());
}

}  // namespace talus
