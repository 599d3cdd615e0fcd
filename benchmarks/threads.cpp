/// Several threads against one.

#include <fmt/format.h>

#include <set>

#include "benchmarks/registry.hpp"
#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "core/experiment_of.hpp"
#include "core/io/hash.hpp"

namespace talus::bench {

namespace {

template <Formulation F>
auto scene(std::size_t particles) {
  constexpr int D = F::Kinematics::dimension;
  Filling filling;
  filling.particles = particles;
  filling.a_cell = D == 2 ? 6 : 8;
  auto const cloud = block<D>(filling);
  return simulate<F>(setup<F>(cloud.spacing), {cloud}, corner<D>(cloud.low));
}

template <int D>
void speed_up(Options const& options, Table& table) {
  using F = Of<D, kernel::Quadratic>;
  std::string const name = fmt::format("{}-D quadratic, {} threads over 1", D, options.threads);
  say("threads: " + name);
  set_thread_count(1);
  auto one = scene<F>(options.particles_or(200'000)), several = scene<F>(options.particles_or(200'000));
  auto const times = take_turns(
      {competitor("one", *one, Clock::wall, 1), competitor("several", *several, Clock::wall, options.threads)},
      {.count = options.repeats_or(25), .slice = 0.08, .clock = Clock::wall});
  double const particles = static_cast<double>(one->particles().count());
  std::optional<Bar> const bar =
      options.threads == 2 ? std::optional(Bar{.least = 1.8, .stretch = 1.95}) : std::nullopt;
  table.rows.push_back({name,
                        "×",
                        ratio(times[0], times[1]),
                        bar,
                        {fmt::format("{:.1f}", 1e9 * estimate(times[0]).median / particles),
                         fmt::format("{:.1f}", 1e9 * estimate(times[1]).median / particles)}});
  set_thread_count(1);
}

/// SHA-256 of the state after some steps, one sort at least among them.
template <Formulation F>
std::string hash(int threads) {
  set_thread_count(threads);
  auto simulation = scene<F>(20'000);
  for (int k = 0; k < 200; ++k) advance(*simulation);
  return io::state_hash(ExperimentOf<F::Kinematics::dimension>(std::move(simulation), {}).state());
}

template <Formulation F>
void same_bits(std::string const& name, Table& table) {
  say("threads: bits of " + name);
  std::set<std::string> hashes;
  for (int const threads : {1, 2, 3, 8}) hashes.insert(hash<F>(threads));
  set_thread_count(1);
  table.rows.push_back({name,
                        "states",
                        exactly(static_cast<double>(hashes.size())),
                        Bar{.most = 1},
                        {hashes.size() == 1 ? hashes.begin()->substr(0, 16) : "they differ"}});
}

}  // namespace

Result threads(Options const& options) {
  Table speed{"Wall time on one thread over that on several, elastic APIC", {"1 thread [ns]", "several [ns]"}};
  speed_up<2>(options, speed);
  speed_up<3>(options, speed);
  Table bits{"States that 1, 2, 3 and 8 threads reach in 200 steps of 20 000 particles", {"hash begins"}};
  same_bits<Of<2, kernel::Quadratic, transfer::Aflip, law::CamClayMuI>>("2-D quadratic, AFLIP, Cam-Clay mu(I)", bits);
  same_bits<Of<3, kernel::Cubic>>("3-D cubic, APIC, Hencky", bits);
  return {{speed, bits}};
}

}  // namespace talus::bench
