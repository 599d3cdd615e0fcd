/// A block rests in a box with frictionless walls: sigma_yy = -rho g (H - y), and the floor bears the weight.
///
/// The particles begin with the strain of that stress, where they are, and settle. The lattice is then almost the
/// commensurate one. Next to walls the stress is off, for kernels reach beyond them, where there are no particles; away
/// from them its noise is less than the error of quadrature of a lattice at the worst offset, eps_q = 1/(2 n^2) (degree 2), 1/(8 n^3) (degree 3) with n particles a
/// cell along an axis.

#include <fmt/format.h>

#include <cmath>

#include "models/boundaries/contacts/slip.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/laws/hencky.hpp"
#include "verification/suite/cases.hpp"
#include "verification/suite/settle.hpp"

namespace talus::verification::elastic_hydrostatic {

namespace {

constexpr double H = 1, width = 0.5, density = 1000, g = 9.81, E = 1e7, nu = 0.3;
constexpr double lambda = E * nu / ((1 + nu) * (1 - 2 * nu)), G = E / (2 * (1 + nu));
constexpr int N = 16;

std::unique_ptr<Simulation<2>> begun(Scheme const& scheme, int n) {
  double const h = H / N;
  Scene<2> scene = scene_of<kinematics::PlaneStrain, law::Hencky>(scheme, h, density, {E, nu});
  scene.gravity = {0, -g};
  wall::HalfSpace::Parameters floor, left, right;
  floor.normal = {0, 1};
  left.normal = {1, 0};
  right.point = {width, 0};
  right.normal = {-1, 0};
  for (auto const& [name, shape] : {std::pair{"floor", floor}, std::pair{"left", left}, std::pair{"right", right}})
    scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::Slip, wall::Fixed>(name, shape, {}, {}));
  set_step(scene, 0.2 * h / std::sqrt((lambda + 2 * G) / density));
  std::vector<Seed<2>> seeds;
  for (auto const& x : lattice<2>({0, 0}, {N / 2, N}, {n, n}, h)) {
    Seed<2> seed;
    seed.x = x;
    seed.mass = density * h * h / (n * n);
    seed.strain = {0, -density * g * (H - x[1]) / (lambda + 2 * G), 0, 0};
    seeds.push_back(seed);
  }
  return begin(std::move(scene), seeds);
}

void rest(Findings& findings, Scheme const& scheme, int n) {
  auto const simulation = begun(scheme, n);
  Cost cost;
  settle(*simulation, 4000, cost);
  double const weight = density * H * width * g, before = simulation->time(),
               borne = simulation->momentum().walls[0][1];
  take_steps(*simulation, 1600, cost);  // twenty times that a wave takes up and down
  double const floor = (simulation->momentum().walls[0][1] - borne) / (weight * (simulation->time() - before));
  auto const xx = column(*simulation, "elastic_strain", 0), yy = column(*simulation, "elastic_strain", 1),
             x = column(*simulation, "position"), y = column(*simulation, "position", 1);
  std::vector<double> off, inside;
  for (std::size_t p = 0; p < y.size(); ++p) {
    off.push_back((lambda * (xx[p] + yy[p]) + 2 * G * yy[p]) / (density * g * H) + (H - y[p]) / H);
    if (y[p] > 4 * H / N && std::abs(x[p] - width / 2) < width / 2 - 3 * H / N) inside.push_back(off.back());
  }
  double const quadrature = scheme.degree() == 2 ? 0.5 / (n * n) : 0.125 / (n * n * n);
  std::string const subject = scheme.name() + ", " + std::to_string(n) + " a cell and axis";
  findings.note(
      subject, "noise of stress over rho g H", root_mean_square(off),
      fmt::format("not asked to be below eps_q = {:.2g}: next to floor and sides, first nodes feel the stress of "
                  "the material and no counterpart from beyond the wall",
                  quadrature));
  if (n == 2)
    findings.check(subject, "that, away from floor and sides", root_mean_square(inside), at_most(quadrature),
                   "eps_q of the worst lattice");
  else
    findings.note(subject, "that, away from floor and sides", root_mean_square(inside),
                  "as with fewer particles: still the walls'");
  findings.check(subject, "force on the floor over the weight", floor, about(1, 1e-3), "equilibrium", cost);
}

void run(Findings& findings) {
  for (Scheme const& scheme : all_schemes())
    for (int const n : {2, 4})
      if (scheme.degree() > 1 && (n == 2 || scheme.transfer == "aflip")) rest(findings, scheme, n);
}

}  // namespace

Case const the_case{"elastic/hydrostatic",
                    "A block rests in a box with frictionless walls",
                    "the static balance",
                    "textbook; eps_q: derived, sum of V N' on a lattice",
                    1,
                    40,
                    run};

}  // namespace talus::verification::elastic_hydrostatic
