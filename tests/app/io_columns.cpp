/// Tables of text are as wide as they must be.

#include "core/io/columns.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(io_columns)

using namespace talus;

BOOST_AUTO_TEST_CASE(a_column_is_as_wide_as_its_widest_cell) {
  BOOST_TEST(io::columns({{"a", "number"}, {"long", "1"}, {"b", "22"}}, "lr") ==
             "  a     number\n"
             "  long       1\n"
             "  b         22\n");
}

BOOST_AUTO_TEST_CASE(an_empty_column_is_left_out_and_characters_are_counted_not_bytes) {
  BOOST_TEST(io::columns({{"", "unused", "x"}, {"≥ 1", "", "y"}, {"2", "", "z"}}, "") ==
             "       x\n"
             "  ≥ 1  y\n"
             "  2    z\n");
}

BOOST_AUTO_TEST_CASE(numbers_have_four_digits) {
  BOOST_TEST(io::in_four_digits(0) == "0");
  BOOST_TEST(io::in_four_digits(123456) == "123456");
  BOOST_TEST(io::in_four_digits(12.3456) == "12.35");
  BOOST_TEST(io::in_four_digits(0.123456) == "0.123");
  BOOST_TEST(io::in_four_digits(1.23456e-5) == "1.235e-05");
  BOOST_TEST(io::in_four_digits(-1.5e9) == "-1.500e+09");
}

BOOST_AUTO_TEST_SUITE_END()
