#pragma once
/// What only some scenes ask of a step: a body force, a ledger. Declared in core/simulation.hpp.

#include "core/simulation.hpp"

namespace talus {

/// Impulse of the body force on the particles of a batch in the step from t to t + dt.
template <int D>
void Simulation<D>::push(Batch<D> const& batch, double t, double dt, std::vector<Point<D>>& impulses) const {
  impulses.resize(static_cast<std::size_t>(batch.particles));
  for (int p = 0; p < batch.particles; ++p) {
    Lanes const* chunk = batch.chunk(p / lanes);
    auto const id = static_cast<long>(chunk[batch.at.identity][p % lanes]);
    impulses[static_cast<std::size_t>(p)] =
        chunk[batch.at.mass][p % lanes] * dt * scene_.body_force->acceleration(id, t);
  }
}

/// Impulse and torque of these impulses, and `share` of the work that they do along x.
template <int D>
BodyForceTotals<D> body_force_totals(Batch<D> const& batch, std::vector<Point<D>> const& impulses, double share) {
  BodyForceTotals<D> sum;
  for (int p = 0; p < batch.particles; ++p) {
    Point<D> x;
    for (int d = 0; d < D; ++d) x[d] = batch.chunk(p / lanes)[batch.at.position + d][p % lanes];
    Point<D> const& impulse = impulses[static_cast<std::size_t>(p)];
    sum += {share * impulse.dot(x), impulse, cross<D>(x, impulse)};
  }
  return sum;
}

template <int D>
void Simulation<D>::extras_to_grid(std::size_t block, std::size_t ahead, double t, double dt, Scratch& own) {
  if (scene_.body_force) {
    for_each_run(block, ahead, [&](Material<D> const&, Batch<D> const& batch) {
      push(batch, t, dt, own.impulses);
      scene_.stages->scatter_impulses(batch, own.impulses, own.summed.data());
    });
    pass_.add_body_force(grid_, block, own.summed.data());
  }
  if (scene_.keeps_ledger && !scene_.stages->apart) {
    for_each_run(block, ahead, [&](Material<D> const&, Batch<D> const& batch) {
      scene_.stages->scatter_momentum(batch, own.summed.data());
    });
    pass_.add_momentum(grid_, block, own.summed.data());
  }
}

/// Of the particles as they are.
template <int D>
Totals<D> Simulation<D>::totals() {
  Totals<D> sum;
  for (Run const& run : particles_.runs()) {
    Batch<D> const batch =
        particles_.batch(run, scene_.spacing, grid_.particle_block(static_cast<std::size_t>(run.block)));
    sum += totals_of(batch, scene_.stages->inertia * scene_.spacing * scene_.spacing);
    sum.elastic += scene_.materials[static_cast<std::size_t>(run.material)]->elastic_energy(batch);
  }
  return sum;
}

/// Enters the step from time_ to time_ + dt, which the particles have done, into the ledger.
template <int D>
void Simulation<D>::enter(double dt) {
  Share sum;
  for (Share const& share : shares_) {
    sum.after += share.after;
    sum.strain += share.strain;
    sum.body_force += share.body_force;
  }
  sum.after.elastic = sum.strain.after;
  ledger_.enter(dt, scene_.gravity, sum.after, sum.strain, pass_.account(grid_, dt), sum.body_force);
}

}  // namespace talus
