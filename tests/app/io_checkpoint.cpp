/// Checkpoints: the same bits back, or an error that says why not.

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <thread>

#include "core/io/checkpoint.hpp"
#include "core/io/files.hpp"
#include "tests/support/forged.hpp"
#include "tests/support/says.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

BOOST_AUTO_TEST_SUITE(io_checkpoint)

using namespace talus;
namespace fs = std::filesystem;
using support::says;
using support::SmallDisk;
using support::TemporaryFolder;
using support::with_header;

namespace {

io::Checkpoint awkward_checkpoint() {
  return {support::awkward_snapshot(),
          {{"drift", -0.0},
           {"rows", std::int64_t{-9007199254740993}},
           {"case", std::string(70000, 'x') + "\n{\"title\": \"Böschung\"}"},
           {"nothing", std::string()},
           {"blocks", std::vector<std::int64_t>{3, -1, 1LL << 62}},
           {"frame_times", std::vector<double>{0.1, std::numeric_limits<double>::infinity(), -0.0}},
           {"frame_files", std::vector<std::string>{"", "frames/f_000000.vtu", "b"}},
           {"no_integers", std::vector<std::int64_t>{}},
           {"no_numbers", std::vector<double>{}},
           {"no_texts", std::vector<std::string>{}}}};
}

io::Checkpoint at_step(std::int64_t step) {
  io::Checkpoint checkpoint{support::collapsing_heap(2, 4, 0.1), {}};
  checkpoint.particles.step = step;
  return checkpoint;
}

/// What is written to standard error while it lives.
class ErrorOutput {
 public:
  explicit ErrorOutput(fs::path const& file) : file_(file), before_(dup(2)) {
    int const other = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(other, 2);
    close(other);
  }
  ErrorOutput(ErrorOutput const&) = delete;
  ErrorOutput& operator=(ErrorOutput const&) = delete;
  ~ErrorOutput() {
    dup2(before_, 2);
    close(before_);
  }
  [[nodiscard]] std::string text() const { return io::read_file(file_); }

