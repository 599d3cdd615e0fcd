/// The test program. Every file below tests/ holds one suite that bears the file's name.
#define BOOST_TEST_MODULE talus
#include <boost/test/unit_test.hpp>
