#pragma once

#include <string_view>
#include <tuple>

namespace talus::integrator {

/// Modified update stress last: the moved particles are mapped to the nodes once more, walls act again, and the
/// velocity gradient is taken from there.
///
/// The second mapping smooths the velocity that strains the material: less noise from nodes with little mass. With PIC
/// and APIC, whose particles already hold the smoothed velocity, it smooths twice.
///
/// Source: Sulsky, Zhou & Schreyer (1995), doi:10.1016/0010-4655(94)00170-7 (not re-read); that walls act again is
/// ours.
struct Musl {
  static constexpr std::string_view name = "musl",
                                    title = "Symplectic Euler, velocity mapped back before the stress (MUSL)",
                                    source = "Sulsky, Zhou & Schreyer (1995), doi:10.1016/0010-4655(94)00170-7";
  static constexpr bool remaps = true;
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

}  // namespace talus::integrator