 private:
  fs::path file_;
  int before_;
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_checkpoint_comes_back_bit_for_bit) {
  TemporaryFolder const folder;
  auto const written = awkward_checkpoint();
  auto const path = io::write_checkpoint(folder.path(), written, 2);
  auto const read = io::read_checkpoint(path);
  BOOST_TEST(support::same_bits(read.particles, written.particles));
  BOOST_TEST((read.values == written.values));
  BOOST_TEST(std::signbit(read.value<double>("drift")));
  BOOST_TEST(std::signbit(read.value<std::vector<double>>("frame_times").back()));
}

BOOST_AUTO_TEST_CASE(many_particles_come_back_in_their_order) {
  io::Checkpoint const written{support::collapsing_heap(3, 120, 0.4), {}};  // more than one chunk of each field
  BOOST_REQUIRE(written.particles.particles() == 216000u);
  auto const bytes = io::checkpoint_bytes(written);
  BOOST_TEST(support::same_bits(io::checkpoint_from(bytes, "").particles, written.particles));
  BOOST_TEST(bytes.size() < 216000 * 7 * sizeof(double));  // packed: less than the numbers themselves
}

BOOST_AUTO_TEST_CASE(a_checkpoint_may_hold_no_particle_and_no_value) {
  io::Checkpoint empty{support::awkward_snapshot(), {}};
  for (auto& column : empty.particles.columns) column.values.clear();
  BOOST_TEST(support::same_bits(io::checkpoint_from(io::checkpoint_bytes(empty), "").particles, empty.particles));
}

BOOST_AUTO_TEST_CASE(the_same_state_gives_the_same_bytes_at_any_time) {
  auto const first = io::checkpoint_bytes(awkward_checkpoint());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's time stamps count seconds
  BOOST_TEST((io::checkpoint_bytes(awkward_checkpoint()) == first));
}

BOOST_AUTO_TEST_CASE(any_program_for_hdf5_can_read_it) {
  TemporaryFolder const folder;
  auto const path = io::write_checkpoint(folder.path(), awkward_checkpoint(), 1);
  hid_t const file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  BOOST_REQUIRE(file >= 0);
  hid_t const data = H5Dopen2(file, "particles/velocity", H5P_DEFAULT);
  double values[4] = {};
  H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
  BOOST_TEST(values[1] == -2.0);
  hid_t const unit = H5Aopen(data, "unit", H5P_DEFAULT), type = H5Aget_type(unit);
  char text[4] = {};
  BOOST_TEST(H5Tget_size(type) == 3u);
  H5Aread(unit, type, text);
  BOOST_TEST(std::string(text) == "m/s");
  hid_t const properties = H5Dget_create_plist(data);
  BOOST_TEST(H5Pget_nfilters(properties) == 3);
  unsigned flags = 0;
  BOOST_TEST(H5Pget_filter_by_id2(properties, H5Z_FILTER_FLETCHER32, &flags, nullptr, nullptr, 0, nullptr, nullptr) >=
             0);
  H5Pclose(properties);
  H5Tclose(type);
  H5Aclose(unit);
  H5Dclose(data);
  H5Fclose(file);
}

BOOST_AUTO_TEST_CASE(one_changed_byte_anywhere_is_found) {
  auto const bytes = io::checkpoint_bytes(awkward_checkpoint());
  for (std::size_t at = 0; at < bytes.size(); at += at < 512 ? 1 : 97) {
    BOOST_TEST_CONTEXT("byte " << at) {
      auto damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
      BOOST_CHECK_THROW(static_cast<void>(io::checkpoint_from(damaged, "")), CheckpointError);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_checkpoint_cut_anywhere_is_refused) {
  auto const bytes = io::checkpoint_bytes(awkward_checkpoint());
  for (std::size_t kept = 0; kept < bytes.size(); kept += kept < 600 ? 1 : 997) {
    BOOST_TEST_CONTEXT(kept << " bytes") {
      BOOST_CHECK_THROW(static_cast<void>(io::checkpoint_from(std::string_view(bytes).substr(0, kept), "")),
                        CheckpointError);
    }
  }
  BOOST_CHECK_THROW(static_cast<void>(io::checkpoint_from(bytes + "x", "")), CheckpointError);
}

BOOST_AUTO_TEST_CASE(the_error_says_what_is_wrong_and_with_which_file) {
  auto const bytes = io::checkpoint_bytes(awkward_checkpoint());
  auto const refused = [](std::string const& what, std::string const& why) {
    BOOST_CHECK_EXCEPTION(static_cast<void>(io::checkpoint_from(what, "run/ck.h5")), CheckpointError,
                          says("run/ck.h5 cannot be used: " + why));
  };
  refused("", "it is empty");
  refused("nonsense", "it is not a checkpoint of Talus");
  refused("\x89HDF\r\n\x1a\n and more", "it is an HDF5 file, but not a checkpoint of Talus");
  refused(bytes.substr(0, 100), "it is cut short after 100 bytes");
  refused(bytes.substr(0, 5000), "it is cut short: 5000 of " + std::to_string(bytes.size()) + " bytes are left");
  auto other = bytes;
  other[25] = '1';
  refused(other, "it has format 1, this program reads format 4");
  other = bytes;
  other[9000] = static_cast<char>(other[9000] ^ 1);
  refused(other, "it is damaged: its contents do not agree with its checksum");
  TemporaryFolder const folder;
  BOOST_CHECK_THROW(static_cast<void>(io::read_checkpoint(folder / "missing")), FileError);
}

BOOST_AUTO_TEST_CASE(contents_that_are_not_ours_are_refused_and_hdf5_keeps_quiet) {
  TemporaryFolder const folder;
  ErrorOutput const output(folder / "stderr");
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::checkpoint_from(with_header("nonsense"), "")), CheckpointError,
                        says("it is no HDF5 file"));
  auto const file = H5Fcreate((folder / "other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(file);
  auto const other = with_header(io::read_file(folder / "other.h5"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(io::checkpoint_from(other, "")), CheckpointError,
                        says("it has no attribute 'time'"));
  BOOST_TEST(output.text().empty());
}

BOOST_AUTO_TEST_CASE(a_missing_value_and_one_of_another_kind_are_named) {
  auto const checkpoint = awkward_checkpoint();
  BOOST_CHECK_EXCEPTION(static_cast<void>(checkpoint.value<double>("drifts")), CheckpointError, says("'drifts'"));
  BOOST_CHECK_EXCEPTION(static_cast<void>(checkpoint.value<std::int64_t>("drift")), CheckpointError,
                        says("'drift' as another kind"));
}

BOOST_AUTO_TEST_CASE(the_newest_are_kept_and_later_ones_spared) {
  TemporaryFolder const folder;
  io::write_atomically(folder / "ck_notes.txt", "not ours");
  for (std::int64_t step : {0, 900, 1000, 20000}) io::write_checkpoint(folder.path(), at_step(step), 2);
  auto names = [&] {
    std::vector<std::string> found;
    for (auto const& path : io::checkpoints_in(folder.path())) found.push_back(path.filename().string());
    return found;
  };
  BOOST_TEST((names() == std::vector<std::string>{"ck_000000001000.h5", "ck_000000020000.h5"}));
  io::write_checkpoint(folder.path(), at_step(1100), 2);
  io::write_checkpoint(folder.path(), at_step(1200), 2);
  BOOST_TEST((names() == std::vector<std::string>{"ck_000000001100.h5", "ck_000000001200.h5", "ck_000000020000.h5"}));
  io::write_checkpoint(folder.path(), at_step(20000), 0);
  BOOST_TEST((names() == std::vector<std::string>{"ck_000000020000.h5"}));
  BOOST_TEST(io::read_file(folder / "ck_notes.txt") == "not ours");
  BOOST_CHECK_THROW(static_cast<void>(io::checkpoints_in(folder / "missing")), FileError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_leaves_the_last_good_checkpoint) {
  TemporaryFolder const folder;
  auto const good = io::write_checkpoint(folder.path(), at_step(1), 1);
  {
    SmallDisk const disk(4096);
    BOOST_CHECK_THROW(io::write_checkpoint(folder.path(), at_step(2), 1), FileError);
  }
  BOOST_TEST((io::checkpoints_in(folder.path()) == std::vector<fs::path>{good}));
  BOOST_TEST(io::read_checkpoint(good).particles.step == 1);
  BOOST_TEST(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator{}) == 1);
}

BOOST_AUTO_TEST_SUITE_END()
