/// SHA-256 of bytes and of states.

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <numeric>

#include "core/io/hash.hpp"
#include "tests/support/snapshots.hpp"

BOOST_AUTO_TEST_SUITE(io_hash)

using namespace talus;
using support::awkward_snapshot;

namespace {

Snapshot with_order(Snapshot snapshot, std::vector<std::size_t> const& order) {
  for (auto& column : snapshot.columns) {
    auto const width = static_cast<std::size_t>(column.components);
    auto const before = column.values;
    for (std::size_t k = 0; k < order.size(); ++k)
      std::copy_n(&before[order[k] * width], width, &column.values[k * width]);
  }
  return snapshot;
}

template <class T>
std::string bits(T value) {
  return {reinterpret_cast<char const*>(&value), sizeof value};
}

}  // namespace

/// FIPS 180-2 appendix B gives the digests of "abc" and of a million "a"; that of nothing is NIST's (CAVP,
/// SHA256ShortMsg).
BOOST_AUTO_TEST_CASE(published_examples_of_sha_256_come_out) {
  BOOST_TEST(io::sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  BOOST_TEST(io::sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  BOOST_TEST(io::sha256(std::string(1000000, 'a')) ==
             "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

BOOST_AUTO_TEST_CASE(bytes_may_come_in_parts) {
  io::Sha256 hash;
  hash.add("a");
  hash.add("");
  hash.add("bc", 2);
  BOOST_TEST(hash.digest() == io::sha256("abc"));
}

BOOST_AUTO_TEST_CASE(a_state_is_hashed_over_what_the_header_says) {
  Snapshot const one{0.5, 4, 2, {{"position", "", "", "", 2, {1, 2}}, {"id", "", "", "", 1, {9}}}};
  auto const text = bits(0.5) + bits(std::int64_t{4}) + bits(std::int64_t{2}) + bits(std::int64_t{1}) +
                    std::string("id\0", 3) + bits(std::int64_t{1}) + bits(9.0) + std::string("position\0", 9) +
                    bits(std::int64_t{2}) + bits(1.0) + bits(2.0);
  BOOST_TEST(io::state_hash(one) == io::sha256(text));
}

BOOST_AUTO_TEST_CASE(the_order_of_particles_and_columns_does_not_matter) {
  auto const heap = support::collapsing_heap(2, 12, 0.3);
  std::vector<std::size_t> order(heap.particles());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const expected = io::state_hash(heap);
  for (std::size_t turn : {1u, 7u, 71u}) {
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(turn), order.end());
    std::swap(order[0], order[turn]);
    auto shuffled = with_order(heap, order);
    std::ranges::reverse(shuffled.columns);
    BOOST_TEST(io::state_hash(shuffled) == expected);
  }
}

BOOST_AUTO_TEST_CASE(one_bit_anywhere_makes_another_hash) {
  auto const original = awkward_snapshot();
  auto const expected = io::state_hash(original);
  BOOST_TEST(io::state_hash(awkward_snapshot()) == expected);  // NaN too
  for (std::size_t c = 0; c < original.columns.size(); ++c)
    for (std::size_t k = 0; k < original.columns[c].values.size(); ++k) {
      BOOST_TEST_CONTEXT(original.columns[c].name << " " << k) {
        auto changed = original;
        auto& value = changed.columns[c].values[k];
        std::uint64_t raw = 0;
        __builtin_memcpy(&raw, &value, sizeof raw);
        raw ^= 1;
        __builtin_memcpy(&value, &raw, sizeof raw);
        BOOST_TEST(io::state_hash(changed) != expected);
      }
    }
  auto changed = original;
  changed.time = std::nextafter(changed.time, 1);
  BOOST_TEST(io::state_hash(changed) != expected);
  changed = original;
  ++changed.step;
  BOOST_TEST(io::state_hash(changed) != expected);
  changed = original;
  changed.columns[0].values[0] = 0.0;  // was -0
  BOOST_TEST(io::state_hash(changed) != expected);
}

BOOST_AUTO_TEST_CASE(a_state_without_ids_or_with_the_same_id_twice_is_refused) {
  auto snapshot = awkward_snapshot();
  snapshot.columns.back().values = {3, 3};
  BOOST_CHECK_THROW(static_cast<void>(io::state_hash(snapshot)), std::logic_error);
  snapshot.columns.pop_back();
  BOOST_CHECK_THROW(static_cast<void>(io::state_hash(snapshot)), std::logic_error);
}

BOOST_AUTO_TEST_CASE(columns_of_different_lengths_are_refused) {
  auto snapshot = awkward_snapshot();
  snapshot.columns[1].values.resize(2);
  BOOST_CHECK_THROW(static_cast<void>(snapshot.particles()), std::logic_error);
  snapshot.columns[1].values.resize(3);
  BOOST_CHECK_THROW(static_cast<void>(snapshot.particles()), std::logic_error);
}

BOOST_AUTO_TEST_SUITE_END()
