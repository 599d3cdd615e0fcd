#pragma once
/// A material at run time: one law in one kinematics, called once a batch of particles.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/kinematics.hpp"
#include "core/law.hpp"
#include "core/ledger.hpp"
#include "core/log_strain.hpp"
#include "core/particles_to_grid.hpp"

namespace talus {

namespace field {
inline constexpr struct Pressure : ScalarField {
  static constexpr std::string_view name = "pressure", symbol = "p", unit = "Pa",
                                    meaning = "pressure of the Kirchhoff stress, positive in compression";
} pressure;
inline constexpr struct ShearStress : ScalarField {
  static constexpr std::string_view name = "shear_stress", symbol = "q", unit = "Pa",
                                    meaning = "norm of the Kirchhoff stress deviator over sqrt(2)";
} shear_stress;
inline constexpr struct VolumeRatio : ScalarField {
  static constexpr std::string_view name = "volume_ratio", symbol = "J", unit = "1",
                                    meaning = "volume over initial volume; the solid fraction is phi_0 / J";
} volume_ratio;
}  // namespace field

/// What the step asks of a material. Fields are read and written in place.
template <int D>
class Material {
 public:
  std::string name, law;
  double density;  ///< of the undeformed bulk [kg/m^3]

  Material(std::string its_name, std::string its_law, double its_density)
      : name(std::move(its_name)), law(std::move(its_law)), density(its_density) {}
  Material(Material const&) = delete;
  virtual ~Material() = default;

  /// Adds the law's own fields.
  virtual void declare(Layout& layout) const = 0;
  /// Learns where the law's fields lie.
  virtual void bind(Layout const& layout) = 0;
  /// Writes the law's initial state of one particle: calls set(pack, value).
  virtual void start(std::vector<std::pair<int, double>>& values) const = 0;
  /// V_p^0 tau_p of every chunk, and mu_p where `friction`.
  virtual void load(Batch<D> const& batch, bool friction, Load<D>* loads) const = 0;
  /// Trial strain from dt L, return map, new state; then what `load` gives, unless `loads` is null. dt_gradient and
  /// loads have one entry a chunk; motion.gradient is the largest norm of L. Adds to `work` unless it is null. Tells
  /// `motion` of particles whose state is no longer finite, or which were turned inside out.
  virtual void update(Batch<D> const& batch, Matrix<Lanes, D> const* dt_gradient, double dt, Motion& motion,
                      Load<D>* loads, bool friction, StrainWork<>* work) const = 0;
  /// Stored energy of the batch [J].
  [[nodiscard]] virtual double elastic_energy(Batch<D> const& batch) const = 0;
  /// d_s lambda + 2 G [Pa]: of a change of volume.
  [[nodiscard]] virtual double volumetric_modulus() const = 0;
  /// The stiffest answer of the stress to a motion in D dimensions [Pa]: the modulus that limits the time step.
  [[nodiscard]] virtual double stiffest_modulus() const = 0;
  /// lambda + 2 G [Pa]: of waves of compression.
  [[nodiscard]] virtual double wave_modulus() const = 0;
  /// True where walls may take their friction from the material.
  [[nodiscard]] virtual bool has_friction() const = 0;
  /// Quantities that are computed from the state for output.
  [[nodiscard]] virtual std::vector<FieldInfo> derived() const = 0;
  /// Those quantities of chunk c, in the order of `derived`.
  virtual void derive(Batch<D> const& batch, int c, std::vector<Lanes>& values) const = 0;
};

/// The walls may take their friction from a law that tells its friction.
template <class L>
concept HasFriction = requires(L const law, Symmetric<double, shape::Solid> eps, Record<double, typename L::State> s) {
  { law.friction(eps, s) } -> std::same_as<double>;
};

template <class Kinematics, class Law>
class MaterialOf final : public Material<Kinematics::dimension> {
 public:
  static constexpr int D = Kinematics::dimension;
  using Shape = typename Kinematics::Shape;
  using Strain = Symmetric<Lanes, Shape>;
  using State = Record<Lanes, typename Law::State>;

  MaterialOf(std::string its_name, double its_density, typename Law::Parameters const& parameters)
      : Material<D>(std::move(its_name), std::string(Law::name), its_density), law_(parameters) {}

  void declare(Layout& layout) const override { layout.unite(typename Law::State{}); }

  void bind(Layout const& layout) override {
    [&]<Field... F>(Fields<F...>) {
      state_at_ = {layout.find(F{})...};
    }
    (typename Law::State{});
  }

  void start(std::vector<std::pair<int, double>>& values) const override {
    auto const state = law_.template initial<Shape>();
    for (std::size_t k = 0; k < state_at_.size(); ++k) values.emplace_back(state_at_[k], state.values[k]);
  }

