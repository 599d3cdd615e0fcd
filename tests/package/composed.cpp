/// Somebody else's program, as in the README: composes a solver of the installed Talus and lets a block of sand fall.

#include <cmath>
#include <cstdio>

#include "core/formulation.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/catalogue.hpp"

using namespace talus;

struct Sand {
  using Kinematics = kinematics::PlaneStrain;
  using Kernel = kernel::Quadratic;
  using Transfer = transfer::Apic;
  using Integrator = integrator::Usl;
  using Law = law::DruckerPrager;
};

int main() {
  body::Box::In<2> const block({.min = {0, 0}, .max = {0.2, 0.1}});
  auto const seeds = body::seed(block, body::Lattice({.per_axis = 2}), 0.01);
  auto const simulation = compose<Sand>({.spacing = 0.01, .density = 1550, .gravity = {0, -9.81}}, seeds);
  while (simulation->time() < 0.1) simulation->advance(0.1);
  std::printf("%zu particles after %ld steps\n", simulation->particles().count(), simulation->step_count());
  // Nothing but gravity acts: momentum is mass x g x t, the mass is 1550 x 0.02.
  double const fallen = simulation->momentum().gravity[1];
  return std::abs(fallen + 1550 * 0.02 * 9.81 * 0.1) < 1e-9 ? 0 : 1;
}
