#pragma once
/// The time series of an experiment, and its frames: what core/experiment_of.hpp declares.

#include "core/experiment_of.hpp"
#include "core/sampler.hpp"

namespace talus {

template <int D>
std::vector<Quantity> ExperimentOf<D>::quantities() const {
  std::vector<std::string> walls;
  for (auto const& wall : simulation_->scene().walls) walls.push_back(wall->name);
  return series_quantities(D, walls, simulation_->scene().keeps_ledger, stations_);
}

template <int D>
std::vector<double> ExperimentOf<D>::measure() const {
  auto const& particles = simulation_->particles();
  Layout const& layout = particles.layout();
  int const at_x = layout.find(field::position), at_v = layout.find(field::velocity), at_m = layout.find(field::mass);
  double mass = 0, twice_kinetic = 0, fastest = 0, elastic = 0;
  Point<D> first_moment = Point<D>::Zero(), momentum = Point<D>::Zero();
  particles.for_each([&](std::ptrdiff_t slot, int) {
    double const m = particles.get(slot, at_m);
    double square = 0;
    for (int d = 0; d < D; ++d) {
      double const v = particles.get(slot, at_v + d);
      first_moment[d] += m * particles.get(slot, at_x + d);
      momentum[d] += m * v;
      square += v * v;
    }
    mass += m;
    twice_kinetic += m * square;
    fastest = std::max(fastest, square);
  });
  for_each_run([&](Material<D> const& material, Batch<D> const& batch, std::size_t) {
    elastic += material.elastic_energy(batch);
  });
  std::vector<double> values{time(), double(steps()), last_dt_, front() - first_front_};
  for (int d = 0; d < D; ++d) values.push_back(first_moment[d] / mass);
  for (int d = 0; d < D; ++d) values.push_back(momentum[d] / mass);
  values.insert(values.end(), {std::sqrt(twice_kinetic / mass), std::sqrt(fastest), 0.5 * twice_kinetic, elastic,
                               -first_moment.dot(simulation_->scene().gravity), volume()});
  for (Point<D> const& impulse : simulation_->momentum().walls)
    for (int d = 0; d < D; ++d) values.push_back(impulse[d]);
  if (simulation_->scene().keeps_ledger) {
    Ledger<D> const& l = simulation_->ledger();
    values.insert(values.end(), l.now.spin.begin(), l.now.spin.end());
    values.insert(values.end(),
                  {l.now.kinetic, l.gravity, l.walls, l.plastic, l.transfer, l.stepping, l.relative_energy_residual()});
  }
  for (Station const& station : stations_) {
    auto const own = talus::measure(station, samples(station));
    values.insert(values.end(), own.begin(), own.end());
  }
  return values;
}

template <int D>
Snapshot ExperimentOf<D>::samples(Station const& station) const {
  Sampler<D> sampler(station, simulation_->scene(), time(), steps());
  for_each_run([&](Material<D> const& material, Batch<D> const& batch, std::size_t) { sampler.take(material, batch); });
  return sampler.samples();
}

template <int D>
std::vector<Profile> ExperimentOf<D>::profiles() const {
  std::vector<Profile> list;
  for (Station const& station : stations_) list.push_back(profile(station, samples(station)));
  return list;
}

/// sum V_p / sum V_p^0.
template <int D>
double ExperimentOf<D>::volume() const {
  double volume = 0, before = 0;
  std::vector<Lanes> derived;
  for_each_run([&](Material<D> const& material, Batch<D> const& batch, std::size_t) {
    for (int c = 0; c < batch.count; ++c) {
      material.derive(batch, c, derived);
      for (int lane = 0; lane < batch.filled(c); ++lane) {
        double const own = batch.chunk(c)[batch.at.mass][lane] / material.density;
        before += own;
        volume += own * derived[2][lane];
      }
    }
  });
  return volume / before;
}

template <int D>
Snapshot ExperimentOf<D>::state() const {
  auto const& particles = simulation_->particles();
  Snapshot snapshot{time(), steps(), D, {}};
  for (Column const& column : particles.layout().columns()) {
    NamedColumn named{std::string(column.info.name),
                      std::string(column.info.symbol),
                      std::string(column.info.unit),
                      std::string(column.info.meaning),
                      column.components,
                      {}};
    named.values.reserve(particles.count() * static_cast<std::size_t>(column.components));
    particles.for_each([&](std::ptrdiff_t slot, int) {
      for (int k = 0; k < column.components; ++k) named.values.push_back(particles.get(slot, column.offset + k));
    });
    snapshot.columns.push_back(std::move(named));
  }
  return snapshot;
}

template <int D>
void ExperimentOf<D>::add_derived(Snapshot& snapshot) const {
  std::vector<FieldInfo> infos;
  std::vector<std::vector<double>> values;
  std::vector<Lanes> packs;
  for_each_run([&](Material<D> const& material, Batch<D> const& batch, std::size_t first) {
    std::vector<FieldInfo> const own = material.derived();
    std::vector<std::size_t> columns;
    for (FieldInfo const& info : own) {
      auto const at = std::find_if(infos.begin(), infos.end(), [&](FieldInfo const& i) { return i.name == info.name; });
      columns.push_back(static_cast<std::size_t>(at - infos.begin()));
      if (at != infos.end()) continue;
      infos.push_back(info);
      values.emplace_back(particles(), 0.0);
    }
    for (int c = 0; c < batch.count; ++c) {
      material.derive(batch, c, packs);
      for (int lane = 0; lane < batch.filled(c); ++lane)
        for (std::size_t k = 0; k < columns.size(); ++k)
          values[columns[k]][first + static_cast<std::size_t>(c * lanes + lane)] = packs[k][lane];
    }
  });
  for (std::size_t k = 0; k < infos.size(); ++k)
    snapshot.columns.push_back({std::string(infos[k].name), std::string(infos[k].symbol), std::string(infos[k].unit),
                                std::string(infos[k].meaning), 1, std::move(values[k])});
}

template <int D>
Snapshot ExperimentOf<D>::frame() const {
  Snapshot snapshot = state();
  add_derived(snapshot);
  NamedColumn material{"material", "k", "1", "number of the material in the case", 1, {}};
  simulation_->particles().for_each([&](std::ptrdiff_t, int number) { material.values.push_back(number); });
  snapshot.columns.push_back(std::move(material));
  return snapshot;
}

}  // namespace talus