  [[gnu::flatten]] void load(Batch<D> const& batch, bool friction, Load<D>* loads) const override {
    for (int c = 0; c < batch.count; ++c) {
      Lanes const* chunk = batch.chunk(c);
      loads[c] = load_of(batch, chunk, strain(batch, chunk), state(chunk), friction);
    }
  }

  [[gnu::flatten]] void update(Batch<D> const& batch, Matrix<Lanes, D> const* dt_gradient, double dt, Motion& motion,
                               Load<D>* loads, bool friction, StrainWork<>* work) const override {
    StrainWork<Lanes> sum;
    std::array<Wide, Strain::size> trial;
    WideState records;
    for (int c = 0; c < batch.count; c += chunks_at_once) {
      for (int k = 0; k < chunks_at_once; ++k) {
        int const own = std::min(c + k, batch.count - 1);  // in place of a chunk that is not there, the last one again
        put(trial, k, trial_strain(strain(batch, batch.chunk(own)), dt_gradient[own]).entries);
        put(records.values, k, state(batch.chunk(own)).values);
      }
      WideStrain after;
      if constexpr (chunks_at_once == 1)
        after = law_.project(WideStrain{trial}, records, Wide(dt));
      else
        after = mapped({trial}, records, dt);
      for (int k = 0; k < chunks_at_once && c + k < batch.count; ++k) {
        int const own = c + k;
        Strain const eps{get(after.entries, k)};
        State const state{get(records.values, k)};
        if (work != nullptr) account(batch, own, dt_gradient[own], {get(trial, k)}, {eps.entries}, sum);
        write(batch, own, eps, state);
        if (loads != nullptr) loads[own] = load_of(batch, batch.chunk(own), eps, state, friction);
      }
    }
    if (!(motion.gradient * dt < 0.99) || !finite(batch)) [[unlikely]]  // 1, less what rounding may hide
      look_for_lost(batch, dt_gradient, motion);
    if (work != nullptr) *work += {sum_of(sum.power), sum_of(sum.before), sum_of(sum.trial), sum_of(sum.after)};
  }

  [[nodiscard]] double elastic_energy(Batch<D> const& batch) const override {
    double sum = 0;
    for (int c = 0; c < batch.count; ++c) {
      Lanes const* chunk = batch.chunk(c);
      Lanes const energy = law_.energy(strain(batch, chunk)) * chunk[batch.at.mass];
      for (int lane = 0; lane < batch.filled(c); ++lane) sum += energy[lane] / this->density;
    }
    return sum;
  }

  [[nodiscard]] double volumetric_modulus() const override { return law_.template volumetric_modulus<Shape>(); }
  [[nodiscard]] double stiffest_modulus() const override { return law_.stiffest_modulus(D); }
  [[nodiscard]] double wave_modulus() const override { return law_.wave_modulus(); }
  [[nodiscard]] bool has_friction() const override { return HasFriction<Law>; }

  [[nodiscard]] std::vector<FieldInfo> derived() const override {
    std::vector<FieldInfo> infos{info_of<field::Pressure>(), info_of<field::ShearStress>(),
                                 info_of<field::VolumeRatio>()};
    [&]<Field... F>(Fields<F...>) {
      (infos.push_back(info_of<F>()), ...);
    }
    (typename Law::Derived{});
    return infos;
  }

  void derive(Batch<D> const& batch, int c, std::vector<Lanes>& values) const override {
    Lanes const* chunk = batch.chunk(c);
    Strain const eps = strain(batch, chunk), tau = law_.stress(eps);
    State const state = this->state(chunk);
    values = {pressure(tau), shear_stress(tau), law_.volume_ratio(eps, state)};
    auto const own = law_.derive(eps, state);
    values.insert(values.end(), own.values.begin(), own.values.end());
  }

 private:
  /// Chunks that a law maps at once. The steps of a search wait for each other; a second chunk fills the gaps.
  static constexpr int chunks_at_once = Law::State::count > 0 ? 2 : 1;
  using Wide = Pack<chunks_at_once * lanes>;
  using WideStrain = Symmetric<Wide, Shape>;
  using WideState = Record<Wide, typename Law::State>;

