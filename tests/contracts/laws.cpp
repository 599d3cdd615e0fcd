/// What concerns the laws together. The contracts of each are units of their own, made from laws_unit.cpp.in.

#include <boost/test/unit_test.hpp>
#include <set>
#include <string_view>

#include "core/type_list.hpp"
#include "models/catalogue_laws.hpp"
#include "tests/contracts/law_suite.hpp"

using namespace talus;
namespace ut = boost::unit_test;

namespace {

/// The suite of this name within another, made if there is none yet.
ut::test_suite& suite_in(ut::test_suite& parent, char const* name) {
  if (auto const id = parent.get(name); id != ut::INV_TEST_UNIT_ID) return ut::framework::get<ut::test_suite>(id);
  auto* suite = new ut::test_suite(name, __FILE__, __LINE__);  // parent's from now on
  parent.add(suite);
  return *suite;
}

}  // namespace

bool contract_of::add_tests(char const* law, std::vector<Contract> const& contracts) {
  auto& suite = suite_in(suite_in(ut::framework::current_auto_test_suite(), "laws"), law);
  for (auto const& [name, broken] : contracts) {
    auto const keeps_it = [broken = broken] { BOOST_TEST(broken() == ""); };
    suite.add(ut::make_test_case(keeps_it, std::string(name), __FILE__, __LINE__));
  }
  return true;
}

BOOST_AUTO_TEST_SUITE(laws)

BOOST_AUTO_TEST_CASE(every_law_has_a_name_of_its_own) {
  std::set<std::string_view> names;
  for_each_type(catalogue::Laws{}, [&](auto type) {
    using L = typename decltype(type)::type;
    BOOST_TEST(names.insert(L::name).second, L::name);
  });
}

BOOST_AUTO_TEST_SUITE_END()
