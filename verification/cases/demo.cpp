#include <cmath>

#include "verification/suite/cases.hpp"

namespace talus::verification {

namespace {
void run(Findings& findings) {
  Curve error{"quadratic, apic"}, guide{"order 2", {}, {}, true};
  for (double n = 16; n <= 128; n *= 2) {
    error.x.push_back(1 / n);
    error.y.push_back(3 / (n * n) * (1 + 0.1 * std::sin(n)));
    guide.x.push_back(1 / n);
    guide.y.push_back(2 / (n * n));
  }
  findings.check("quadratic, apic", "order of u", 1.98, at_least(1.85), "lumped mass: 2").uncertainty = {1.9, 2.05};
  findings.check("quadratic, apic", "error of u at h = 1/128", 1e-5, at_most(2e-5), "1.15 of the prototype's");
  findings.note("quadratic, pic", "error of v", 3e-3);
  findings.omit("linear, apic", "all", "the affine inertia of the linear kernel is singular at nodes");
  findings.plots.push_back({"Displacement", "h [m]", "error of u [m]", true, true, {error, guide}});
  findings.work.push_back({"vortex", "u", "quadratic", "apic", 2, 64, 1e-3, {0.3, 100, 1e6}});
}
}  // namespace

Case const demo{"demo", "A demonstration", "nothing", "nobody", 0, 5, run};

}  // namespace talus::verification
