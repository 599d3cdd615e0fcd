#pragma once
/// One material point, led along a path of motion and stress: the law without a grid.
///
/// The point is a particle as the step has it: the same material, the same update of the strain, the same fields. A
/// step of the path prescribes dt times the velocity gradient L, or asks for the components of L that bring components
/// of the Kirchhoff stress tau to their targets.
///
/// Components are xx, yy, zz, xy, xz, yz. That of L is L_ij with i <= j; L_ij with i > j is zero, so that xy is simple
/// shear along x.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/experiment.hpp"
#include "core/material.hpp"

namespace talus {

inline constexpr std::array<std::string_view, 6> component_names{"xx", "yy", "zz", "xy", "xz", "yz"};
using Components6 = std::array<double, 6>;

/// What leads one component along a segment.
struct Control {
  bool of_stress = false;          ///< tau is prescribed, else L
  double rate = 0;                 ///< L_ij [1/s]
  std::optional<double> target{};  ///< tau_ij at the end of the segment [Pa], linear in time; none: it stays
};

struct Segment {
  std::string name;
  double duration = 0;  ///< [s]
  int steps = 0;
  std::array<Control, 6> controls;
};

/// A material point, whatever its dimension.
class PointExperiment {
 public:
  PointExperiment() = default;
  PointExperiment(PointExperiment const&) = delete;
  virtual ~PointExperiment() = default;

  /// Which components can be led; the others have no motion.
  [[nodiscard]] virtual bool leads(int component) const = 0;
  [[nodiscard]] virtual std::vector<Quantity> quantities() const = 0;
  [[nodiscard]] virtual std::vector<double> measure() const = 0;
  /// Kirchhoff stress [Pa], tension positive.
  [[nodiscard]] virtual Components6 stress() const = 0;
  [[nodiscard]] virtual double time() const = 0;
  /// One step to the time `until` [s]: `motion` is dt L where it is prescribed; `targets` the stress at the end where
  /// that is. Throws RunError where no motion gives the stress, or where the state is lost.
  virtual void step(Components6 const& motion, std::array<std::optional<double>, 6> const& targets, double until) = 0;
};

/// Leads a point along one segment and calls record() after every step.
template <class F>
void follow(PointExperiment& point, Segment const& segment, F&& record) {
  Components6 const begin = point.stress();
  double const start = point.time(), dt = segment.duration / segment.steps;
  for (int n = 1; n <= segment.steps; ++n) {
    Components6 motion{};
    std::array<std::optional<double>, 6> targets;
    for (std::size_t c = 0; c < 6; ++c) {
      Control const& control = segment.controls[c];
      motion[c] = control.rate * dt;
      if (control.of_stress) targets[c] = begin[c] + (control.target.value_or(begin[c]) - begin[c]) * n / segment.steps;
    }
    point.step(motion, targets, start + segment.duration * n / segment.steps);
    record();
  }
}

template <int D>
class MaterialPoint final : public PointExperiment {
 public:
  /// strain_size: numbers of the kinematics' strain.
  MaterialPoint(std::unique_ptr<Material<D>> material, int strain_size);

  [[nodiscard]] bool leads(int component) const override;
  [[nodiscard]] std::vector<Quantity> quantities() const override;
  [[nodiscard]] std::vector<double> measure() const override;
  [[nodiscard]] Components6 stress() const override { return stress_; }
  [[nodiscard]] double time() const override { return time_; }
  void step(Components6 const& motion, std::array<std::optional<double>, 6> const& targets, double until) override;

 private:
  using Chunk = std::vector<Lanes>;
  /// A batch of one chunk, whose lanes are alternatives of the one particle.
  [[nodiscard]] Batch<D> batch(Chunk& chunk) const;
  /// Stress after each of at most `lanes` motions; `chunk` has the states after them.
  std::vector<Components6> after(std::span<Components6 const> motions, double dt, Chunk& chunk) const;
  [[nodiscard]] Components6 solve(Components6 motion, std::vector<std::size_t> const& free,
                                  std::array<std::optional<double>, 6> const& targets, double dt);
  void commit(Components6 const& motion, double dt);

  std::unique_ptr<Material<D>> material_;
  Layout layout_;
  FieldOffsets places_;
  bool across_;  ///< there is a stress across the plane
  mutable Chunk chunk_;
  Components6 stress_{}, strain_{}, last_motion_{};
  double time_ = 0, work_ = 0, last_dt_ = 0;
  int iterations_ = 0;
};

}  // namespace talus
