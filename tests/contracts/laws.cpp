#include <boost/test/unit_test.hpp>
#include <set>
#include <string>
#include <string_view>

#include "core/type_list.hpp"
#include "models/catalogue_laws.hpp"
#include "tests/contracts/law_contracts.hpp"

using namespace talus;

namespace {

/// Calls contract(type) for every law of the catalogue and reports what is broken.
template <class F>
void for_each_law(F&& contract) {
  for_each_type(catalogue::Laws{}, [&](auto type) {
    using L = typename decltype(type)::type;
    std::string const broken = contract(type);
    BOOST_TEST(broken.empty(), L::name << ": " << broken);
  });
}

template <class Type>
using LawOf = typename Type::type;

}  // namespace

BOOST_AUTO_TEST_SUITE(laws)

BOOST_AUTO_TEST_CASE(defaults_are_possible_and_names_are_told_apart) {
  for_each_law([](auto type) -> std::string {
    using Parameters = typename LawOf<decltype(type)>::Parameters;
    std::string fault;
    std::set<std::string_view> names;
    for_each_parameter<Parameters>([&](auto const& row) {
      if (!row.range.contains(Parameters{}.*row.member)) fault += std::string(row.name) + " is out of its range; ";
      if (!names.insert(row.name).second) fault += std::string(row.name) + " is there twice; ";
    });
    if constexpr (Checked<Parameters>) fault += Parameters::check(Parameters{}).value_or("");
    return fault;
  });
}

BOOST_AUTO_TEST_CASE(stress_is_the_gradient_of_the_energy) {
  for_each_law([](auto type) { return contract_of::stress_is_the_gradient_of_the_energy<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(projection_is_admissible_and_finite) {
  for_each_law([](auto type) { return contract_of::projection_is_admissible<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(kuhn_tucker_conditions_hold) {
  for_each_law([](auto type) { return contract_of::kuhn_tucker_conditions_hold<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(projection_of_a_rate_independent_law_is_idempotent) {
  for_each_law([](auto type) -> std::string {
    using L = LawOf<decltype(type)>;
    if constexpr (L::rate_dependent)
      return {};
    else
      return contract_of::projection_is_idempotent<L>();
  });
}

BOOST_AUTO_TEST_CASE(viscous_stress_lies_between_trial_and_yield) {
  for_each_law([](auto type) -> std::string {
    using L = LawOf<decltype(type)>;
    if constexpr (L::rate_dependent)
      return contract_of::viscous_stress_lies_between_trial_and_yield<L>();
    else
      return {};
  });
}

BOOST_AUTO_TEST_CASE(plastic_work_is_never_negative) {
  for_each_law([](auto type) { return contract_of::plastic_work_is_never_negative<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(projection_keeps_the_volume) {
  for_each_law([](auto type) { return contract_of::projection_keeps_the_volume<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(result_does_not_depend_on_the_order_of_the_axes) {
  for_each_law(
      [](auto type) { return contract_of::result_does_not_depend_on_the_order_of_the_axes<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(projection_is_objective) {
  for_each_law([](auto type) { return contract_of::projection_is_objective<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_CASE(a_pack_gives_the_same_as_its_lanes) {
  for_each_law([](auto type) { return contract_of::a_pack_gives_the_same_as_its_lanes<LawOf<decltype(type)>>(); });
}

BOOST_AUTO_TEST_SUITE_END()
