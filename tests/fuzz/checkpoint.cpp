/// Hostile checkpoints, in three ways that the input chooses among:
///
///   0  the bytes are the file
///   1  bytes of a good file are replaced, or it is cut: it must be refused
///   2  the file is whole, but its contents are not what a run would write: they are refused, or the run goes on
///
/// Whatever the bytes are: CheckpointError, or a state that runs two steps, on which RunError is allowed. Bytes of the
/// HDF5 file replaced under a true checksum are left out: no accident brings them about, and HDF5 1.10 itself does not
/// stand them (docs/conventions.md, "Stopping and going on").

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdio>
#include <cstdlib>

#include "tests/support/small_case.hpp"

namespace {

using namespace talus;
using Bytes = FuzzedDataProvider;

struct Good : support::CaseUnderWay {
  using CaseUnderWay::CaseUnderWay;
  std::string file = io::checkpoint_bytes(state);
};

Good const& chosen(Bytes& bytes) {
  static Good const plane(support::in_the_plane), space(support::in_space);
  return bytes.ConsumeBool() ? plane : space;
}

/// Replaces bytes of a file, and may cut it.
std::string damaged(std::string file, Bytes& bytes) {
  if (bytes.ConsumeBool()) file.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, file.size()));
  while (!file.empty() && bytes.remaining_bytes() > 0) {
    auto const at = bytes.ConsumeIntegralInRange<std::size_t>(0, file.size() - 1);
    file[at] = bytes.ConsumeIntegral<char>();
  }
  return file;
}

double number(Bytes& bytes) {
  constexpr double awkward[] = {0.0, -0.0, -1.0, 0.5, 1e-300, 1e16, 1e300, INFINITY, -INFINITY, NAN};
  return bytes.ConsumeBool() ? bytes.PickValueInArray(awkward) : bytes.ConsumeFloatingPointInRange(-1e3, 1e3);
}

void change(double& value, Bytes& bytes) {
  value = number(bytes);
}
void change(std::int64_t& value, Bytes& bytes) {
  auto const step = static_cast<std::uint64_t>(bytes.ConsumeIntegral<std::int8_t>());  // wraps around, which is defined
  value = bytes.ConsumeBool() ? static_cast<std::int64_t>(static_cast<std::uint64_t>(value) + step)
                              : bytes.ConsumeIntegral<std::int64_t>();
}
void change(std::string& value, Bytes& bytes) {
  value = bytes.ConsumeRandomLengthString(40);
}
template <class T>
void change(std::vector<T>& values, Bytes& bytes) {
  if (bytes.ConsumeIntegralInRange(0, 3) == 0) values.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, 70));
  if (values.empty()) return;
  change(values[bytes.ConsumeIntegralInRange<std::size_t>(0, values.size() - 1)], bytes);
}

void change(io::Checkpoint& state, Bytes& bytes) {
  auto& particles = state.particles;
  auto const column = [&]() -> NamedColumn& {
    return particles.columns[bytes.ConsumeIntegralInRange<std::size_t>(0, particles.columns.size() - 1)];
  };
  auto const value = [&] {
    return std::next(state.values.begin(),
                     bytes.ConsumeIntegralInRange<std::ptrdiff_t>(0, std::ssize(state.values) - 1));
  };
  switch (bytes.ConsumeIntegralInRange(0, 7)) {
    case 0:
      return change(particles.time, bytes);
    case 1:
      return change(particles.step, bytes);
    case 2:
      particles.dimension = bytes.ConsumeIntegral<int>();
      return;
    case 3:
      column().components = bytes.ConsumeIntegralInRange(-1, 9);
      return;
    case 4:
      if (!state.values.empty()) state.values.erase(value());
      return;
    case 5:
      if (!state.values.empty()) value()->second = number(bytes);
      return;
    case 6:
      if (!state.values.empty()) std::visit([&](auto& held) { change(held, bytes); }, value()->second);
      return;
    default:
      change(column().values, bytes);
  }
}

/// Goes on from a state that need not be one.
void run(Good const& good, io::Checkpoint const& state) {
  auto const experiment = good.fresh();
  experiment->restore(state);
  try {
    for (int step = 0; step < 2 && experiment->time() < 1; ++step) experiment->advance(1);
  } catch (RunError const&) {
    return;
  }
  static_cast<void>(experiment->measure());
  static_cast<void>(experiment->profiles());
  static_cast<void>(experiment->frame());
  static_cast<void>(io::checkpoint_bytes(experiment->checkpoint()));
}

void try_one(Bytes& bytes) {
  int const way = bytes.ConsumeIntegralInRange(0, 2);
  Good const& good = chosen(bytes);
  if (way == 0) {
    static_cast<void>(io::checkpoint_from(bytes.ConsumeRemainingBytesAsString(), "fuzzed"));
  } else if (way == 1) {
    std::string const file = damaged(good.file, bytes);
    bool const same = file == good.file;
    static_cast<void>(io::checkpoint_from(file, "fuzzed"));
    if (same) return;
    std::fputs("a damaged checkpoint was taken for a good one\n", stderr);
    std::abort();
  } else {
    io::Checkpoint state = good.state;
    for (int edits = 0; edits < 6 && bytes.remaining_bytes() > 0; ++edits) change(state, bytes);
    run(good, state);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  Bytes bytes(data, size);
  try {
    try_one(bytes);
  } catch (CheckpointError const&) {  // as it should be
  }
  return 0;
}
