#pragma once
/// The transfers of a composition at run time: kernel, transfer and integrator, called once a batch of particles.

#include "core/grid_to_particles.hpp"
#include "core/integrator.hpp"
#include "core/particles_to_grid.hpp"
#include "core/transfer.hpp"

namespace talus {

template <int D>
class Stages {
 public:
  int arena_edge = 0;     ///< nodes along an edge of a block's arena
  int vectors = 1;        ///< vectors of a node: 2 where the velocity before the step, friction or a remap is asked for
  bool remaps = false;    ///< the integrator maps the moved particles back before it takes the gradient (MUSL)
  bool friction = false;  ///< nodes carry the material's friction
  double base_shift = 0;  ///< of the kernel
  double sharpness = 0;   ///< q of the isolated-particle bound on the time step
  double mass_floor = 0;  ///< least mass, in masses of a particle, that an internal force accelerates

  Stages() = default;
  Stages(Stages const&) = delete;
  virtual ~Stages() = default;

  [[nodiscard]] int arena_nodes() const {
    return D == 2 ? arena_edge * arena_edge : arena_edge * arena_edge * arena_edge;
  }

  virtual void declare(Layout& layout) const = 0;
  virtual void scatter(Batch<D> const&, Load<D> const* loads, double dt, NodeVector* arena) const = 0;
  virtual void gather(Batch<D> const&, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                      Motion&) const = 0;
  /// Momentum of the moved particles, one vector a node.
  virtual void scatter_again(Batch<D> const&, NodeVector* arena) const = 0;
  /// Gradient of the remapped velocity, and the particles' new places.
  virtual void gather_again(Batch<D> const&, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                            Motion&) const = 0;
};

template <int dimension, Kernel K, Transfer T, Integrator I>
class StagesOf final : public Stages<dimension> {
 public:
  static constexpr int D = dimension;
  static_assert(!T::affine || K::inertia > 0, "an affine transfer needs a kernel with a constant inertia");

  /// rubs: a wall takes its friction from the material.
  StagesOf(typename T::Parameters const& parameters, bool rubs) : transfer_(parameters) {
    this->arena_edge = talus::arena_edge<K>;
    this->vectors = T::incremental || I::remaps || rubs ? 2 : 1;
    this->remaps = I::remaps;
    this->friction = rubs;
    this->base_shift = K::base_shift;
    this->sharpness = K::sharpness - (T::affine ? 0.5 / K::inertia : 0);
    this->mass_floor = K::mass_floor;
  }

  void declare(Layout& layout) const override { layout.unite(typename T::State{}); }

  void scatter(Batch<D> const& batch, Load<D> const* loads, double dt, NodeVector* arena) const override {
    constexpr bool always_apart = T::incremental || I::remaps;
    if (this->friction)
      particles_to_grid<D, K, Scatter{.affine = T::affine, .apart = true, .friction = true}>(batch, loads, dt, arena);
    else
      particles_to_grid<D, K, Scatter{.affine = T::affine, .apart = always_apart}>(batch, loads, dt, arena);
  }

  void gather(Batch<D> const& batch, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
              Motion& motion) const override {
    constexpr Gather one{.affine = T::affine, .gradient = !I::remaps, .advect = !I::remaps};
    constexpr Gather two{
        .affine = T::affine, .gradient = !I::remaps, .advect = !I::remaps, .second = Gather::Second::old};
    double const alpha = transfer_.alpha;
    if constexpr (!T::incremental && !I::remaps)
      if (!this->friction) return grid_to_particles<D, K, one>(batch, arena, dt, alpha, dt_gradient, motion);
    grid_to_particles<D, K, two>(batch, arena, dt, alpha, dt_gradient, motion);
  }

  void scatter_again(Batch<D> const& batch, NodeVector* arena) const override {
    if constexpr (I::remaps)
      particles_to_grid<D, K, Scatter{.affine = T::affine, .loaded = false}>(batch, nullptr, 0, arena);
  }

  void gather_again(Batch<D> const& batch, NodeVector const* arena, double dt, Matrix<Lanes, D>* dt_gradient,
                    Motion& motion) const override {
    if constexpr (I::remaps)
      grid_to_particles<D, K, Gather{.update = false, .second = Gather::Second::remapped}>(batch, arena, dt, 0,
                                                                                           dt_gradient, motion);
  }

 private:
  T transfer_;
};

}  // namespace talus
