/// Frames for ParaView, written and read back. (VTK's own reader judges them in tests/io/read_with_vtk.py.)

#include <boost/test/unit_test.hpp>
#include <cstring>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"
#include "tests/support/snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_vtu)

using namespace talus;
using support::TemporaryFolder;

BOOST_AUTO_TEST_CASE(a_frame_comes_back_bit_for_bit) {
  TemporaryFolder const folder;
  auto const snapshot = support::awkward_snapshot();
  io::write_vtu(folder / "f.vtu", snapshot);
  BOOST_TEST(support::same_bits(io::read_vtu(folder / "f.vtu"), snapshot));
  auto const heap = support::collapsing_heap(3, 16, 0.5);
  io::write_vtu(folder / "g.vtu", heap);
  BOOST_TEST(support::same_bits(io::read_vtu(folder / "g.vtu"), heap));
}

BOOST_AUTO_TEST_CASE(a_frame_may_hold_no_particle) {
  TemporaryFolder const folder;
  auto empty = support::awkward_snapshot();
  for (auto& column : empty.columns) column.values.clear();
  io::write_vtu(folder / "f.vtu", empty);
  BOOST_TEST(support::same_bits(io::read_vtu(folder / "f.vtu"), empty));
}

/// The offsets of a file with one particle, counted by hand: each block has 8 bytes of length before it.
BOOST_AUTO_TEST_CASE(blocks_lie_where_the_format_says) {
  TemporaryFolder const folder;
  Snapshot const one{2.5, 7, 2, {{"position", "x_p", "m", "position", 2, {3, 4}}, {"id", "id", "1", "number", 1, {9}}}};
  io::write_vtu(folder / "f.vtu", one);
  auto const file = io::read_file(folder / "f.vtu");
  auto const blocks = std::string_view(file).substr(file.find("\n_") + 2);
  auto const number_at = [&](std::size_t offset) {
    double value = 0;
    std::memcpy(&value, blocks.data() + offset, sizeof value);
    return value;
  };
  auto const length_at = [&](std::size_t offset) {
    std::uint64_t value = 0;
    std::memcpy(&value, blocks.data() + offset, sizeof value);
    return value;
  };
  BOOST_TEST(length_at(0) == 8u);  // time
  BOOST_TEST(number_at(8) == 2.5);
  BOOST_TEST(length_at(48) == 24u);  // behind step (at 16) and dimension (at 32): the position, padded to three
  BOOST_TEST(number_at(56) == 3.0);
  BOOST_TEST(number_at(64) == 4.0);
  BOOST_TEST(number_at(72) == 0.0);
  BOOST_TEST(length_at(80) == 4u);   // connectivity
  BOOST_TEST(length_at(92) == 4u);   // offsets
  BOOST_TEST(length_at(104) == 1u);  // types
  BOOST_TEST(int{blocks[112]} == 1);
  BOOST_TEST(length_at(113) == 8u);  // id
  BOOST_TEST(number_at(121) == 9.0);
  BOOST_TEST(blocks.substr(129) == "\n</AppendedData>\n</VTKFile>\n");
  BOOST_TEST(file.find(R"(Name="id" NumberOfComponents="1" components="1" symbol="id" unit="1")") != file.npos);
  BOOST_TEST(file.find(R"(offset="113")") != file.npos);
}

BOOST_AUTO_TEST_CASE(a_frame_cut_anywhere_is_refused) {
  TemporaryFolder const folder;
  io::write_vtu(folder / "f.vtu", support::awkward_snapshot());
  auto const file = io::read_file(folder / "f.vtu");
  auto const behind_the_blocks = file.rfind("\n</AppendedData>");
  for (std::size_t kept = 0; kept < behind_the_blocks; kept += 7) {
    BOOST_TEST_CONTEXT(kept << " bytes") {
      io::write_atomically(folder / "cut.vtu", std::string_view(file).substr(0, kept));
      BOOST_CHECK_THROW(static_cast<void>(io::read_vtu(folder / "cut.vtu")), FileError);
    }
  }
}

BOOST_AUTO_TEST_CASE(foreign_and_inconsistent_files_are_refused) {
  TemporaryFolder const folder;
  auto const refused = [&](std::string const& bytes) {
    io::write_atomically(folder / "f.vtu", bytes);
    BOOST_CHECK_THROW(static_cast<void>(io::read_vtu(folder / "f.vtu")), FileError);
  };
  io::write_vtu(folder / "f.vtu", support::awkward_snapshot());
  auto const file = io::read_file(folder / "f.vtu");
  auto const changed = [&](std::string const& from, std::string const& to) {
    auto copy = file;
    auto const at = copy.find(from);
    BOOST_REQUIRE(at != copy.npos);
    return copy.replace(at, from.size(), to);
  };
  refused("something else");
  refused(changed(R"(NumberOfPoints="2")", R"(NumberOfPoints="3")"));
  refused(changed(R"(NumberOfPoints="2")", R"(NumberOfPoints="18446744073709551615")"));
  refused(changed(R"(NumberOfPoints="2")", R"(NumberOfPoints="-2")"));
  refused(changed(R"(components="2")", R"(components="9")"));
  refused(changed(R"(offset="0")", R"(offset="18446744073709551615")"));
  refused(changed(R"(Name="position")", R"(Name="posit")"));
}

BOOST_AUTO_TEST_CASE(the_list_of_frames_comes_back_and_is_replaced_as_a_whole) {
  TemporaryFolder const folder;
  std::vector<io::Frame> frames{{0, "frames/f_000000.vtu"}, {0.1 + 0.2, "frames/a & \"b\".vtu"}, {1e-300, "c"}};
  io::write_frame_list(folder / "frames.pvd", frames);
  BOOST_TEST((io::read_frame_list(folder / "frames.pvd") == frames));
  frames.resize(1);
  io::write_frame_list(folder / "frames.pvd", frames);
  BOOST_TEST((io::read_frame_list(folder / "frames.pvd") == frames));
  io::write_frame_list(folder / "frames.pvd", {});
  BOOST_TEST(io::read_frame_list(folder / "frames.pvd").empty());
}

BOOST_AUTO_TEST_SUITE_END()
