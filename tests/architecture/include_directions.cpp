/// Who may include whom:  core <- models <- verification <- benchmarks <- tests.

#include <boost/test/unit_test.hpp>
#include <map>
#include <set>

#include "tests/architecture/sources.hpp"

BOOST_AUTO_TEST_SUITE(include_directions)

using namespace talus::architecture;

namespace {

/// How far a folder is from core; a file includes files of smaller rank, or of its own folder.
int rank(std::string const& folder) {
  static std::map<std::string, int> const ranks{
      {"core", 0}, {"models", 1}, {"verification", 2}, {"benchmarks", 3}, {"tests", 4}};
  auto const found = ranks.find(folder);
  return found == ranks.end() ? -1 : found->second;
}

/// Files that compose from JSON, or read and write: everything else in core and models computes.
bool computes(std::string const& path) {
  if (first_folder(path) == "core") return !is_below_any(path, {"core/config", "core/io", "core/cli"});
  return first_folder(path) == "models" && folder_of(path) != "models";
}

bool is_standard(std::string const& header) {
  return header.find('/') == std::string::npos && header.find('.') == std::string::npos;
}

std::string wrong(Source const& source, std::string const& target, std::string const& why) {
  return source.path + " includes " + target + ": " + why;
}

/// What is wrong with an include of one of the project's own files.
std::string own_fault(Source const& source, std::string const& target, std::vector<std::string> const& policies) {
  if (target == "core/build_info.hpp" && !is_below_any(source.path, {"core/io", "core/cli", "tests"}))
    return wrong(source, target, "it changes with every edit, so few may compile it");
  std::string const from = first_folder(source.path), to = first_folder(target);
  if (rank(to) < 0) return wrong(source, target, "own files are named from the root, as in core/tensor.hpp");
  if (to != from && rank(to) >= rank(from)) return wrong(source, target, from + " must not know " + to);
  if (is_below(source.path, "verification/reference") && !is_below(target, "verification/reference"))
    return wrong(source, target, "the truth shares no code with the solver");
  if (to != "models" || from != "models" || folder_of(source.path) == "models") return "";
  auto const kind_end = source.path.find('/', from.size() + 1);
  if (!is_below(target, source.path.substr(0, kind_end))) return wrong(source, target, "policies meet through fields");
  bool const listed = std::find(policies.begin(), policies.end(), target) != policies.end();
  return listed ? wrong(source, target, "policies never name one another") : "";
}

/// What is wrong with an include of somebody else's file.
std::string foreign_fault(Source const& source, std::string const& target) {
  static std::regex const oracle("^(sundials|sun[a-z]+|nvector|cvodes?|idas?|kinsol|arkode|gsl)/.*");
  static std::regex const instrument("^(boost|benchmark)/.*");
  if (is_standard(target)) return "";
  std::string const from = first_folder(source.path);
  bool const solver = from == "core" || from == "models";
  if (solver && std::regex_match(target, oracle))
    return wrong(source, target, "the truth shares no code with the solver");
  if (solver && std::regex_match(target, instrument)) return wrong(source, target, "measures, so stays outside");
  if (target == "omp.h")
    return source.path == "core/parallel.hpp" ? "" : wrong(source, target, "only core/parallel.hpp");
  if (computes(source.path) && !target.starts_with("Eigen/"))
    return wrong(source, target, "what computes knows the standard library and Eigen");
  bool const json_only = is_below(source.path, "core/config") || folder_of(source.path) == "models";
  if (json_only && !target.starts_with("Eigen/") && !target.starts_with("nlohmann/"))
    return wrong(source, target, "beside the standard library and Eigen, JSON alone");
  return "";
}

std::vector<std::string> faults(Source const& source, std::vector<std::string> const& policies) {
  std::vector<std::string> found;
  for (auto const& [target, quoted] : includes_of(source))
    if (auto fault = quoted ? own_fault(source, target, policies) : foreign_fault(source, target); !fault.empty())
      found.push_back(fault);
  return found;
}

/// A file of these lines has that many faults.
std::size_t count(std::string path, std::vector<std::string> lines) {
  return faults({std::move(path), std::move(lines)}, {"models/laws/one.hpp"}).size();
}

/// Somebody else's headers that a file reaches through the project's own ones.
std::set<std::string> reached(std::string const& from, std::map<std::string, std::vector<Include>> const& graph) {
  std::set<std::string> seen{from}, foreign;
  std::vector<std::string> open{from};
  while (!open.empty()) {
    auto const node = graph.find(open.back());
    open.pop_back();
    if (node == graph.end()) continue;  // a generated file
    for (auto const& [target, quoted] : node->second) {
      if (!quoted) foreign.insert(target);
      if (quoted && seen.insert(target).second) open.push_back(target);
    }
  }
  return foreign;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_include_follows_the_rules) {
  auto const sources = read_sources();
  auto const policies = listed_policies();
  BOOST_TEST(sources.size() > 20u);  // the tree was found
  BOOST_TEST(!policies.empty());
  for (auto const& source : sources) BOOST_TEST(joined(faults(source, policies)) == "");
}

BOOST_AUTO_TEST_CASE(what_computes_reaches_no_json_and_no_files) {
  std::map<std::string, std::vector<Include>> graph;
  for (auto const& source : read_sources()) graph[source.path] = includes_of(source);
  for (auto const& [path, includes] : graph) {
    if (!computes(path)) continue;
    for (auto const& header : reached(path, graph))
      BOOST_TEST((is_standard(header) || header.starts_with("Eigen/") || header == "omp.h"),
                 path << " reaches " << header << " through what it includes");
  }
}

BOOST_AUTO_TEST_CASE(an_include_against_the_direction_is_found) {
  BOOST_TEST(count("core/grid.hpp", {"#include \"models/laws/one.hpp\""}) == 1u);
  BOOST_TEST(count("models/case.hpp", {"#include \"verification/exact/bagnold.hpp\""}) == 1u);
  BOOST_TEST(count("verification/order.hpp", {"#include \"tests/support/mutants.hpp\""}) == 1u);
  BOOST_TEST(count("verification/reference/path.hpp", {"#include \"core/tensor.hpp\""}) == 1u);
  BOOST_TEST(count("verification/order.hpp", {"#include \"core/tensor.hpp\""}) == 0u);
  BOOST_TEST(count("benchmarks/stages.cpp", {"#include \"tests/support/mutants.hpp\""}) == 1u);
  BOOST_TEST(count("core/grid.hpp", {"#include \"tensor.hpp\"", "#include \"../models/case.hpp\""}) == 2u);
  BOOST_TEST(count("core/grid.hpp", {"#include \"core/build_info.hpp\""}) == 1u);
  BOOST_TEST(count("tests/core/grid.cpp", {"#include \"core/grid.hpp\"", "#include \"models/laws/one.hpp\""}) == 0u);
}

BOOST_AUTO_TEST_CASE(a_policy_that_names_another_is_found) {
  BOOST_TEST(count("models/laws/two.hpp", {"#include \"models/laws/one.hpp\""}) == 1u);
  BOOST_TEST(count("models/laws/parts/rate.hpp", {"#include \"models/laws/one.hpp\""}) == 1u);
  BOOST_TEST(count("models/laws/two.hpp", {"#include \"models/kernels/parts.hpp\""}) == 1u);
  BOOST_TEST(count("models/laws/two.hpp", {"#include \"models/case.hpp\""}) == 1u);
  BOOST_TEST(count("models/laws/two.hpp", {"#include \"models/laws/parts/rate.hpp\""}) == 0u);
  BOOST_TEST(count("models/case.hpp", {"#include \"models/laws/one.hpp\""}) == 0u);
}

BOOST_AUTO_TEST_CASE(a_library_in_the_wrong_place_is_found) {
  BOOST_TEST(count("core/grid.hpp", {"#include <nlohmann/json.hpp>", "#include <hdf5.h>"}) == 2u);
  BOOST_TEST(count("models/laws/two.hpp", {"#include <gsl/gsl_roots.h>", "#include <cvode/cvode.h>"}) == 2u);
  BOOST_TEST(count("core/io/vtu.cpp", {"#include <sundials/sundials_types.h>", "#include <boost/math/tr1.hpp>"}) == 2u);
  BOOST_TEST(count("core/grid.hpp", {"#include <omp.h>", "  #  include <fmt/core.h>"}) == 2u);
  BOOST_TEST(count("core/config/read.cpp", {"#include <nlohmann/json.hpp>", "#include <fmt/core.h>"}) == 1u);
  BOOST_TEST(count("core/io/vtu.cpp", {"#include <nlohmann/json.hpp>", "#include <fmt/core.h>"}) == 0u);
  BOOST_TEST(count("core/grid.hpp", {"#include <vector>", "#include <Eigen/Core>"}) == 0u);
  BOOST_TEST(count("verification/reference/column.cpp", {"#include <cvode/cvode.h>", "#include <omp.h>"}) == 1u);
}

BOOST_AUTO_TEST_SUITE_END()
