/// Where a result comes from.

#include <stdlib.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <regex>
#include <thread>

#include "core/build_info.hpp"
#include "core/config/json.hpp"
#include "core/io/machine.hpp"
#include "core/io/provenance.hpp"

BOOST_AUTO_TEST_SUITE(io_provenance)

using namespace talus;
using nlohmann::json;

BOOST_AUTO_TEST_CASE(what_the_caller_says_is_in_the_document) {
  auto const document = io::provenance_document({.command_line = {"talus", "run", "a b.json"},
                                                 .threads = 3,
                                                 .seed = 18446744073709551615u,
                                                 .inputs = {{"a b.json", std::string(64, 'f')}},
                                                 .start = "2024-05-31T12:00:00Z",
                                                 .end = ""});
  BOOST_TEST(document.at("command_line") == json({"talus", "run", "a b.json"}));
  BOOST_TEST(document.at("threads") == 3);
  BOOST_TEST(document.at("seed").dump() == "18446744073709551615");
  BOOST_TEST(document.at("inputs").at(0).at("name") == "a b.json");
  BOOST_TEST(document.at("inputs").at(0).at("sha256") == std::string(64, 'f'));
  BOOST_TEST(document.at("start") == "2024-05-31T12:00:00Z");
  BOOST_TEST(document.at("end").is_null());
}

BOOST_AUTO_TEST_CASE(program_build_libraries_and_machine_are_in_the_document) {
  auto const document = io::provenance_document({});
  BOOST_TEST(document.at("version") == build_info::version);
  BOOST_TEST(document.at("build").at("compiler") == build_info::compiler);
  BOOST_TEST(document.at("build").at("flags") == build_info::compiler_flags);
  BOOST_TEST(document.at("build").at("git").at("commit") == build_info::git_commit);
  BOOST_TEST(document.at("build").at("git").at("diff") == build_info::git_diff);
  std::regex const version(R"(\d+\.\d+\.\d+)");
  for (std::string const library : {"Eigen", "nlohmann-json", "HDF5", "fmt", "CLI11"})
    BOOST_TEST(std::regex_match(document.at("libraries").at(library).get<std::string>(), version), library);
  BOOST_TEST(!document.at("machine").at("cpu").get<std::string>().empty());
  BOOST_TEST(document.at("machine").at("operating_system").get<std::string>().find("Linux") != std::string::npos);
  BOOST_TEST(document.at("machine").at("processors") == std::thread::hardware_concurrency());
}

BOOST_AUTO_TEST_CASE(the_names_of_machine_and_user_are_left_out) {
  auto const text =
      io::provenance_document({.command_line = {"talus"}, .inputs = {}, .start = "", .end = ""}).at("machine").dump();
  char host[256] = {};
  BOOST_REQUIRE(gethostname(host, sizeof host - 1) == 0);
  BOOST_TEST(text.find("\"" + std::string(host) + "\"") == text.npos);
}

BOOST_AUTO_TEST_CASE(the_environment_of_openmp_is_recorded_and_nothing_else_of_it) {
  setenv("OMP_TALUS_TEST", "close=1", 1);
  setenv("TALUS_SECRET", "x", 1);
  auto const environment = io::thread_environment();
  unsetenv("OMP_TALUS_TEST");
  unsetenv("TALUS_SECRET");
  BOOST_TEST(environment.at("OMP_TALUS_TEST") == "close=1");
  for (auto const& [name, value] : environment)
    BOOST_TEST((name.starts_with("OMP_") || name.starts_with("GOMP_") || name.starts_with("KMP_")), name);
}

BOOST_AUTO_TEST_CASE(peak_memory_counts_what_was_held) {
  constexpr std::size_t bytes = 64 << 20;
  auto const before = io::peak_memory();
  {
    std::vector<char> const held(bytes, 'x');
    asm volatile("" : : "r"(held.data()) : "memory");  // a compiler may leave out memory that nobody looks at
  }
  BOOST_TEST(io::peak_memory() > static_cast<std::int64_t>(bytes));
  BOOST_TEST(io::peak_memory() >= before);
}

BOOST_AUTO_TEST_CASE(numbers_that_json_does_not_know_become_null_with_a_reason) {
  using Limits = std::numeric_limits<double>;
  json document;
  io::set_number(document, "a", 0.1 + 0.2);
  io::set_number(document, "b", Limits::quiet_NaN());
  io::set_number(document, "c", Limits::infinity());
  io::set_number(document, "d", -Limits::infinity());
  BOOST_TEST(document == json_of(R"({"a": 0.30000000000000004, "b": null, "b_status": "nan", "c": null,
                                         "c_status": "inf", "d": null, "d_status": "-inf"})"));
  BOOST_TEST(io::number_of(document, "a") == 0.1 + 0.2);
  BOOST_TEST((std::isnan(io::number_of(document, "b")) && std::isnan(io::number_of(document, "not there"))));
  BOOST_TEST(io::number_of(document, "c") == Limits::infinity());
  BOOST_TEST(io::number_of(document, "d") == -Limits::infinity());
  io::set_number(document, "b", 1);
  BOOST_TEST(!document.contains("b_status"));
}

BOOST_AUTO_TEST_CASE(the_time_is_in_utc) {
  BOOST_TEST(std::regex_match(io::utc_now(), std::regex(R"(20\d\d-[01]\d-[0-3]\dT[0-2]\d:[0-5]\d:[0-6]\dZ)")));
}

BOOST_AUTO_TEST_SUITE_END()
