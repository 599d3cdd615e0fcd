/// The inertial numbers between which incompressible mu(I) flow is well posed.

#include <fmt/format.h>

#include "verification/reference/flow/well_posedness.hpp"
#include "verification/suite/agreement.hpp"
#include "verification/suite/cases.hpp"

namespace talus::verification::flow_well_posedness {

namespace {

using namespace reference::flow;

void window(Findings& findings, std::string const& name, Fluid const& fluid) {
  auto const found = well_posed_window(fluid), expected = well_posed_window_by_polynomial(fluid);
  agree(findings, name, "lower end by Brent's method from the polynomial's root", apart(found.first, expected.first),
        1e-9);
  agree(findings, name, "upper end by Brent's method from the polynomial's root", apart(found.second, expected.second),
        1e-9);
  findings.note(name, "lower end", found.first);
  findings.note(name, "upper end", found.second);
}

void run(Findings& findings) {
  Fluid published = glass_beads(40, 0);
  published.friction.mu_1 = 0.342, published.friction.mu_2 = 0.557, published.friction.I_0 = 0.069;
  window(findings, "mu 0.342 to 0.557, I_0 = 0.069", published);
  findings.check("mu 0.342 to 0.557, I_0 = 0.069", "lower end", well_posed_window(published).first,
                 {0.003965, 0.003975}, "0.00397, as published");
  Plot plot{"Where mu(I) is well posed: C < 0", "I [1]", "C [1]", true, false, {}};
  for (double const limit : {32.76, 40.0})
    for (double const beta : {0.0, 0.1}) {
      Fluid const fluid = glass_beads(limit, beta);
      std::string const name = fmt::format("beads to {} degrees, beta {}", limit, beta);
      window(findings, name, fluid);
      Curve curve{name, {}, {}, false};
      for (double I = 1e-3; I < 3; I *= 1.15) curve.x.push_back(I), curve.y.push_back(ill_posedness(fluid, I));
      plot.curves.push_back(curve);
    }
  findings.plots.push_back(plot);
}

}  // namespace

Case const the_case{"flow/well_posedness",
                    "Where incompressible mu(I) flow is well posed",
                    "published lower end; roots of a polynomial by GSL",
                    "Barker, Schaeffer, Bohorquez & Gray (2015), doi:10.1017/jfm.2015.412",
                    0,
                    5,
                    run};

}  // namespace talus::verification::flow_well_posedness
