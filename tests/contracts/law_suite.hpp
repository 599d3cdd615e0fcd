#pragma once
/// Every contract of a law by the name of its test; one that does not concern the law is kept.

#include <set>
#include <string>
#include <string_view>

#include "tests/contracts/law_flow.hpp"

namespace talus::contract_of {

template <class L>
struct Every {
  static std::string defaults_are_possible_and_names_are_told_apart() {
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
  static std::string stress_is_the_gradient_of_the_energy() {
    return contract_of::stress_is_the_gradient_of_the_energy<L>();
  }
  static std::string projection_is_admissible_and_finite() { return projection_is_admissible<L>(); }
  static std::string projection_does_not_hide_what_is_no_number() {
    return contract_of::projection_does_not_hide_what_is_no_number<L>();
  }
  static std::string kuhn_tucker_conditions_hold() { return contract_of::kuhn_tucker_conditions_hold<L>(); }
  static std::string projection_of_a_rate_independent_law_is_idempotent() {
    if constexpr (L::rate_dependent)
      return {};
    else
      return projection_is_idempotent<L>();
  }
  static std::string viscous_stress_lies_between_trial_and_yield() {
    if constexpr (L::rate_dependent)
      return contract_of::viscous_stress_lies_between_trial_and_yield<L>();
    else
      return {};
  }
  static std::string viscous_flow_law_is_satisfied() {
    if constexpr (L::rate_dependent)
      return contract_of::viscous_flow_law_is_satisfied<L>();
    else
      return {};
  }
  static std::string associated_flow_is_normal_to_the_potential() {
    if constexpr (is_associated<L>)
      return flow_is_normal_to_the_potential<L>();
    else
      return {};
  }
  static std::string recovery_is_part_of_the_projection() {
    if constexpr (Recovers<L>)
      return contract_of::recovery_is_part_of_the_projection<L>();
    else
      return {};
  }
  static std::string plastic_work_is_never_negative() { return contract_of::plastic_work_is_never_negative<L>(); }
  static std::string projection_keeps_the_volume() { return contract_of::projection_keeps_the_volume<L>(); }
  static std::string result_does_not_depend_on_the_order_of_the_axes() {
    return contract_of::result_does_not_depend_on_the_order_of_the_axes<L>();
  }
  static std::string projection_is_objective() { return contract_of::projection_is_objective<L>(); }
  static std::string a_pack_gives_the_same_as_its_lanes() {
    return contract_of::a_pack_gives_the_same_as_its_lanes<L>();
  }
};

}  // namespace talus::contract_of
