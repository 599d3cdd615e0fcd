#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "core/config/nearest.hpp"
#include "core/config/outline.hpp"
#include "tests/app/config_sample.hpp"

BOOST_AUTO_TEST_SUITE(config_parameters)

using namespace talus;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Bare {};
struct NamedType {
  static constexpr std::string_view name = "n", title = "t";
  struct Parameters {
    double type = 0;
    static constexpr auto table() { return std::tuple{parameter(&Parameters::type, "type", "t", "1", "a tag")}; }
  };
};
struct Base {
  double a = 1;
  static constexpr auto table() { return std::tuple{parameter(&Base::a, "a", "a", "1", "first")}; }
};
struct Longer : Base {
  double b = 2;
  static constexpr auto table() {
    return std::tuple_cat(Base::table(), std::tuple{parameter(&Longer::b, "b", "b", "1", "second")});
  }
};
struct Twice {
  double a = 1, b = 2;
  static constexpr auto table() {
    return std::tuple{parameter(&Twice::a, "a", "a", "1", "first"), parameter(&Twice::b, "a", "b", "1", "second")};
  }
};
}  // namespace

static_assert(Described<sample::Scene> && Described<Longer> && !Described<Bare> && !Described<double>);
static_assert(Checked<sample::Friction::Parameters> && !Checked<sample::Body>);
static_assert(Policy<sample::Linear> && !Policy<Bare> && !Policy<NamedType>);
static_assert(detail::names_are_distinct<Longer>() && !detail::names_are_distinct<Twice>());

BOOST_AUTO_TEST_CASE(a_range_holds_its_ends_only_where_it_is_closed) {
  BOOST_TEST((!open(-1, 0.5).contains(-1) && !open(-1, 0.5).contains(0.5) && open(-1, 0.5).contains(0)));
  BOOST_TEST((closed(-1, 0.5).contains(-1) && closed(-1, 0.5).contains(0.5) && !closed(-1, 0.5).contains(0.6)));
  BOOST_TEST((!left_open(0, 1).contains(0) && left_open(0, 1).contains(1)));
  BOOST_TEST((right_open(0, 1).contains(0) && !right_open(0, 1).contains(1)));
  BOOST_TEST((!positive.contains(0) && positive.contains(std::numeric_limits<double>::denorm_min())));
  BOOST_TEST((non_negative.contains(0) && non_negative.contains(-0.0) && !non_negative.contains(-1e-300)));
  BOOST_TEST((at_least(3).contains(3) && !at_least(3).contains(2)));
}

BOOST_AUTO_TEST_CASE(no_range_holds_infinity_or_nan) {
  for (Range const& range : {any_number, positive, non_negative, at_least(1), closed(0, 1)}) {
    BOOST_TEST((!range.contains(infinity) && !range.contains(-infinity) && !range.contains(not_a_number)));
  }
}

BOOST_AUTO_TEST_CASE(a_range_reads_as_an_inequality) {
  BOOST_TEST(to_text(open(-1, 0.5)) == "-1 < x < 0.5");
  BOOST_TEST(to_text(left_open(0, 1)) == "0 < x <= 1");
  BOOST_TEST(to_text(positive) == "x > 0");
  BOOST_TEST(to_text(at_least(1)) == "x >= 1");
  BOOST_TEST(to_text(Range{.high = 2}) == "x < 2");
  BOOST_TEST(to_text(any_number) == "any");
}

BOOST_AUTO_TEST_CASE(a_modifier_changes_one_thing_of_a_row) {
  auto const row = parameter(&Base::a, "a", "s", "Pa", "m", positive);
  BOOST_TEST((!row.is_required && row.required().is_required));
  BOOST_TEST((row.required().range.low == 0 && row.required().symbol == "s"));
  auto const tried = row.required().validated(1, 2, "by whom");
  auto const usual = row.usual(1, 2);
  BOOST_TEST((usual.tried.contains(2) && !usual.tried.contains(3) && usual.source.empty()));
  BOOST_TEST((tried.is_required && tried.tried.contains(2) && !tried.tried.contains(3) && tried.source == "by whom"));
  BOOST_TEST((row.sized(2).size.least == 2 && row.sized(2, 5).size.most == 5 && row.per_axis().size.per_axis));
}

BOOST_AUTO_TEST_CASE(a_table_may_continue_that_of_a_base) {
  Longer const values;
  double sum = 0;
  for_each_parameter<Longer>([&](auto const& row) { sum += values.*row.member; });
  BOOST_TEST(sum == 3);
}

BOOST_AUTO_TEST_CASE(integers_are_bounded_by_what_their_type_and_a_double_hold) {
  BOOST_TEST((range_of_type<int>().contains(2147483647.0) && !range_of_type<int>().contains(2147483648.0)));
  BOOST_TEST((range_of_type<std::uint64_t>().contains(0) && !range_of_type<std::uint64_t>().contains(-1)));
  double const two_63 = 9223372036854775808.0;
  BOOST_TEST((!range_of_type<std::int64_t>().contains(two_63) && range_of_type<std::int64_t>().contains(-two_63)));
  BOOST_TEST(range_of_type<std::int64_t>().contains(std::nextafter(two_63, 0)));
  BOOST_TEST(!range_of_type<std::uint64_t>().contains(2 * two_63));
  BOOST_TEST(range_of_type<std::uint64_t>().contains(std::nextafter(2 * two_63, 0)));
}

BOOST_AUTO_TEST_CASE(an_empty_choice_says_so_and_a_made_one_gives_its_policy) {
  Choice<sample::Kernels> choice;
  BOOST_TEST(choice.is_empty());
  BOOST_CHECK_THROW((void)choice.name(), InputError);
  choice = Choice<sample::Kernels>::of<sample::Spline>({.degree = 3});
  BOOST_TEST((choice.holds<sample::Spline>() && !choice.holds<sample::Linear>()));
  BOOST_TEST(choice.name() == "spline");
  int const degree = visit(choice, []<class Q>(std::type_identity<Q>, auto const& parameters) {
    if constexpr (std::same_as<Q, sample::Spline>) return parameters.degree;
    return 1;
  });
  BOOST_TEST(degree == 3);
}

BOOST_AUTO_TEST_CASE(the_edit_distance_counts_changes_additions_gaps_and_swaps) {
  BOOST_TEST(edit_distance("", "abc") == 3U);
  BOOST_TEST(edit_distance("kitten", "sitting") == 3U);  // the classical pair: k-s, e-i, +g
  BOOST_TEST(edit_distance("ab", "ba") == 1U);
  BOOST_TEST(edit_distance("ca", "abc") == 3U);  // restricted form; the unrestricted one gives 2
}

BOOST_AUTO_TEST_CASE(the_nearest_name_is_given_only_if_most_of_it_agrees) {
  BOOST_TEST(nearest("youngs_modulas", {"density", "young_modulus"}).value_or("") == "young_modulus");
  BOOST_TEST(!nearest("temperature", {"density", "young_modulus"}).has_value());
  BOOST_TEST(nearest("mu2", {"mu_1", "mu_2"}).value_or("") == "mu_2");
}

BOOST_AUTO_TEST_SUITE_END()
