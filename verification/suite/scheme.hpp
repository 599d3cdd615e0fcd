#pragma once
/// A scheme by name: kernel, transfer, integrator.

#include <memory>
#include <string>
#include <vector>

#include "core/stages.hpp"

namespace talus::verification {

/// alpha: share of the increment in FLIP and AFLIP.
struct Scheme {
  std::string kernel = "quadratic", transfer = "apic", integrator = "usl";
  double alpha = 1;

  /// "apic"; alpha where it is not 1.
  [[nodiscard]] std::string transfer_name() const;
  /// "quadratic, apic"; alpha where it is not 1, the integrator where it is not usl.
  [[nodiscard]] std::string name() const;
  /// Degree of the kernel: 1, 2, 3.
  [[nodiscard]] int degree() const;
  /// Whether the transfer keeps an affine velocity.
  [[nodiscard]] bool affine() const;
};

/// All that fit together: {linear, quadratic, cubic} x {pic, flip, apic, aflip} but linear with the affine ones.
[[nodiscard]] std::vector<Scheme> all_schemes(std::string const& integrator = "usl", double alpha = 1);

/// The stages of a scheme. rubs: a wall takes its friction from the material. Throws InputError where the names fit no
/// policies, or not together.
template <int D>
[[nodiscard]] std::unique_ptr<Stages<D>> stages_of(Scheme const& scheme, bool rubs = false);

}  // namespace talus::verification
