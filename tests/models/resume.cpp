/// Going on from a checkpoint whose contents no run has written: each is refused by name, and none leads out of the memory.

#include <boost/test/unit_test.hpp>
#include <functional>

#include "core/block_grid.hpp"
#include "tests/support/says.hpp"
#include "tests/support/small_case.hpp"

BOOST_AUTO_TEST_SUITE(resume)

using namespace talus;
using support::CaseUnderWay;
using support::says;

namespace {

using Integers = std::vector<std::int64_t>;
using Numbers = std::vector<double>;

CaseUnderWay const& plane() {
  static CaseUnderWay const made(support::in_the_plane);
  return made;
}

template <class T>
T& held(io::Checkpoint& state, std::string const& name) {
  return std::get<T>(state.values.at(name));
}

NamedColumn& column(io::Checkpoint& state, std::string_view name) {
  for (NamedColumn& candidate : state.particles.columns)
    if (candidate.name == name) return candidate;
  throw std::logic_error("no such column");
}

/// An edit of a good checkpoint, and what is said of the result.
struct Wrong {
  char const* name;
  std::function<void(io::Checkpoint&)> edit;
  char const* said;
};

std::vector<Wrong> const wrong{
    {"dimension", [](auto& c) { c.particles.dimension = 3; }, "another dimension"},
    {"time", [](auto& c) { c.particles.time = NAN; }, "its time is no time"},
    {"step", [](auto& c) { c.particles.step = -1; }, "its time is no time"},
    {"a step beyond counting", [](auto& c) { c.particles.step = INT64_MAX; }, "its time is no time"},
    {"keys missing", [](auto& c) { c.values.erase("block_keys"); }, "does not hold 'block_keys'"},
    {"keys negative", [](auto& c) { held<Integers>(c, "block_keys")[0] = -1; }, "no blocks of the case's grid"},
    {"keys out of order",
     [](auto& c) { std::swap(held<Integers>(c, "block_keys")[0], held<Integers>(c, "block_keys")[1]); },
     "no blocks of the case's grid"},
    {"keys too large", [](auto& c) { held<Integers>(c, "block_keys").back() = INT64_MAX; },
     "no blocks of the case's grid"},
    {"keys out of the period", [](auto& c) { held<Integers>(c, "block_keys").back() += 3; },
     "no blocks of the case's grid"},
    {"a block without particles",
     [](auto& c) {
       held<Integers>(c, "block_keys").push_back(static_cast<std::int64_t>(key_of<2>({50, 0})));
     },
     "not those of its blocks"},
    {"a run fewer", [](auto& c) { held<Integers>(c, "run_materials").pop_back(); }, "differ in length"},
    {"a run elsewhere", [](auto& c) { held<Integers>(c, "run_blocks")[0] = INT64_C(1) << 32; }, "not in order"},
    {"a run before the first block",
     [](auto& c) {
       --held<Integers>(c, "run_particles")[0];
       for (auto const& [list, first] : {std::pair{"run_blocks", -1}, {"run_materials", 0}, {"run_particles", 1}})
         held<Integers>(c, list).insert(held<Integers>(c, list).begin(), first);
     },
     "not in order"},
    {"no such material", [](auto& c) { held<Integers>(c, "run_materials").back() = 7; }, "not in order"},
    {"an empty run", [](auto& c) { held<Integers>(c, "run_particles")[0] = 0; }, "run without particles"},
    {"a huge run", [](auto& c) { held<Integers>(c, "run_particles")[0] = INT64_C(1) << 33; }, "run without particles"},
    {"a particle more", [](auto& c) { ++held<Integers>(c, "run_particles")[0]; }, "do not add up"},
    {"a field shorter", [](auto& c) { column(c, "velocity").values.pop_back(); }, "the field 'velocity'"},
    {"a field of another width", [](auto& c) { column(c, "elastic_strain").components = 3; }, "'elastic_strain'"},
    {"a field missing", [](auto& c) { column(c, "affine_velocity").name = "affine"; }, "the field 'affine_velocity'"},
    {"no number", [](auto& c) { column(c, "id").values[0] = 0.5; }, "a particle has no number"},
    {"the same number", [](auto& c) { column(c, "id").values[0] = column(c, "id").values[1]; }, "the same number"},
    {"no mass", [](auto& c) { column(c, "mass").values[3] = 0; }, "a particle has no mass"},
    {"no place", [](auto& c) { column(c, "position").values[0] = NAN; }, "not where its block is"},
    {"another place", [](auto& c) { column(c, "position").values[0] += 0.6; }, "not where its block is"},
    {"drift", [](auto& c) { c.values["drift"] = NAN; }, "its 'drift' is no number from 0 on"},
    {"mass", [](auto& c) { c.values["mass"] = INFINITY; }, "its 'mass' is no number from 0 on"},
    {"speed", [](auto& c) { c.values["speed"] = -1.0; }, "its 'speed' is no number from 0 on"},
    {"another kind", [](auto& c) { c.values["gradient"] = Numbers{}; }, "'gradient' as another kind"},
    {"walls", [](auto& c) { held<Numbers>(c, "momentum").push_back(0); }, "it has other walls"},
    {"ledger", [](auto& c) { held<Numbers>(c, "ledger").pop_back(); }, "its ledger is not whole"},
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_state_that_a_run_has_left_is_taken_with_all_its_bits) {
  for (char const* text : {support::in_the_plane, support::in_space}) {
    CaseUnderWay const good(text);
    auto const whole = good.fresh(), resumed = good.fresh();
    for (int step = 0; step < 3; ++step) whole->advance(1);
    resumed->restore(good.state);
    for (int step = 0; step < 40; ++step) {
      whole->advance(1);
      resumed->advance(1);
    }
    BOOST_TEST((resumed->checkpoint() == whole->checkpoint()));
    BOOST_TEST((resumed->measure() == whole->measure()));
  }
}

BOOST_AUTO_TEST_CASE(what_no_run_has_left_is_refused_by_name) {
  for (Wrong const& row : wrong) {
    BOOST_TEST_CONTEXT(row.name) {
      io::Checkpoint state = plane().state;
      row.edit(state);
      BOOST_CHECK_EXCEPTION(plane().fresh()->restore(state), CheckpointError, says(row.said));
    }
  }
}

BOOST_AUTO_TEST_CASE(particles_that_are_to_be_sorted_anew_may_be_anywhere) {
  io::Checkpoint state = plane().state;
  state.values["drift"] = 0.75;
  column(state, "position").values[0] += 0.6;
  auto const experiment = plane().fresh();
  experiment->restore(state);
  experiment->advance(1);
  BOOST_TEST(experiment->sorts() == 2);
}

BOOST_AUTO_TEST_SUITE_END()
