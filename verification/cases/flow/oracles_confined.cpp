/// Steady flows between walls: the reference solutions against each other, as in oracles_steady.

#include <fmt/format.h>

#include "verification/reference/flow/confined.hpp"
#include "verification/suite/agreement.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::flow_oracles_confined {

namespace {

using namespace reference::flow;

constexpr double bar = 1e-9;

/// The speed over the whole of what flows, in three ways, from the closed form.
template <class Exact>
void check(Findings& findings, std::string const& name, ShearFlow const& flow, Exact const& exact) {
  auto const all = places(flow.from, flow.to, 9);
  auto const row = [&](char const* way, double (*speed)(ShearFlow const&, double)) {
    agree(findings, name, fmt::format("u by {} from closed form", way),
          apart([&](double x) { return speed(flow, x); }, exact, all), bar);
  };
  row("quadrature", speed_by_quadrature);
  row("CVODE", speed_by_cvode);
  row("KINSOL", speed_by_kinsol);
  findings.plots.push_back({name,
                            "u [m/s], u/r [1/s]",
                            "place [m]",
                            false,
                            false,
                            {profile("closed form", exact, places(flow.from, flow.to, 41), true),
                             profile(
                                 "KINSOL", [&](double x) { return speed_by_kinsol(flow, x); }, all, false)}});
}

/// The plate's speed is known in closed form, the bed's is not.
void plate(Findings& findings, double beta, double speed) {
  PlateOnBed const bed{glass_beads(40, beta), 200};
  std::string const name = fmt::format("plate on a bed, {} m/s, beta {}", speed, beta);
  double const T = bed.shear_stress(speed);
  agree(findings, name, "T by quadrature from closed form", apart(bed.shear_stress_by_quadrature(speed), T), bar);
  agree(findings, name, "speed by CVODE from the one asked for", apart(speed_by_cvode(bed.flow(T), 0), speed), bar);
  agree(findings, name, "speed by KINSOL from the one asked for", apart(speed_by_kinsol(bed.flow(T), 0), speed), bar);
}

void run(Findings& findings) {
  for (double const beta : {0.0, 0.2}) {
    Fluid const fluid = glass_beads(40, beta);
    std::string const with = fmt::format(", beta {}", beta);
    for (double const speed : {0.01, 0.5, 5.0}) {
      PlaneShear const shear{fluid, 200, speed, 0.03};
      agree(findings, fmt::format("plane shear, {} m/s", speed) + with, "q by root from closed form",
            apart(shear.shear_stress_by_root(), shear.shear_stress()), bar);
    }
    plate(findings, beta, 0.02);
    plate(findings, beta, 0.1);
    double const wall = 0.5 * (fluid.friction.mu_1 + fluid.friction.mu_2) * fluid.omega();  // q/p there
    VerticalChute const chute{fluid, fluid.density * gravity * 0.02 / wall, 0.02};
    check(findings, "vertical chute" + with, chute.flow(), [&](double x) { return chute.speed(x); });
    AnnularCouette const couette{fluid, 200, 0.05};
    double const s_i = couette.wall_ratio(5);
    check(findings, "annular Couette" + with, couette.flow(s_i),
          [&](double r) { return couette.angular_speed(s_i, r); });
    ChannelFlow const channel{fluid, radians(beta > 0 ? 32 : 30), 0.01, 0.45};
    check(findings, "channel" + with, channel.flow(), [&](double z) { return channel.speed(z); });
  }
}

}  // namespace

Case const the_case{
    "flow/oracles_confined",
    "Reference solutions of flows between walls against each other",
    "closed form, quadrature by GSL, CVODE, KINSOL",
    "GDR MiDi (2004), doi:10.1140/epje/i2003-10153-0; Taberlet et al. (2003), doi:10.1103/PhysRevLett.91.264301; Jop, "
    "Forterre & Pouliquen (2005), doi:10.1017/S0022112005005987; closed forms derived",
    0,
    10,
    run};

}  // namespace talus::verification::flow_oracles_confined
