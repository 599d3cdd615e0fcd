#pragma once
/// The experiment in D dimensions: a simulation, and what is measured, written and explained of it.

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "core/experiment.hpp"
#include "core/simulation.hpp"

namespace talus {

template <int D>
class ExperimentOf final : public Experiment {
 public:
  /// The simulation has begun. policies: kind and name of every choice, for `explain`.
  ExperimentOf(std::unique_ptr<Simulation<D>> simulation, std::vector<Explanation::Line> policies,
               std::vector<Station> stations = {})
      : simulation_(std::move(simulation)),
        policies_(std::move(policies)),
        stations_(std::move(stations)),
        first_front_(front()) {}

  [[nodiscard]] double time() const override { return simulation_->time(); }
  [[nodiscard]] long steps() const override { return simulation_->step_count(); }
  [[nodiscard]] std::size_t particles() const override { return simulation_->particles().count(); }
  [[nodiscard]] long sorts() const override { return simulation_->sorts(); }
  TimeStep advance(double end) override {
    simulation_->advance(end);
    last_dt_ = simulation_->last_step().dt;
    return simulation_->last_step();
  }

  [[nodiscard]] std::vector<Quantity> quantities() const override;
  [[nodiscard]] std::vector<double> measure() const override;
  [[nodiscard]] std::vector<Profile> profiles() const override;
  [[nodiscard]] std::vector<Balance> balances() const override;
  [[nodiscard]] Snapshot state() const override;
  [[nodiscard]] Snapshot frame() const override;
  [[nodiscard]] io::Checkpoint checkpoint() const override;
  void restore(io::Checkpoint const& checkpoint) override;
  [[nodiscard]] Explanation explain() const override;

 private:
  [[nodiscard]] double front() const {
    double x = -std::numeric_limits<double>::infinity();
    int const at = simulation_->particles().layout().find(field::position);
    simulation_->particles().for_each(
        [&](std::ptrdiff_t slot, int) { x = std::max(x, simulation_->particles().get(slot, at)); });
    return x;
  }
  /// Calls f(material, batch, first particle's number) for every run.
  template <class F>
  void for_each_run(F const& f) const {
    std::size_t first = 0;
    for (Run const& run : simulation_->particles().runs()) {
      auto const place = simulation_->grid().particle_block(static_cast<std::size_t>(run.block));
      Scene<D> const& scene = simulation_->scene();
      f(*scene.materials[static_cast<std::size_t>(run.material)],
        simulation_->particles().batch(run, scene.spacing, place), first);
      first += static_cast<std::size_t>(run.particles);
    }
  }
  void add_derived(Snapshot& snapshot) const;
  [[nodiscard]] double volume() const;
  [[nodiscard]] Snapshot samples(Station const& station) const;

  std::unique_ptr<Simulation<D>> simulation_;
  std::vector<Explanation::Line> policies_;
  std::vector<Station> stations_;
  double first_front_;
  double last_dt_ = 0;  ///< of the last step, or of that before the checkpoint that was restored [s]
};

extern template class ExperimentOf<2>;  // core/experiment_of.cpp
extern template class ExperimentOf<3>;

}  // namespace talus
