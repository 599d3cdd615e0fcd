#include "verification/manufactured/drive.hpp"

#include <cmath>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/neo_hookean.hpp"

namespace talus::manufactured {

namespace {

using verification::begin, verification::scene_of, verification::Seed, verification::set_step, verification::take_steps,
    verification::vectors;

template <int D>
using KinematicsOf = std::conditional_t<D == 2, kinematics::PlaneStrainReduced, kinematics::Solid>;

template <int D>
class Force final : public BodyForce<D> {
 public:
  Force(Solution<D> const& solution, std::vector<Point<D>> places)
      : force_(solution.force), places_(std::move(places)) {}
  [[nodiscard]] Point<D> acceleration(long id, double t) const override {
    return force_(places_[static_cast<std::size_t>(id)], t);
  }

 private:
  std::function<Point<D>(Point<D> const&, double)> force_;
  std::vector<Point<D>> places_;
};

template <class Law>
Law law_of(exact::Elastic const& solid) {
  double const nu = 0.5 * solid.lambda / (solid.lambda + solid.G);
  return Law({2 * solid.G * (1 + nu), nu});
}

template <int D, class Law>
Scene<D> scene_with(Solution<D> const& solution, Discretisation<D> const& with) {
  double const nu = 0.5 * solution.solid.lambda / (solution.solid.lambda + solution.solid.G);
  auto scene = scene_of<KinematicsOf<D>, Law>(with.scheme, with.h, solution.solid.density,
                                              {2 * solution.solid.G * (1 + nu), nu});
  scene.periods = with.periods;
  scene.body_force = std::make_unique<Force<D>>(solution, with.places);
  if (with.adds) with.adds(scene);
  set_step(scene, with.dt);
  return scene;
}

template <int D>
Symmetric<double, ShapeOf<D>> exact_strain(MovedPoint<D> const& point) {
  Matrix<double, D> F;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) F(i, j) = point.F(i, j);
  return hencky_strain(F);
}

template <class Strain>
Strain stress_of(exact::Elastic const& solid, Strain const& strain) {
  return solid.law == exact::ElasticLaw::hencky ? law_of<law::Hencky>(solid).stress(strain)
                                                : law_of<law::NeoHookean>(solid).stress(strain);
}

/// Takes whole periods off what the places are away from where they should be.
template <int D>
void unwrap(Point<D>& off, Discretisation<D> const& with) {
  for (int d = 0; d < D; ++d)
    if (int const blocks = with.periods[static_cast<std::size_t>(d)]; blocks > 0)
      off[d] = std::remainder(off[d], blocks * block_edge * with.h);
}

}  // namespace

template <int D>
Driven<D> drive(Solution<D> const& solution, Discretisation<D> const& with) {
  std::vector<Seed<D>> seeds;
  for (Point<D> const& X : with.places) {
    auto const start = solution.at(X, 0), before = solution.at(X, -with.lag * with.dt);
    auto const strain = exact_strain(start);
    seeds.push_back({start.x,
                     before.v,
                     solution.solid.density * with.volume,
                     before.L,
                     {strain.entries.begin(), strain.entries.end()}});
  }
  bool const hencky = solution.solid.law == exact::ElasticLaw::hencky;
  auto const simulation = begin(
      hencky ? scene_with<D, law::Hencky>(solution, with) : scene_with<D, law::NeoHookean>(solution, with), seeds);
  Driven<D> driven;
  std::function<void()> after_each;
  if (with.after_each) after_each = [&] { with.after_each(*simulation); };
  take_steps(*simulation, with.steps, driven.cost, after_each);
  driven.u = vectors(*simulation, "position");
  driven.v = vectors(*simulation, "velocity");
  driven.strain.resize(with.places.size());
  for (int c = 0; c < driven.strain.front().size; ++c) {
    auto const component = verification::column(*simulation, "elastic_strain", c);
    for (std::size_t p = 0; p < component.size(); ++p) driven.strain[p][c] = component[p];
  }
  for (std::size_t p = 0; p < with.places.size(); ++p) {
    Point<D> const& X = with.places[p];
    Point<D> const there = solution.at(X, with.end()).x;
    Point<D> off = driven.u[p] - there;
    unwrap(off, with);
    driven.u[p] = there + off - X;
  }
  return driven;
}

template <int D>
Errors errors_of(Driven<D> const& driven, Solution<D> const& solution, Discretisation<D> const& with,
                 std::function<bool(Point<D> const&)> const& among) {
  std::vector<Point<D>> u, v;
  std::vector<double> strain, stress;
  for (std::size_t p = 0; p < with.places.size(); ++p) {
    Point<D> const& X = with.places[p];
    if (among && !among(X)) continue;
    auto const point = solution.at(X, with.end());
    auto const eps = exact_strain(point);
    u.push_back(X + driven.u[p] - point.x);
    v.push_back(driven.v[p] - solution.at(X, with.end() - with.lag * with.dt).v);
    strain.push_back(norm(driven.strain[p] - eps));
    stress.push_back(norm(stress_of(solution.solid, driven.strain[p]) - stress_of(solution.solid, eps)));
  }
  using verification::root_mean_square;
  return {root_mean_square(u), root_mean_square(v), root_mean_square(strain), root_mean_square(stress), driven.cost};
}

template Driven<2> drive<2>(Solution<2> const&, Discretisation<2> const&);
template Driven<3> drive<3>(Solution<3> const&, Discretisation<3> const&);
template Errors errors_of<2>(Driven<2> const&, Solution<2> const&, Discretisation<2> const&,
                             std::function<bool(Point<2> const&)> const&);
template Errors errors_of<3>(Driven<3> const&, Solution<3> const&, Discretisation<3> const&,
                             std::function<bool(Point<3> const&)> const&);

}  // namespace talus::manufactured
