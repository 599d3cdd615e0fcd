#include "models/compose.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "core/body.hpp"
#include "core/experiment_of.hpp"
#include "core/filling.hpp"
#include "core/in_short.hpp"
#include "models/make.hpp"
#include "models/walls.hpp"

namespace talus {

namespace {

/// Runs f and puts the pointer of the document before what it refuses.
template <class F>
auto located(std::string const& pointer, F const& f) {
  try {
    return f();
  } catch (InputError const& error) {
    throw InputError(pointer + ": " + error.what());
  }
}

/// Slope in degrees: the first axis points down the slope.
template <int D>
Point<D> gravity_of(GravityEntry const& entry) {
  double const theta = entry.slope_deg * std::numbers::pi / 180;
  Point<D> g = Point<D>::Zero();
  g[0] = entry.magnitude * std::sin(theta);
  g[1] = -entry.magnitude * std::cos(theta);
  return g;
}

template <int D>
std::unique_ptr<Stages<D>> stages_of(Case const& document) {
  bool rubs = false;
  for (WallEntry const& entry : document.walls) rubs = rubs || entry.contact.holds<wall::MaterialFriction>();
  std::unique_ptr<Stages<D>> stages;
  document.kernel.visit([&]<class K>(std::type_identity<K>, auto const&) {
    document.transfer.visit([&]<class T>(std::type_identity<T>, auto const& parameters) {
      document.integrator.visit([&]<class I>(std::type_identity<I>, auto const&) {
        if constexpr (fit_together<K, T>) stages = make_stages<D, K, T, I>(parameters, rubs);
      });
    });
  });
  return stages;
}

template <int D>
std::vector<std::unique_ptr<Wall<D>>> walls_of(Case const& document) {
  std::vector<std::unique_ptr<Wall<D>>> walls;
  for (std::size_t k = 0; k < document.walls.size(); ++k)
    if (auto wall = located("/walls/" + std::to_string(k), [&] { return wall_of<D>(document.walls[k]); }))
      walls.push_back(std::move(wall));
  return walls;
}

template <int D>
Filling<D> filling_of(BodyEntry const& entry, Case const& document) {
  Filling<D> filling;
  entry.shape.visit([&]<class S>(std::type_identity<S>, auto const& shape) {
    entry.seeding.visit([&]<class P>(std::type_identity<P>, auto const& seeding) {
      if constexpr (S::supports(D))
        filling.seeds = body::seed(typename S::template In<D>(shape), P(seeding), document.grid.spacing);
    });
  });
  entry.velocity.visit([&]<class V>(std::type_identity<V>, auto const& parameters) {
    typename V::template In<D> const motion(parameters);
    for (Point<D> const& x : filling.seeds.points) {
      filling.velocities.push_back(motion.velocity(x));
      filling.gradients.push_back(motion.gradient(x));
    }
  });
  for (std::size_t m = 0; m < document.materials.size(); ++m)
    if (document.materials[m].name == entry.material) {
      filling.material = static_cast<std::int32_t>(m);
      filling.density = document.materials[m].density;
    }
  return filling;
}

/// Warns of particles that begin inside a wall.
template <int D>
void find_buried(std::string const& body, Filling<D> const& filling, Scene<D> const& scene,
                 std::vector<std::string>& warnings) {
  std::array<Surface<D>, Wall<D>::max_surfaces> faces;
  for (auto const& wall : scene.walls) {
    auto const is_inside = [&](Point<D> const& x) {
      auto const count = static_cast<std::size_t>(wall->surfaces(x, 0, faces));
      return std::ranges::any_of(std::span(faces).first(count),
                                 [&](Surface<D> const& s) { return s.distance < -1e-9 * scene.spacing; });
    };
    auto const buried = std::ranges::count_if(filling.seeds.points, is_inside);
    if (buried > 0)
      warnings.push_back(body + ": " + std::to_string(buried) + " of its " +
                         std::to_string(filling.seeds.points.size()) + " particles begin inside the wall '" +
                         wall->name + "', which will push them out");
  }
}

/// Warns of runs that take long.
void foretell_steps(double steps, std::vector<std::string>& warnings) {
  if (steps > 1e8) warnings.push_back("/time/end: the run takes about " + in_short(steps) + " steps");
}

std::vector<Explanation::Line> policies_of(Case const& document) {
  std::vector<Explanation::Line> lines;
  auto const add = [&](std::string const& kind, auto const& choice) {
    choice.visit([&]<class P>(std::type_identity<P>, auto const&) {
      lines.push_back({kind, std::string(P::name) + ": " + std::string(P::title)});
    });
  };
  add("kinematics", document.kinematics);
  add("kernel", document.kernel);
  add("transfer", document.transfer);
  add("integrator", document.integrator);
  for (MaterialEntry const& m : document.materials)
    lines.push_back({"law of " + m.name, std::string(m.law->name()) + ": " + std::string(m.law->title())});
  for (BodyEntry const& b : document.bodies) {
    add("shape of " + b.name, b.shape);
    add("seeding of " + b.name, b.seeding);
    add("velocity of " + b.name, b.velocity);
  }
  for (WallEntry const& w : document.walls) {
    add("shape of " + w.name, w.shape);
    add("contact of " + w.name, w.contact);
    add("motion of " + w.name, w.motion);
  }
  for (Station const& s : stations_of(document))
    lines.push_back({"station " + s.name, "flow along " + std::string(axis_names[s.flow]) + ", depth along " +
                                              std::string(axis_names[s.depth]) + ", " + std::to_string(s.bins) +
                                              " bins, at output times alone"});
  return lines;
}

template <class K>
std::unique_ptr<Experiment> compose_in(Case const& document, std::vector<std::string>& warnings) {
  constexpr int D = K::dimension;
  Scene<D> scene;
  scene.spacing = document.grid.spacing;
  for (std::size_t d = 0; d < document.grid.periods.size(); ++d)
    scene.periods[d] =
        static_cast<std::int32_t>(std::lround(document.grid.periods[d] / (block_edge * document.grid.spacing)));
  scene.gravity = gravity_of<D>(document.gravity);
  scene.limits = {document.time.safety, document.time.crossing, document.time.gradient};
  scene.strain_size = Symmetric<double, typename K::Shape>::size;
  for (MaterialEntry const& m : document.materials)
    scene.materials.push_back(std::get<std::unique_ptr<Material<D>>>(m.law->material(K::name, m.name, m.density)));
  scene.walls = walls_of<D>(document);
  scene.keeps_ledger = document.output.ledger.holds<ledger::EachStep>();
  scene.stages = stages_of<D>(document);
  std::vector<Filling<D>> fillings;
  for (std::size_t k = 0; k < document.bodies.size(); ++k) {
    std::string const body = "/bodies/" + std::to_string(k);
    fillings.push_back(located(body, [&] { return filling_of<D>(document.bodies[k], document); }));
    find_buried(body, fillings.back(), scene, warnings);
  }
  auto simulation = std::make_unique<Simulation<D>>(std::move(scene));
  fill(*simulation, fillings);
  foretell_steps(document.time.end / simulation->next(document.time.end).dt, warnings);
  return std::make_unique<ExperimentOf<D>>(std::move(simulation), policies_of(document), stations_of(document));
}

}  // namespace

std::unique_ptr<Experiment> compose(Case const& document, std::vector<std::string>& warnings) {
  std::unique_ptr<Experiment> experiment;
  document.kinematics.visit(
      [&]<class K>(std::type_identity<K>, auto const&) { experiment = compose_in<K>(document, warnings); });
  return experiment;
}

}  // namespace talus
