#pragma once
/// The passes of a step: what core/simulation.hpp declares.

#include <sstream>
#include <string>

#include "core/simulation.hpp"

namespace talus {

/// A number in six digits, for messages.
inline std::string in_short(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

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
  scratch_.resize(static_cast<std::size_t>(thread_count()));
  auto const chunks = static_cast<std::size_t>(particles_.most_chunks_of_a_run());
  for (Scratch& s : scratch_) {
    s.arena.resize(pass_.arena_size());
    s.loads.resize(chunks);
    s.dt_gradient.resize(chunks);
  }
}

template <int D>
void Simulation<D>::advance(double end) {
  // A particle may lie one cell beyond its block, no more; the margin is for rounding.
  constexpr double drift_limit = 1 - 1e-6;
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
  particles_to_grid(dt);
  Impulses<D> const impulses = pass_.move(grid_, time_, dt);
  if (scene_.stages->remaps) map_back(dt);
  grid_to_particles(dt);

  for (std::size_t w = 0; w < impulses.size(); ++w) momentum_.walls[w] += impulses[w];
  momentum_.gravity += mass_ * dt * scene_.gravity;
  motion_ = {};
  for (Motion const& motion : motions_) motion_.unite(motion);
  if (motion_.failed >= 0) stop(dt);
  drift_ += dt * motion_.speed / scene_.spacing;
  time_ = last_.limiter == "end" ? end : time_ + dt;
  ++steps_;
}

template <int D>
void Simulation<D>::particles_to_grid(double dt) {
  for_each_index(static_cast<std::ptrdiff_t>(grid_.particle_blocks()), [&](std::ptrdiff_t b) {
    auto const block = static_cast<std::size_t>(b);
    NodeVector* arena = pass_.cleared_arena(block);
    Scratch& own = scratch();
    for_each_run(block, [&](Material<D> const& material, Batch<D> const& batch) {
      material.load(batch, scene_.stages->friction, own.loads.data());
      scene_.stages->scatter(batch, own.loads.data(), dt, arena);
    });
  });
}

template <int D>
void Simulation<D>::map_back(double dt) {
  for_each_index(static_cast<std::ptrdiff_t>(grid_.particle_blocks()), [&](std::ptrdiff_t b) {
    auto const block = static_cast<std::size_t>(b);
    Scratch& own = scratch();
    pass_.load(grid_, block, own.arena.data());
    NodeVector* arena = pass_.cleared_arena(block);
    for_each_run(block, [&](Material<D> const&, Batch<D> const& batch) {
      scene_.stages->gather(batch, own.arena.data(), dt, own.dt_gradient.data(), motions_[block]);
      scene_.stages->scatter_again(batch, arena);
    });
  });
  pass_.remap(grid_, time_, dt);
}

template <int D>
void Simulation<D>::grid_to_particles(double dt) {
  for_each_index(static_cast<std::ptrdiff_t>(grid_.particle_blocks()), [&](std::ptrdiff_t b) {
    auto const block = static_cast<std::size_t>(b);
    Scratch& own = scratch();
    Motion& motion = motions_[block] = {};
    pass_.load(grid_, block, own.arena.data());
    for_each_run(block, [&](Material<D> const& material, Batch<D> const& batch) {
      if (scene_.stages->remaps)
        scene_.stages->gather_again(batch, own.arena.data(), dt, own.dt_gradient.data(), motion);
      else
        scene_.stages->gather(batch, own.arena.data(), dt, own.dt_gradient.data(), motion);
      material.update(batch, own.dt_gradient.data(), dt, motion);
    });
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
