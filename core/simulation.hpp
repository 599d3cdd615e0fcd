#pragma once
/// A simulation: particles, grid and clock, and the step that moves them.
///
/// One step from t to t + dt (update stress last; MUSL maps back in between):
///
///   particles to grid   stress of the strain that was left, momentum, mass, force into a block's arena and the nodes
///   grid                nodes accelerated, walls
///   grid to particles   velocities, positions, dt L
///   law                 trial strain, return map
///
/// A step begins and ends with particles: strain and state are stored, the stress never is. While a block's particles
/// are in the core's cache after the law, they are scattered for the next step, too, if its length can be foreseen; a
/// step whose length was foreseen wrongly, and the first one after a sort or a checkpoint, scatters by itself. The bits
/// are the same.

#include <string>
#include <vector>

#include "core/grid_pass.hpp"
#include "core/particles.hpp"
#include "core/time_step.hpp"

namespace talus {

/// A particle may move this many cells before it must be sorted anew; the margin is for rounding.
inline constexpr double drift_limit = 0.5 - 1e-6;

/// Momentum that came in since the start, by source [kg m/s].
template <int D>
struct Momentum {
  Point<D> gravity = Point<D>::Zero();
  Impulses<D> walls;
};

/// Where a run has come to, besides its particles and their blocks.
template <int D>
struct Reached {
  double time = 0, drift = 0;  ///< [s], since the last sort [h]
  long steps = 0;
  double mass = 0;  ///< of all particles [kg]; kept, because the bits of a sum depend on the order of the particles
  Motion motion;
  Momentum<D> momentum;
  Ledger<D> ledger;
};

template <int D>
class Simulation {
 public:
  explicit Simulation(Scene<D> scene);
  ~Simulation();
  Simulation(Simulation const&) = delete;

  [[nodiscard]] Scene<D> const& scene() const { return scene_; }
  [[nodiscard]] Particles<D>& particles() {
    scattered_for_ = 0;  // the caller may change them
    return particles_;
  }
  [[nodiscard]] Particles<D> const& particles() const { return particles_; }
  [[nodiscard]] BlockGrid<D> const& grid() const { return grid_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] long step_count() const { return steps_; }
  [[nodiscard]] double drift() const { return drift_; }
  [[nodiscard]] long sorts() const { return sorts_; }
  [[nodiscard]] Momentum<D> const& momentum() const { return momentum_; }
  /// Of the steps so far, where the scene keeps one.
  [[nodiscard]] Ledger<D> const& ledger() const { return ledger_; }
  [[nodiscard]] Motion const& motion() const { return motion_; }
  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] TimeStep last_step() const { return last_; }
  [[nodiscard]] std::size_t bytes() const { return particles_.bytes() + pass_.bytes(); }

  /// To be called once the particles are in: total mass, first speed, first sort.
  void begin();
  /// Goes on from a checkpoint, whose particles are in their order, with the blocks of these keys.
  void resume(std::vector<std::uint64_t> keys, Reached<D> reached);

  /// The step that `advance` would take towards `end` [s].
  [[nodiscard]] TimeStep next(double end) const {
    return next_step(scene_, motion_.speed, motion_.gradient, end - time_);
  }

  /// One step towards `end`, on which the last one lands exactly. Throws RunError where the state is lost.
  void advance(double end);

 private:
  struct Scratch;
  void measure();
  void sort();
  void resize();
  void particles_to_grid(double dt);
  /// next: length of the step to scatter for [s], or 0.
  void grid_to_particles(double dt, double next);
  /// Length of the step after this one, where nothing but the stiffness will limit it; else 0. [s]
  [[nodiscard]] double foreseen(double end) const;
  /// What `particles_to_grid` sends besides: the impulse of the body force, and the momentum for the ledger.
  void push(Batch<D> const& batch, double t, double dt, std::vector<Point<D>>& impulses) const;
  void extras_to_grid(std::size_t block, std::size_t ahead, double t, double dt, Scratch& own);
  void map_back(double dt);
  [[nodiscard]] Totals<D> totals();
  void enter(double dt);
  /// Id of the fastest particle.
  [[nodiscard]] long fastest() const;
  /// Material and fields of a particle, a line each.
  [[nodiscard]] std::string state_of(long id) const;
  [[noreturn]] void stop(double dt) const;

  struct Scratch {
    std::vector<NodeVector> told;    ///< nodes that a block gathers from
    std::vector<NodeVector> summed;  ///< nodes that a block scatters into; zero between blocks
    std::vector<Load<D>> loads;
    std::vector<Matrix<Lanes, D>> dt_gradient;
    std::vector<Point<D>> impulses;  ///< of the body force on the particles of a run
  };
  /// A block's share of the ledger's sums of one step.
  struct Share {
    Totals<D> after;
    StrainWork<> strain;
    BodyForceTotals<D> body_force;
  };
  Scratch& scratch() { return scratch_[static_cast<std::size_t>(thread_number())]; }

  /// Calls f(block, the one after it, scratch) for the particle blocks, those of one colour at the same time.
  template <class F>
  void for_each_block(F const& f) {
    for (int c = 0; c < BlockGrid<D>::colours; ++c) {
      auto const blocks = grid_.coloured(c);
      for_each_index(static_cast<std::ptrdiff_t>(blocks.size()), [&](std::ptrdiff_t k) {
        auto const own = static_cast<std::size_t>(k);
        auto const next = static_cast<std::size_t>(blocks[std::min(own + 1, blocks.size() - 1)]);
        f(static_cast<std::size_t>(blocks[own]), next, scratch());
      });
    }
  }
  /// Calls f(material, batch) for the runs of a block; `ahead` is the block that comes next.
  template <class F>
  void for_each_run(std::size_t block, std::size_t ahead, F const& f) {
    for (std::size_t r = particles_.first_run(block); r < particles_.first_run(block + 1); ++r) {
      Run const& run = particles_.runs()[r];
      Batch<D> batch = particles_.batch(run, scene_.spacing, grid_.particle_block(block));
      batch.ahead = particles_.chunks_of(ahead);
      f(*scene_.materials[static_cast<std::size_t>(run.material)], batch);
    }
  }

  Scene<D> scene_;
  Particles<D> particles_;
  BlockGrid<D> grid_;
  GridPass<D> pass_;
  std::vector<Scratch> scratch_;
  std::vector<Motion> motions_;
  std::vector<Share> shares_;
  Ledger<D> ledger_;
  Motion motion_;
  Momentum<D> momentum_;
  TimeStep last_;
  double time_ = 0, drift_ = 0, mass_ = 0, largest_mass_ = 0;
  double scattered_for_ = 0;  ///< length of the step that the arenas hold the particles for, or 0 [s]
  long steps_ = 0, sorts_ = 0;
};

extern template class Simulation<2>;  // core/simulation.cpp
extern template class Simulation<3>;

}  // namespace talus
