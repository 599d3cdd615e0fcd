/// What concerns the laws together. The contracts of each are units of their own, made from laws_unit.cpp.in.

#include <boost/test/unit_test.hpp>
#include <set>
#include <string_view>

#include "core/type_list.hpp"
#include "models/catalogue_laws.hpp"

using namespace talus;

BOOST_AUTO_TEST_SUITE(laws)

BOOST_AUTO_TEST_CASE(every_law_has_a_name_of_its_own) {
  std::set<std::string_view> names;
  for_each_type(catalogue::Laws{}, [&](auto type) {
    using L = typename decltype(type)::type;
    BOOST_TEST(names.insert(L::name).second, L::name);
  });
}

BOOST_AUTO_TEST_SUITE_END()
