#pragma once
/// The passes of a step: what core/simulation.hpp declares.

#include <string>

#include "core/in_short.hpp"
#include "core/simulation.hpp"

namespace talus {

template <int D>
void Simulation<D>::measure() {
  Layout const& layout = particles_.layout();
  int const mass = layout.find(field::mass), velocity = layout.find(field::velocity);
  mass_ = largest_mass_ = 0;
  motion_ = {};
  particles_.for_each([&](std::ptrdiff_t slot, int) {
    mass_ += particles_.get(slot, mass);
    largest_mass_ = std::max(largest_mass_, particles_.get(slot, mass));
    for (int d = 0; d < D; ++d) motion_.speed = std::max(motion_.speed, std::abs(particles_.get(slot, velocity + d)));
  });
}

template <int D>
void Simulation<D>::resize() {
  pass_.resize(grid_, largest_mass_);
  motions_.resize(grid_.particle_blocks());
  shares_.resize(scene_.keeps_ledger ? grid_.particle_blocks() : 0);
  scratch_.resize(static_cast<std::size_t>(thread_count()));
  auto const chunks = static_cast<std::size_t>(particles_.most_chunks_of_a_run());
  for (Scratch& s : scratch_) {
    s.told.resize(pass_.told_size());
    s.summed.assign(pass_.summed_size(), NodeVector(0.0));
    s.loads.resize(chunks);
    s.dt_gradient.resize(chunks);
  }
}

template <int D>
double Simulation<D>::foreseen(double end) const {
  double const elastic = elastic_step(scene_), after = time_ + last_.dt;
  bool const sorted_first = drift_ + last_.dt * motion_.speed / scene_.spacing > drift_limit;
  return last_.limiter == "elastic" && end - after > elastic && !sorted_first ? elastic : 0;
}

template <int D>
void Simulation<D>::advance(double end) {
  last_ = next(end);
  double const dt = last_.dt;
  // A step a million times shorter than the stiffness asks for leads nowhere in a lifetime.
  bool const too_short = last_.limiter != "end" && !(dt > 1e-6 * elastic_step(scene_));
  if (!(dt > 0) || time_ + dt == time_ || too_short)
    throw RunError("the time step has become too small: dt = " + in_short(dt) + " s at t = " + in_short(time_) +
                   " s, limited by: " + std::string(last_.limiter) + "; the largest speed is " +
                   in_short(motion_.speed) + " m/s, of particle " + std::to_string(fastest()) + "." +
                   state_of(fastest()) +
                   "\nLikely causes: a velocity far above the wave speed, a state that blows up.");
  if (drift_ > drift_limit) sort();
  if (scattered_for_ != dt) particles_to_grid(dt);
  pass_.move(grid_, time_, dt, momentum_.walls);
  if (pass_.crowded())
    throw RunError("more than " + std::to_string(most_touches) +
                   " faces of walls touch one node in the step from t = " + in_short(time_) +
                   " s; join walls into a polyline or a container, or take out those that others hide");
  if (scene_.stages->remaps) map_back(dt);
  scattered_for_ = foreseen(end);
  grid_to_particles(dt, scattered_for_);

  momentum_.gravity += mass_ * dt * scene_.gravity;
  if (scene_.keeps_ledger) enter(dt);
  motion_ = {};
  for (Motion const& motion : motions_) motion_.unite(motion);
  if (motion_.failed >= 0) stop(dt);
  drift_ += dt * motion_.speed / scene_.spacing;
  time_ = last_.limiter == "end" ? end : time_ + dt;
  ++steps_;
}

template <int D>
void Simulation<D>::particles_to_grid(double dt) {
  pass_.clear();
  for_each_block([&](std::size_t block, std::size_t ahead, Scratch& own) {
    for_each_run(block, ahead, [&](Material<D> const& material, Batch<D> const& batch) {
      material.load(batch, scene_.stages->friction, own.loads.data());
      scene_.stages->scatter(batch, own.loads.data(), dt, own.summed.data());
    });
    pass_.add(grid_, block, own.summed.data());
    if (scene_.keeps_ledger || scene_.body_force) extras_to_grid(block, ahead, time_, dt, own);
  });
}

template <int D>
void Simulation<D>::map_back(double dt) {
  for_each_block([&](std::size_t block, std::size_t ahead, Scratch& own) {
    pass_.load(grid_, block, own.told.data());
    for_each_run(block, ahead, [&](Material<D> const&, Batch<D> const& batch) {
      scene_.stages->gather(batch, own.told.data(), dt, own.dt_gradient.data(), motions_[block]);
      scene_.stages->scatter_momentum(batch, own.summed.data());
    });
    pass_.add_moved(grid_, block, own.summed.data());
  });
  pass_.remap(grid_, time_, dt);
}

template <int D>
void Simulation<D>::grid_to_particles(double dt, double next) {
  Stages<D> const& stages = *scene_.stages;
  for_each_block([&](std::size_t block, std::size_t ahead, Scratch& own) {
    Motion& motion = motions_[block] = {};
    pass_.load(grid_, block, own.told.data());
    // a particle that has left its arena is not scattered: the step that follows sorts, or does not come
    auto const within = [&] { return motion.failed < 0 && drift_ + dt * motion.speed / scene_.spacing <= drift_limit; };
    Share* share = scene_.keeps_ledger ? &(shares_[block] = {}) : nullptr;
    for_each_run(block, ahead, [&](Material<D> const& material, Batch<D> const& batch) {
      bool const driven = share != nullptr && scene_.body_force;
      if (driven) {
        push(batch, time_, dt, own.impulses);
        share->body_force += body_force_totals(batch, own.impulses, -1 / dt);
      }
      if (stages.remaps)
        stages.gather_again(batch, own.told.data(), dt, own.dt_gradient.data(), motion);
      else
        stages.gather(batch, own.told.data(), dt, own.dt_gradient.data(), motion);
      Load<D>* loads = next > 0 ? own.loads.data() : nullptr;
      material.update(batch, own.dt_gradient.data(), dt, motion, loads, stages.friction,
                      share != nullptr ? &share->strain : nullptr);
      if (share != nullptr) share->after += totals_of(batch, stages.inertia * scene_.spacing * scene_.spacing);
      if (driven) share->body_force.work += body_force_totals(batch, own.impulses, 1 / dt).work;
      if (next > 0 && within()) stages.scatter(batch, loads, next, own.summed.data());
    });
    if (next > 0) {
      pass_.add(grid_, block, own.summed.data());
      if ((scene_.keeps_ledger || scene_.body_force) && within()) extras_to_grid(block, ahead, time_ + dt, next, own);
    }
  });
}

template <int D>
long Simulation<D>::fastest() const {
  Layout const& layout = particles_.layout();
  double most = -1;
  long id = -1;
  particles_.for_each([&](std::ptrdiff_t slot, int) {
    for (int d = 0; d < D; ++d)
      if (double const v = std::abs(particles_.get(slot, layout.find(field::velocity) + d)); v > most) {
        most = v;
        id = static_cast<long>(particles_.get(slot, layout.find(field::identity)));
      }
  });
  return id;
}

template <int D>
std::string Simulation<D>::state_of(long id) const {
  Layout const& layout = particles_.layout();
  std::string text;
  particles_.for_each([&](std::ptrdiff_t slot, int material) {
    if (static_cast<long>(particles_.get(slot, layout.find(field::identity))) != id) return;
    text += "\n  material = " + scene_.materials[static_cast<std::size_t>(material)]->name;
    for (Column const& column : layout.columns())
      for (int k = 0; k < column.components; ++k) {
        text.append("\n  ").append(column.info.name).append("[" + std::to_string(k) + "] = ");
        text.append(in_short(particles_.get(slot, column.offset + k)));
        if (column.info.unit != "1") text.append(1, ' ').append(column.info.unit);
      }
  });
  return text;
}

template <int D>
void Simulation<D>::stop(double dt) const {
  std::string text = motion_.cause == Motion::Cause::inverted
                         ? "an element inverted: det(I + dt L) <= 0 at particle "
                         : "the state of a particle is no longer finite: particle ";
  text += std::to_string(motion_.failed) + " in the step from t = " + in_short(time_) + " s, dt = " + in_short(dt) +
          " s (limited by " + std::string(last_.limiter) + ").";
  text += state_of(motion_.failed);
  text +=
      "\nLikely causes: a time step too long for the stiffness (lower /time/safety), a velocity far above the wave "
      "speed, "
      "walls that close on each other.";
  throw RunError(text);
}

}  // namespace talus
