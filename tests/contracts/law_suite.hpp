#pragma once
/// Every contract of a law, as a test that bears its name.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/contracts/law_flow.hpp"

namespace talus::contract_of {

template <class L>
std::string defaults_are_possible_and_names_are_told_apart() {
  using Parameters = typename L::Parameters;
  std::string fault;
  std::set<std::string_view> names;
  for_each_parameter<Parameters>([&](auto const& row) {
    if (!row.range.contains(Parameters{}.*row.member)) fault += std::string(row.name) + " is out of its range; ";
    if (!names.insert(row.name).second) fault += std::string(row.name) + " is there twice; ";
  });
  if constexpr (Checked<Parameters>) fault += Parameters::check(Parameters{}).value_or("");
  return fault;
}

/// A contract by its name: says what is broken, or nothing.
struct Contract {
  std::string_view name;
  std::string (*broken)();
};

/// Those that concern the law.
template <class L>
std::vector<Contract> contracts() {
  std::vector<Contract> all{
      {"defaults_are_possible_and_names_are_told_apart", defaults_are_possible_and_names_are_told_apart<L>},
      {"stress_is_the_gradient_of_the_energy", stress_is_the_gradient_of_the_energy<L>},
      {"projection_is_admissible_and_finite", projection_is_admissible<L>},
      {"projection_does_not_hide_what_is_no_number", projection_does_not_hide_what_is_no_number<L>},
      {"kuhn_tucker_conditions_hold", kuhn_tucker_conditions_hold<L>},
      {"plastic_work_is_never_negative", plastic_work_is_never_negative<L>},
      {"projection_keeps_the_volume", projection_keeps_the_volume<L>},
      {"result_does_not_depend_on_the_order_of_the_axes", result_does_not_depend_on_the_order_of_the_axes<L>},
      {"projection_is_objective", projection_is_objective<L>},
      {"a_pack_gives_the_same_as_its_lanes", a_pack_gives_the_same_as_its_lanes<L>},
  };
  if constexpr (L::rate_dependent) {
    all.push_back({"viscous_stress_lies_between_trial_and_yield", viscous_stress_lies_between_trial_and_yield<L>});
    all.push_back({"viscous_flow_law_is_satisfied", viscous_flow_law_is_satisfied<L>});
  } else {
    all.push_back({"projection_of_a_rate_independent_law_is_idempotent", projection_is_idempotent<L>});
  }
  if constexpr (is_associated<L>)
    all.push_back({"associated_flow_is_normal_to_the_potential", flow_is_normal_to_the_potential<L>});
  if constexpr (Recovers<L>)
    all.push_back({"recovery_is_part_of_the_projection", recovery_is_part_of_the_projection<L>});
  return all;
}

/// Makes a test of each, in the suite laws/LAW.
bool add_tests(char const* law, std::vector<Contract> const& contracts);

}  // namespace talus::contract_of
