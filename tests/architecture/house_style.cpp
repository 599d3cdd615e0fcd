/// What a script can check of how the sources are written.

#include <boost/test/unit_test.hpp>
#include <map>

#include "tests/architecture/sources.hpp"

BOOST_AUTO_TEST_SUITE(house_style)

using namespace talus::architecture;

namespace {

constexpr std::size_t wanted_length = 250, longest = 300;

/// Preprocessor directives of a file of core or models, apart from #include, #pragma once, loops to be unrolled and the
/// threads' own.
std::vector<std::string> directives(Source const& source) {
  static std::regex const pattern(
      R"(^\s*#\s*(define|undef|if|ifdef|ifndef|elif|else|endif|error|warning|line|pragma)\b(.*))");
  std::vector<std::string> found;
  for (std::smatch match; auto const& line : source.lines) {
    if (!std::regex_search(line, match, pattern)) continue;
    bool const pragma = match[1] == "pragma";
    bool const threads = source.path == "core/parallel.hpp" && match[2].str().starts_with(" omp ");
    bool const unrolls = match[2].str().starts_with(" GCC unroll ");
    if (!pragma || (match[2] != " once" && !unrolls && !threads)) found.push_back(source.path + ": " + line);
  }
  return found;
}

/// Marks of unfinished work, names that say nothing, paths of one machine. Written in two halves, for this file is
/// read as well.
std::vector<std::string> forbidden(Source const& source) {
  static std::regex const words(
      "\\b(TO"
      "DO|FIX"
      "ME|X"
      "XX|HA"
      "CK)\\b|[\"( ]/(ho"
      "me|ro"
      "ot|wo"
      "rk)/");
  static std::regex const names(
      ".*(util|help"
      "er|common|manager|misc)[^/]*$");
  std::vector<std::string> found;
  if (std::regex_match(source.path, names)) found.push_back(source.path + ": the name does not say what is in it");
  for (auto const& line : source.lines)
    if (std::regex_search(line, words)) found.push_back(source.path + ": " + line);
  return found;
}

/// What keeps ctest, which runs the suite that bears the file's name, from running all of a file's cases.
std::string suite_fault(Source const& source) {
  static std::regex const opens(R"(^BOOST_(AUTO|FIXTURE)_TEST_SUITE\(\s*(\w+))"), closes("^BOOST_AUTO_TEST_SUITE_END");
  static std::regex const cases(R"(^BOOST_(AUTO|FIXTURE|DATA)_TEST_CASE)");
  std::string const stem = std::filesystem::path(source.path).stem().string();
  int depth = 0, suites = 0;
  for (std::smatch found; auto const& line : source.lines) {
    if (std::regex_search(line, found, closes)) --depth;
    if (std::regex_search(line, found, cases) && depth == 0)
      return source.path + ": a case outside of the suite " + stem;
    if (!std::regex_search(line, found, opens)) continue;
    if (depth++ == 0 && found[2] != stem) return source.path + ": a suite that is not called " + stem;
    if (depth == 1) ++suites;
  }
  return suites == 1 ? "" : source.path + ": needs the suite " + stem + ", once";
}

bool is_test(Source const& source) {
  return first_folder(source.path) == "tests" && source.path.ends_with(".cpp") && source.path != "tests/main.cpp" &&
         !is_below(source.path, "tests/package") && !is_below(source.path, "tests/fuzz");
}

std::string fault(std::string path, std::vector<std::string> lines) {
  return suite_fault({std::move(path), std::move(lines)});
}

}  // namespace

BOOST_AUTO_TEST_CASE(core_and_models_hold_no_macro_and_no_condition) {
  for (auto const& source : read_sources())
    if (is_below_any(source.path, {"core", "models"})) BOOST_TEST(joined(directives(source)) == "");
}

BOOST_AUTO_TEST_CASE(a_macro_is_found) {
  Source const planted{"core/grid.hpp", {"#pragma once", "# define CELLS 3", "  #ifdef CELLS", "#pragma omp parallel"}};
  BOOST_TEST(directives(planted).size() == 3u);
  BOOST_TEST(directives({"core/parallel.hpp", {"#pragma once", "#pragma omp parallel for"}}).empty());
  BOOST_TEST(directives({"core/stencil.hpp", {"#pragma GCC unroll 4", "#pragma GCC optimize 3"}}).size() == 1u);
}

BOOST_AUTO_TEST_CASE(files_are_short) {
  for (auto const& source : read_sources()) {
    auto const length = source.lines.size();
    BOOST_TEST(length <= longest, source.path << " has " << length << " lines, more than " << longest);
    if (length > wanted_length)
      BOOST_TEST_MESSAGE(source.path << " has " << length << " lines, the budget is " << wanted_length);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_left_undone_or_named_for_nothing) {
  for (auto const& source : read_sources()) BOOST_TEST(joined(forbidden(source)) == "");
}

BOOST_AUTO_TEST_CASE(what_is_left_undone_is_found) {
  BOOST_TEST(forbidden({"core/grid.hpp",
                        {"// TO"
                         "DO: write",
                         "auto x = \"/ho"
                         "me/me/x\";"}})
                 .size() == 2u);
  BOOST_TEST(forbidden({"core/grid_util"
                        "s.hpp",
                        {}})
                 .size() == 1u);
  BOOST_TEST(forbidden({"core/grid.hpp", {"// what is to do here, at home, at work"}}).empty());
}

BOOST_AUTO_TEST_CASE(every_test_file_holds_one_suite_of_its_own_name) {
  std::map<std::string, std::string> stems;
  for (auto const& source : read_sources()) {
    if (!is_test(source)) continue;
    BOOST_TEST(suite_fault(source) == "");
    auto const [place, is_new] = stems.emplace(std::filesystem::path(source.path).stem().string(), source.path);
    BOOST_TEST(is_new, place->second << " and " << source.path << " share a name");
  }
}

BOOST_AUTO_TEST_CASE(a_case_that_ctest_would_miss_is_found) {
  std::string const begin = "BOOST_AUTO_TEST_SUITE(", end = "BOOST_AUTO_TEST_SUITE_END()",
                    one = "BOOST_AUTO_TEST_CASE(is)";
  BOOST_TEST(fault("tests/core/pack.cpp", {begin + "pack)", one, begin + "inner)", one, end, end}) == "");
  BOOST_TEST(fault("tests/core/pack.cpp", {one}) != "");
  BOOST_TEST(fault("tests/core/pack.cpp", {begin + "packs)", one, end}) != "");
  BOOST_TEST(fault("tests/core/pack.cpp", {begin + "pack)", end, begin + "more)", one, end}) != "");
  BOOST_TEST(fault("tests/core/pack.cpp", {begin + "pack)", end, begin + "pack)", one, end}) != "");
}

BOOST_AUTO_TEST_SUITE_END()
