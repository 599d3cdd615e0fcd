/// The test program. Every file below tests/ holds one suite that bears the file's name. Its main is written out because
/// BOOST_TEST_MODULE would have to be defined before the precompiled header is read.
#include <boost/test/unit_test.hpp>

int main(int argc, char** argv) {
  auto const begin = [] {
    boost::unit_test::framework::master_test_suite().p_name.value = "talus";
    return true;
  };
  return boost::unit_test::unit_test_main(begin, argc, argv);
}
