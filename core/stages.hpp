#pragma once
/// The transfers of a composition at run time: kernel, transfer and integrator, called once a batch of particles.

#include "core/grid_to_particles.hpp"
#include "core/impulses_to_grid.hpp"
#include "core/integrator.hpp"
#include "core/particles_to_grid.hpp"
#include "core/transfer.hpp"

namespace talus {

template <int D>
class Stages {
 public:
  int arena_nodes = 0;       ///< of a block's arena
  int summed = 1;            ///< vectors of a node of the arenas that particles scatter into
  int told = 1;              ///< vectors of a node that particles gather from
  bool apart = false;        ///< the arenas keep the impulse apart from the momentum, in their second vector
  bool incremental = false;  ///< the particles are told the velocity before the step
  bool remaps = false;       ///< the integrator maps the moved particles back before it takes the gradient (MUSL)
  bool friction = false;     ///< nodes carry the material's friction
  double base_shift = 0;     ///< of the kernel
  double sharpness = 0;      ///< q of the isolated-particle bound on the time step
  double mass_floor = 0;     ///< least mass, in masses of a particle, that an internal force accelerates
  double inertia = 0;        ///< D_p / h^2 where the transfer is affine
  double kept = 0;           ///< alpha, the share of its velocity that a particle keeps and increments

  Stages() = default;
  Stages(Stages const&) = delete;
  virtual ~Stages() = default;

  virtual void declare(Layout& layout) const = 0;
  virtual void scatter(Batch<D> const&, Load<D> const* loads, double dt, NodeVector* arena) const = 0;
  virtual void gather(Batch<D> const&, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                      Motion&) const = 0;
  /// Moves what an arena holds of node block number n there; copies what an arena needs of it.
  virtual void add_arena(NodeVector* arena, int n, NodeVector* block) const = 0;
  virtual void load_arena(NodeVector const* block, int n, NodeVector* arena) const = 0;
  /// Momentum and mass of the particles, one vector a node; impulses of the particles likewise.
  virtual void scatter_momentum(Batch<D> const&, NodeVector* arena) const = 0;
  virtual void scatter_impulses(Batch<D> const&, std::vector<Point<D>> const& impulses, NodeVector* arena) const = 0;
  virtual void add_single(NodeVector* arena, int n, NodeVector* block) const = 0;
  /// Gradient of the remapped velocity, and the particles' new places.
  virtual void gather_again(Batch<D> const&, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                            Motion&) const = 0;
};

template <int dimension, Kernel K, Transfer T, Integrator I>
class StagesOf final : public Stages<dimension> {
 public:
  static constexpr int D = dimension;
  static constexpr int edge = arena_edge<K>;
  static constexpr bool apart_always = T::incremental || K::mass_floor > 0;
  static constexpr bool two_told = D == 3 && (T::incremental || I::remaps);
  static_assert(!T::affine || K::inertia > 0, "an affine transfer needs a kernel with a constant inertia");

  /// rubs: a wall takes its friction from the material.
  StagesOf(typename T::Parameters const& parameters, bool rubs) : transfer_(parameters) {
    this->arena_nodes = Arena<D, edge>::nodes;
    this->apart = apart_always || (rubs && D == 3);
    this->summed = this->apart ? 2 : 1;
    this->told = two_told ? 2 : 1;
    this->incremental = T::incremental;
    this->remaps = I::remaps;
    this->friction = rubs;
    this->base_shift = K::base_shift;
    this->sharpness = K::sharpness - (T::affine ? 0.5 / K::inertia : 0);
    this->mass_floor = K::mass_floor;
    this->inertia = T::affine ? K::inertia : 0;
    this->kept = transfer_.alpha;
  }

  void declare(Layout& layout) const override { layout.unite(typename T::State{}); }

  void scatter(Batch<D> const& batch, Load<D> const* loads, double dt, NodeVector* arena) const override {
    constexpr Scatter plain{.affine = T::affine, .apart = apart_always};
    constexpr Scatter rubbing{.affine = T::affine, .apart = apart_always || D == 3, .friction = true};
    if (this->friction)
      particles_to_grid<D, K, rubbing>(batch, loads, dt, arena);
    else
      particles_to_grid<D, K, plain>(batch, loads, dt, arena);
  }

  void add_arena(NodeVector* arena, int n, NodeVector* block) const override {
    if (this->apart)
      talus::add_arena<D, edge, 2>(arena, n, block);
    else
      talus::add_arena<D, edge, 1>(arena, n, block);
  }

  void load_arena(NodeVector const* block, int n, NodeVector* arena) const override {
    talus::load_arena<D, edge, two_told ? 2 : 1>(block, n, arena);
  }

  void gather(Batch<D> const& batch, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
              Motion& motion) const override {
    constexpr Gather gather{.affine = T::affine,
                            .gradient = !I::remaps,
                            .advect = !I::remaps,
                            .second = T::incremental ? Gather::Second::old : Gather::Second::none,
                            .told = two_told ? 2 : 1};
    grid_to_particles<D, K, gather>(batch, arena, dt, transfer_.alpha, dt_gradient, motion);
  }

  void scatter_momentum(Batch<D> const& batch, NodeVector* arena) const override {
    particles_to_grid<D, K, Scatter{.affine = T::affine, .loaded = false}>(batch, nullptr, 0, arena);
  }

  void scatter_impulses(Batch<D> const& batch, std::vector<Point<D>> const& impulses,
                        NodeVector* arena) const override {
    impulses_to_grid<D, K>(batch, impulses, arena);
  }

  void add_single(NodeVector* arena, int n, NodeVector* block) const override {
    talus::add_arena<D, edge, 1>(arena, n, block);
  }

  void gather_again(Batch<D> const& batch, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                    Motion& motion) const override {
    if constexpr (I::remaps)
      grid_to_particles<D, K, Gather{.update = false, .second = Gather::Second::remapped, .told = two_told ? 2 : 1}>(
          batch, arena, dt, 0, dt_gradient, motion);
  }

 private:
  T transfer_;
};

}  // namespace talus
