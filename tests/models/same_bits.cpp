#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "core/cli/program.hpp"
#include "core/io/hash.hpp"
#include "core/parallel.hpp"

BOOST_AUTO_TEST_SUITE(same_bits)

using namespace talus;

namespace {

/// A shipped case with some of its values changed.
Document shipped(std::string const& name, std::vector<std::string> const& assignments) {
  std::ifstream file(std::string(std::getenv("TALUS_SOURCE_DIR")) + "/verification/studies/" + name);
  BOOST_REQUIRE(file);
  std::stringstream text;
  text << file.rdbuf();
  Document document = parse(text.str(), name);
  for (std::string const& assignment : assignments) set_value(document, assignment);
  return document;
}

std::unique_ptr<Experiment> composed(Document const& document) {
  return program().compose(document).experiment;
}

void run(Experiment& experiment, long steps) {
  while (experiment.steps() < steps) experiment.advance(std::numeric_limits<double>::infinity());
}

/// A case, and how long it must be run so that particles are sorted several times.
struct Trial {
  std::string name;
  Document document;
  long steps;
};

std::vector<Trial> trials() {
  std::vector<Trial> list;
  list.push_back({"dam break", shipped("dam_break_22.json", {"/grid/spacing=0.02"}), 300});
  list.push_back({"column thrown up between moving gates",
                  shipped("column_3d.json",
                          {"/grid/spacing=0.01", R"(/bodies/0/velocity={"type": "uniform", "velocity": [0.4, 1, 0]})"}),
                  400});
  list.push_back({"slope that repeats",
                  shipped("dam_break_22.json", {"/grid/spacing=0.02", "/grid/periods=[0.32, 0]", "/kernel/type=cubic",
                                                "/integrator/type=musl"}),
                  300});
  // The back wall stands in the way of what repeats.
  list.back().document.value["walls"].erase(1);
  // An odd number of blocks: the last one has a colour of its own.
  list.push_back({"slope that repeats after three blocks",
                  shipped("dam_break_22.json", {"/grid/spacing=0.02", "/grid/periods=[0.24, 0]"}), 300});
  list.back().document.value["walls"].erase(1);
  return list;
}

/// Restores the number of threads that a test changed.
struct Threads {
  int before = thread_count();
  Threads() = default;
  Threads(Threads const&) = delete;
  ~Threads() { set_thread_count(before); }
};

std::string hash_after(Document const& document, long steps, int threads) {
  set_thread_count(threads);
  auto const experiment = composed(document);
  run(*experiment, steps);
  return io::state_hash(experiment->state());
}

/// The columns of a state that have these names; not the others.
Snapshot only(Snapshot snapshot, std::vector<std::string> const& names) {
  std::erase_if(snapshot.columns, [&](NamedColumn const& column) {
    return std::find(names.begin(), names.end(), column.name) == names.end();
  });
  return snapshot;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_number_of_threads_changes_no_bit) {
  Threads const restored;
  for (Trial const& trial : trials()) BOOST_TEST_CONTEXT(trial.name) {
      std::string const one = hash_after(trial.document, trial.steps, 1);
      for (int const threads : {2, 3, 8}) BOOST_TEST(hash_after(trial.document, trial.steps, threads) == one);
    }
}

BOOST_AUTO_TEST_CASE(particles_cross_blocks_and_are_sorted_while_the_bits_are_compared) {
  for (Trial const& trial : trials()) BOOST_TEST_CONTEXT(trial.name) {
      auto const experiment = composed(trial.document);
      run(*experiment, trial.steps);
      BOOST_TEST(experiment->sorts() >= 3);
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_is_resumed_half_way_ends_with_the_same_bits) {
  for (Trial const& trial : trials()) BOOST_TEST_CONTEXT(trial.name) {
      auto const through = composed(trial.document), stopped = composed(trial.document);
      auto const resumed = composed(trial.document);
      run(*stopped, trial.steps / 2);
      resumed->restore(stopped->checkpoint());
      BOOST_TEST(io::state_hash(resumed->state()) == io::state_hash(stopped->state()));
      run(*resumed, trial.steps);
      run(*through, trial.steps);
      BOOST_TEST(io::state_hash(resumed->state()) == io::state_hash(through->state()));
      BOOST_TEST(resumed->measure() == through->measure(), boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(a_resumed_run_does_not_depend_on_what_was_computed_before_in_its_place) {
  Document const document = trials().front().document;
  auto const stopped = composed(document), used = composed(document), fresh = composed(document);
  run(*stopped, 100);
  run(*used, 170);
  used->restore(stopped->checkpoint());
  fresh->restore(stopped->checkpoint());
  run(*used, 200);
  run(*fresh, 200);
  BOOST_TEST(io::state_hash(used->state()) == io::state_hash(fresh->state()));
}

BOOST_AUTO_TEST_CASE(the_order_in_which_walls_are_listed_changes_no_bit_of_the_particles) {
  for (Trial const& trial : trials()) BOOST_TEST_CONTEXT(trial.name) {
      Document turned = trial.document;
      auto& walls = turned.value["walls"];
      std::reverse(walls.begin(), walls.end());
      auto const one = composed(trial.document), other = composed(turned);
      run(*one, trial.steps);
      run(*other, trial.steps);
      BOOST_TEST(io::state_hash(one->state()) == io::state_hash(other->state()));
    }
}

BOOST_AUTO_TEST_CASE(one_bit_of_the_input_changes_the_hash) {
  Document const document = trials().front().document;
  Document other = document;
  double const density = other.value["materials"][0]["density"].get<double>();
  other.value["materials"][0]["density"] = std::nextafter(density, 2 * density);
  auto const one = composed(document), changed = composed(other);
  run(*one, 20);
  run(*changed, 20);
  BOOST_TEST(io::state_hash(only(one->state(), {"id", "position"})) !=
             io::state_hash(only(changed->state(), {"id", "position"})));
}

BOOST_AUTO_TEST_SUITE_END()
