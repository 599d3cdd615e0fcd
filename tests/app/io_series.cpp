/// Time series as tables of numbers.

#include <boost/test/unit_test.hpp>
#include <limits>

#include "core/io/files.hpp"
#include "core/io/series.hpp"
#include "tests/support/says.hpp"
#include "tests/support/snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_series)

using namespace talus;
using support::says;
using support::TemporaryFolder;

namespace {
std::vector<io::SeriesColumn> const columns{{"time", "s"}, {"front", "m"}, {"friction", "1"}};
}

BOOST_AUTO_TEST_CASE(the_header_names_quantities_and_units) {
  TemporaryFolder const folder;
  io::SeriesWriter(folder / "s.csv", columns).append(std::vector<double>{0, 0.1, -2e-300});
  BOOST_TEST(io::read_file(folder / "s.csv") == "time [s],front [m],friction [1]\n0,0.1,-2e-300\n");
}

BOOST_AUTO_TEST_CASE(numbers_come_back_bit_for_bit) {
  TemporaryFolder const folder;
  using Limits = std::numeric_limits<double>;
  std::vector<std::vector<double>> const rows{{0.1 + 0.2, 1.0 / 3, -0.0},
                                              {Limits::max(), Limits::denorm_min(), Limits::min()},
                                              {Limits::infinity(), -Limits::infinity(), 1e22}};
  io::SeriesWriter writer(folder / "s.csv", columns);
  for (auto const& row : rows) writer.append(row);
  BOOST_TEST(writer.rows() == 3);
  auto const series = io::read_series(folder / "s.csv");
  BOOST_TEST((series.columns == columns));
  for (std::size_t c = 0; c < 3; ++c)
    BOOST_TEST(support::same_bits(series.values[c], {rows[0][c], rows[1][c], rows[2][c]}));
  BOOST_TEST(series.find("front") == &series.values[1]);
  BOOST_TEST(series.find("fronts") == nullptr);
}

BOOST_AUTO_TEST_CASE(what_is_no_number_is_written_as_nan_and_read_as_such) {
  TemporaryFolder const folder;
  io::SeriesWriter(folder / "s.csv", columns)
      .append(std::vector<double>{1, std::numeric_limits<double>::quiet_NaN(), 2});
  auto const series = io::read_series(folder / "s.csv");
  BOOST_TEST(std::isnan(series.values[1][0]));
  BOOST_TEST(series.values[2][0] == 2);
}

BOOST_AUTO_TEST_CASE(a_resumed_series_equals_the_undisturbed_one) {
  TemporaryFolder const folder;
  auto const row = [](int k) { return std::vector<double>{0.1 * k, k / 3.0, 1e-9 * k}; };
  {
    io::SeriesWriter whole(folder / "whole.csv", columns);
    for (int k = 0; k < 9; ++k) whole.append(row(k));
    io::SeriesWriter killed(folder / "killed.csv", columns);
    for (int k = 0; k < 7; ++k) killed.append(row(k));
  }
  io::GrowingFile(folder / "killed.csv").append("0.7,0.2333");  // a row that a kill cut
  io::SeriesWriter resumed(folder / "killed.csv", columns, 5);
  BOOST_TEST(resumed.rows() == 5);
  for (int k = 5; k < 9; ++k) resumed.append(row(k));
  resumed.sync();
  BOOST_TEST(io::read_file(folder / "killed.csv") == io::read_file(folder / "whole.csv"));
}

BOOST_AUTO_TEST_CASE(a_series_that_the_checkpoint_does_not_know_is_not_resumed) {
  TemporaryFolder const folder;
  io::SeriesWriter(folder / "s.csv", columns).append(std::vector<double>{1, 2, 3});
  auto const before = io::read_file(folder / "s.csv");
  BOOST_CHECK_EXCEPTION(io::SeriesWriter(folder / "s.csv", columns, 2), CheckpointError,
                        says("has 1 rows, the checkpoint counts 2"));
  BOOST_CHECK_EXCEPTION(io::SeriesWriter(folder / "s.csv", {{"time", "s"}}, 1), CheckpointError, says("other columns"));
  BOOST_CHECK_THROW(io::SeriesWriter(folder / "missing.csv", columns, 0), FileError);
  BOOST_TEST(io::read_file(folder / "s.csv") == before);
}

BOOST_AUTO_TEST_CASE(a_new_series_takes_the_place_of_an_old_one) {
  TemporaryFolder const folder;
  io::SeriesWriter(folder / "s.csv", columns).append(std::vector<double>{1, 2, 3});
  io::SeriesWriter const again(folder / "s.csv", columns);
  BOOST_TEST(io::read_series(folder / "s.csv").values[0].empty());
}

BOOST_AUTO_TEST_CASE(a_row_that_is_cut_at_the_end_is_left_out) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "s.csv", "time [s],front [m]\n1,2\n3,4\n5");
  BOOST_TEST((io::read_series(folder / "s.csv").values == std::vector<std::vector<double>>{{1, 3}, {2, 4}}));
}

BOOST_AUTO_TEST_CASE(a_line_that_is_no_row_is_named) {
  TemporaryFolder const folder;
  for (std::string const bad : {"1", "1,2,3", "1,two", "1,", "", "1,2 ", "1;2"}) {
    BOOST_TEST_CONTEXT("'" << bad << "'") {
      io::write_atomically(folder / "s.csv", "time [s],front [m]\n1,2\n" + bad + "\n3,4\n");
      BOOST_CHECK_EXCEPTION(static_cast<void>(io::read_series(folder / "s.csv")), FileError, says("line 3"));
    }
  }
  io::write_atomically(folder / "s.csv", "time [s],front\n1,2\n");
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::read_series(folder / "s.csv")), FileError, says("'front'"));
}

BOOST_AUTO_TEST_CASE(a_row_of_another_length_is_a_mistake_of_the_program) {
  TemporaryFolder const folder;
  io::SeriesWriter writer(folder / "s.csv", columns);
  BOOST_CHECK_THROW(writer.append(std::vector<double>{1, 2}), std::logic_error);
  BOOST_TEST(writer.rows() == 0);
}

BOOST_AUTO_TEST_SUITE_END()
