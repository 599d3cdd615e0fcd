#include "benchmarks/flow.hpp"

#include <fmt/format.h>

#include "benchmarks/scenes/compete.hpp"
#include "benchmarks/scenes/compose.hpp"
#include "benchmarks/scenes/formulations.hpp"
#include "core/experiment_of.hpp"

namespace talus::bench {

namespace {

template <int D>
Filling filling_of(Options const& options) {
  Filling filling;
  filling.particles = options.particles_or(filling.particles);
  filling.a_cell = D == 2 ? 6 : 8;
  return filling;
}

/// A block that is sheared and pressed upon its floor: v_x grows with the height, up to the largest speed of the
/// elastic scene, so that sorts come as seldom as there; v_y falls with it, down to a quarter of that.
template <int D>
Cloud<D> sheared(Filling const& filling) {
  Cloud<D> cloud = block<D>(filling);
  double const rate = filling.speed / (cloud.high[1] - cloud.low[1]);
  for (std::size_t k = 0; k < cloud.count(); ++k) {
    cloud.velocities[k].setZero();
    double const height = cloud.places[k][1] - cloud.low[1];
    cloud.velocities[k][0] = rate * height;
    cloud.velocities[k][1] = -0.25 * rate * height;
  }
  return cloud;
}

/// Share of the particles whose plastic shear rate is not zero, and the median of the pressure [Pa].
struct Flowing {
  double share, pressure;
};
template <int D>
Flowing flowing_now(Simulation<D>& simulation) {
  Particles<D>& particles = simulation.particles();
  std::size_t count = 0;
  std::vector<double> pressures;
  std::vector<Lanes> values;
  for (Run const& run : particles.runs()) {
    auto const& material = *simulation.scene().materials[static_cast<std::size_t>(run.material)];
    auto const names = material.derived();
    auto const rate = static_cast<std::size_t>(
        std::find_if(names.begin(), names.end(), [](FieldInfo const& f) { return f.name == "shear_rate"; }) -
        names.begin());
    auto const place = simulation.grid().particle_block(static_cast<std::size_t>(run.block));
    auto const batch = particles.batch(run, simulation.scene().spacing, place);
    for (int c = 0; c < batch.count; ++c) {
      material.derive(batch, c, values);
      for (int lane = 0; lane < batch.filled(c); ++lane) {
        count += values[rate][lane] > 0 ? 1 : 0;
        pressures.push_back(values[0][lane]);
      }
    }
  }
  return {static_cast<double>(count) / static_cast<double>(particles.count()), quantile(pressures, 0.5)};
}

template <int D>
void measure(std::string const& name, Options const& options, Table& table) {
  say("ratios: " + name + ", Cam-Clay mu(I) in plastic flow");
  using Flow = Of<D, kernel::Quadratic, transfer::Apic, law::CamClayMuI>;
  using Elastic = Of<D, kernel::Quadratic>;
  Filling const filling = filling_of<D>(options);
  Cloud<D> const cloud = sheared<D>(filling), waves = block<D>(filling);
  auto flowing = simulate<Flow>(setup<Flow>(cloud.spacing), {cloud}, corner<D>(cloud.low));
  auto elastic = simulate<Elastic>(setup<Elastic>(waves.spacing), {waves}, corner<D>(waves.low));
  set_thread_count(1);
  for (int k = 0; k < 60; ++k) advance(*flowing);  // until weight and shear have built up
  Flowing const before = flowing_now(*flowing);
  auto const times = take_turns({competitor("elastic", *elastic), competitor("flowing", *flowing)},
                                {.count = options.repeats_or(41), .slice = 0.04});
  Flowing const after = flowing_now(*flowing);
  table.rows.push_back({name,
                        "×",
                        ratio(times[0], times[1]),
                        Bar{.least = 0.7, .stretch = 0.85},
                        {fmt::format("{:.1f}", 1e9 * estimate(times[1]).median / double(cloud.count())),
                         fmt::format("{:.1f} % to {:.1f} %", 100 * before.share, 100 * after.share),
                         fmt::format("{:.0f} to {:.0f} Pa", before.pressure, after.pressure)}});
}

}  // namespace

Table flow(Options const& options) {
  Table table{"Rate of Cam-Clay mu(I) in plastic flow over elastic Hencky, APIC, one thread",
              {"ns a particle-step", "particles that yield", "median pressure"}};
  measure<2>("2-D quadratic", options, table);
  measure<3>("3-D quadratic", options, table);
  table.notes = {
      "A particle counts as yielding where its plastic shear rate is above zero; shares at the beginning and the end "
      "of "
      "what was timed."};
  return table;
}

}  // namespace talus::bench