  template <class P>
  static auto& of_chunk(P& wide, int k) {
    if constexpr (chunks_at_once == 1)
      return wide;
    else
      return k == 0 ? wide.low : wide.high;
  }
  template <std::size_t n>
  static void put(std::array<Wide, n>& wide, int k, std::array<Lanes, n> const& values) {
    for (std::size_t e = 0; e < n; ++e) of_chunk(wide[e], k) = values[e];
  }
  template <std::size_t n>
  static std::array<Lanes, n> get(std::array<Wide, n> const& wide, int k) {
    std::array<Lanes, n> values;
    for (std::size_t e = 0; e < n; ++e) values[e] = of_chunk(wide[e], k);
    return values;
  }
  /// The return map in a function of its own, for whose loops the compiler then has all registers.
  [[gnu::noinline, gnu::flatten]] WideStrain mapped(WideStrain const& trial, WideState& records, double dt) const {
    return law_.project(trial, records, Wide(dt));
  }
  /// Adds the work of chunk c, whose old strain is still stored. Empty lanes have no mass.
  [[gnu::noinline]] void account(Batch<D> const& batch, int c, Matrix<Lanes, D> const& H, Strain const& trial,
                                 Strain const& eps, StrainWork<Lanes>& work) const {
    Lanes const* chunk = batch.chunk(c);
    Strain const old = strain(batch, chunk), tau = law_.stress(old);
    Lanes power(0.0);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) power += tau(i, j) * H(i, j);
    Lanes const volume = chunk[batch.at.mass] * Lanes(1.0 / this->density);
    work += {volume * power, volume * law_.energy(old), volume * law_.energy(trial), volume * law_.energy(eps)};
  }
  void write(Batch<D> const& batch, int c, Strain const& eps, State const& state) const {
    Lanes* chunk = batch.chunk(c);
    for (int k = 0; k < Strain::size; ++k) chunk[batch.at.strain + k] = eps[k];
    for (std::size_t k = 0; k < state_at_.size(); ++k) chunk[state_at_[k]] = state.values[k];
  }
  /// The sum of all that the law has written of a chunk: finite where every entry is.
  Lanes sum_of_state(Batch<D> const& batch, Lanes const* chunk) const {
    Lanes sum(0.0);
    for (int k = 0; k < Strain::size; ++k) sum += chunk[batch.at.strain + k];
    for (int const at : state_at_) sum += chunk[at];
    return sum;
  }
  /// True where all strains and states of a batch are.
  [[gnu::noinline]] bool finite(Batch<D> const& batch) const {
    Lanes sum(0.0);
    for (int c = 0; c < batch.count; ++c) sum += sum_of_state(batch, batch.chunk(c));
    return all(is_finite(sum));
  }
  /// Not needed where |dt L| < 1, which keeps det(I + dt L) positive, and all is finite. A gradient that is no number
  /// shows in the strain: no law hides it, which is one of their contracts.
  [[gnu::noinline]] void look_for_lost(Batch<D> const& batch, Matrix<Lanes, D> const* dt_gradient,
                                       Motion& motion) const {
    for (int c = 0; c < batch.count; ++c) {
      auto const upright = determinant_of_step(dt_gradient[c]) > Lanes(0.0);
      Lanes sum = sum_of_state(batch, batch.chunk(c));
      for (Lanes const& entry : dt_gradient[c].entries) sum += entry;
      auto const finite = is_finite(sum);
      if (!all(upright & finite)) report(batch, c, upright, finite, motion);
    }
  }
  static Strain strain(Batch<D> const& batch, Lanes const* chunk) {
    Strain eps;
    for (int k = 0; k < Strain::size; ++k) eps[k] = chunk[batch.at.strain + k];
    return eps;
  }
  State state(Lanes const* chunk) const {
    State s;
    for (std::size_t k = 0; k < state_at_.size(); ++k) s.values[k] = chunk[state_at_[k]];
    return s;
  }
  /// V_p^0 tau_p, and mu_p where `friction`.
  [[gnu::always_inline]] Load<D> load_of(Batch<D> const& batch, Lanes const* chunk, Strain const& eps,
                                         State const& state, bool friction) const {
    Load<D> load;
    Strain const tau = law_.stress(eps);
    Lanes const volume = chunk[batch.at.mass] * Lanes(1.0 / this->density);
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) load.force(i, j) = volume * tau(i, j);
    if constexpr (HasFriction<Law>)
      if (friction) load.friction = law_.friction(eps, state);
    return load;
  }
  /// det(I + dt L): not positive where the step turns the material inside out.
  static Lanes determinant_of_step(Matrix<Lanes, D> const& H) {
    Lanes const one(1.0);
    if constexpr (D == 2) return (one + H(0, 0)) * (one + H(1, 1)) - H(0, 1) * H(1, 0);
    if constexpr (D == 3)
      return (one + H(0, 0)) * ((one + H(1, 1)) * (one + H(2, 2)) - H(1, 2) * H(2, 1)) -
             H(0, 1) * (H(1, 0) * (one + H(2, 2)) - H(1, 2) * H(2, 0)) +
             H(0, 2) * (H(1, 0) * H(2, 1) - (one + H(1, 1)) * H(2, 0));
  }
  static void report(Batch<D> const& batch, int c, Mask<lanes> upright, Mask<lanes> finite, Motion& motion) {
    for (int lane = 0; lane < batch.filled(c); ++lane) {
      auto const id = static_cast<long>(batch.chunk(c)[batch.at.identity][lane]);
      if (!finite[lane])
        motion.fail(id, Motion::Cause::not_finite);
      else if (!upright[lane])
        motion.fail(id, Motion::Cause::inverted);
    }
  }

  Law law_;
  std::array<int, Law::State::count> state_at_{};
};

}  // namespace talus
