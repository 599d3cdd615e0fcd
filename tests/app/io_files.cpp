/// Files that a kill or a full disk cannot leave half written.

#include <boost/test/unit_test.hpp>
#include <fstream>

#include "core/io/files.hpp"
#include "tests/support/says.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_files)

using namespace talus;
namespace fs = std::filesystem;
using support::says;
using support::SmallDisk;
using support::TemporaryFolder;

namespace {

std::size_t entries_of(fs::path const& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_written_is_what_is_read) {
  TemporaryFolder const folder;
  std::string bytes("\0\n\r\xff text", 9);
  io::write_atomically(folder / "a", bytes);
  BOOST_TEST(io::read_file(folder / "a") == bytes);
  std::string const long_text(1 << 20, 'x');
  io::write_atomically(folder / "a", long_text);
  BOOST_TEST((io::read_file(folder / "a") == long_text));
  io::write_atomically(folder / "a", "");
  BOOST_TEST(io::read_file(folder / "a").empty());
  BOOST_TEST(entries_of(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_file_that_is_not_committed_does_not_touch_the_old_one) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "a", "old");
  {
    io::PendingFile file(folder / "a");
    file.write("half of the n");
    BOOST_TEST(io::read_file(folder / "a") == "old");
  }
  BOOST_TEST(io::read_file(folder / "a") == "old");
  BOOST_TEST(entries_of(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(what_a_kill_left_of_an_earlier_attempt_is_overwritten) {
  TemporaryFolder const folder;
  std::ofstream(folder / "a.tmp") << "a long rest of an earlier attempt";
  io::write_atomically(folder / "a", "new");
  BOOST_TEST(io::read_file(folder / "a") == "new");
  BOOST_TEST(entries_of(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_a_file_error_that_leaves_the_old_file_and_no_rest) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "a", "old");
  SmallDisk const disk(4096);
  BOOST_CHECK_EXCEPTION(io::write_atomically(folder / "a", std::string(100000, 'x')), FileError, says("a.tmp: "));
  BOOST_TEST(io::read_file(folder / "a") == "old");
  BOOST_TEST(entries_of(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(no_space_left_is_said_in_words) {
  if (!fs::exists("/dev/full")) return;  // not on this system
  io::GrowingFile file("/dev/full");
  BOOST_CHECK_EXCEPTION(file.append("x"), FileError, says("cannot write /dev/full: No space left on device"));
}

BOOST_AUTO_TEST_CASE(errors_name_the_file_and_the_reason) {
  TemporaryFolder const folder;
  auto const missing = folder / "missing";
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::read_file(missing)), FileError,
                        says(missing.string() + ": No such file"));
  BOOST_CHECK_EXCEPTION(io::write_atomically(missing / "a", "x"), FileError, says("No such file or directory"));
  fs::create_directory(folder / "folder");
  BOOST_CHECK_EXCEPTION(io::write_atomically(folder / "folder", "x"), FileError, says("Is a directory"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::read_file(folder / "folder")), FileError, says("Is a directory"));
  BOOST_TEST(entries_of(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(a_growing_file_goes_on_at_its_end_or_behind_what_is_kept) {
  TemporaryFolder const folder;
  auto const path = folder / "rows";
  io::GrowingFile(path).append("one\n");
  {
    io::GrowingFile file(path);
    file.append("two\n");
    file.append("three\n");
    file.sync();
  }
  BOOST_TEST(io::read_file(path) == "one\ntwo\nthree\n");
  io::GrowingFile(path, 8).append("drei\n");
  BOOST_TEST(io::read_file(path) == "one\ntwo\ndrei\n");
  io::GrowingFile const emptied(path, 0);
  BOOST_TEST(io::read_file(path).empty());
}

BOOST_AUTO_TEST_CASE(a_growing_file_does_not_invent_bytes_that_are_missing) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "rows", "one\n");
  BOOST_CHECK_EXCEPTION(io::GrowingFile(folder / "rows", 5), FileError, says("holds 4 bytes"));
  BOOST_TEST(io::read_file(folder / "rows") == "one\n");
}

BOOST_AUTO_TEST_CASE(a_folder_for_results_is_made_but_earlier_results_are_kept) {
  TemporaryFolder const folder;
  auto const path = folder / "a/b";
  io::make_folder(path, "results.json");
  io::make_folder(path, "results.json");  // it is empty
  io::write_atomically(path / "results.json", "{}");
  BOOST_CHECK_THROW(io::make_folder(path, "results.json"), FileError);
  BOOST_CHECK_NO_THROW(io::make_folder(path, ""));
  BOOST_CHECK_THROW(io::make_folder(path / "results.json/c", ""), FileError);
}

BOOST_AUTO_TEST_SUITE_END()
