#include <algorithm>
#include <cmath>
#include <set>

#include "core/mirror.hpp"
#include "models/compose.hpp"
#include "models/make.hpp"
#include "models/walls.hpp"

namespace talus {

namespace {

using Mistakes = std::vector<std::string>;

std::string at(std::string const& list, std::size_t k, std::string const& member) {
  return "/" + list + "/" + std::to_string(k) + "/" + member;
}

void check_schema(Case const& document, Mistakes& wrong) {
  if (document.schema != Case::tag)
    wrong.push_back("/schema: found '" + document.schema + "'; this program reads " + std::string(Case::tag));
}

void check_periods(Case const& document, int D, Mistakes& wrong) {
  auto const& periods = document.grid.periods;
  if (periods.empty()) return;
  if (periods.size() != static_cast<std::size_t>(D)) {
    wrong.push_back("/grid/periods: found " + std::to_string(periods.size()) + " numbers; one for each of the " +
                    std::to_string(D) + " axes is needed");
    return;
  }
  double const block = block_edge * document.grid.spacing;
  for (std::size_t d = 0; d < periods.size(); ++d) {
    double const blocks = periods[d] / block;
    if (blocks > farthest_block)
      wrong.push_back("/grid/periods/" + std::to_string(d) + ": longer than the space that can be addressed, " +
                      std::to_string(farthest_block * block) + " m; take a shorter period or a coarser grid");
    else if (std::abs(blocks - std::round(blocks)) > 1e-9 * std::max(1.0, blocks))
      wrong.push_back("/grid/periods/" + std::to_string(d) + ": " + std::to_string(periods[d]) +
                      " m is no multiple of four cells (" + std::to_string(block) + " m); the nearest are " +
                      std::to_string(std::floor(blocks) * block) + " and " + std::to_string(std::ceil(blocks) * block));
  }
}

/// Names stand in the headers of tables: no comma, quote or control character.
bool is_a_name(std::string_view name) {
  return !name.empty() && std::ranges::none_of(name, [](char c) {
    auto const byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7f || c == ',' || c == '"';
  });
}

template <class List>
void check_names(List const& list, std::string const& where, Mistakes& wrong) {
  std::set<std::string> seen;
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!is_a_name(list[k].name))
      wrong.push_back(at(where, k, "name") + ": '" + list[k].name +
                      "' is no name; it needs a character at least, and no comma, quote or control character");
    if (!seen.insert(list[k].name).second)
      wrong.push_back(at(where, k, "name") + ": '" + list[k].name + "' is used twice; every name must be its own");
  }
}

void check_bodies(Case const& document, int D, Mistakes& wrong) {
  for (std::size_t k = 0; k < document.bodies.size(); ++k) {
    BodyEntry const& body = document.bodies[k];
    bool known = false;
    std::string names;
    for (MaterialEntry const& m : document.materials) {
      known = known || m.name == body.material;
      names += (names.empty() ? "" : ", ") + m.name;
    }
    if (!known)
      wrong.push_back(at("bodies", k, "material") + ": '" + body.material + "' is no material; there are: " + names);
    body.shape.visit([&]<class S>(std::type_identity<S>, auto const&) {
      if (!S::supports(D))
        wrong.push_back(at("bodies", k, "shape") + ": a " + std::string(S::name) + " is not for " + std::to_string(D) +
                        " dimensions");
    });
  }
}

/// The planes that mirror, each with the number of its wall.
using MirrorPlanes = std::vector<std::pair<MirrorPlane, std::size_t>>;

/// A mirror is flat, across an axis, on a row of nodes, and the only one there.
template <int D>
void check_mirror(Case const& document, std::size_t k, MirrorPlanes& planes, Mistakes& wrong) {
  WallEntry const& entry = document.walls[k];
  if (!contact_of(entry).mirrors) return;
  if (!entry.shape.holds<wall::HalfSpace>()) {
    wrong.push_back(at("walls", k, "contact") + ": only a half_space can mirror; found '" +
                    std::string(entry.shape.name()) + "'; take stick or slip");
    return;
  }
  try {
    auto const wall = wall_of<D>(entry);
    MirrorPlane const plane = mirror_plane<D>(*wall, document.grid.spacing);
    for (auto const& [other, number] : planes)
      if (other.axis == plane.axis && other.row == plane.row)
        wrong.push_back(at("walls", k, "shape") + ": '" + document.walls[number].name +
                        "' mirrors at the same plane; take one of the two out");
    planes.emplace_back(plane, k);
    int const axis = plane.axis;
    auto const& periods = document.grid.periods;
    if (static_cast<std::size_t>(axis) < periods.size() && periods[static_cast<std::size_t>(axis)] > 0)
      wrong.push_back(at("walls", k, "contact") +
                      ": a wall across an axis that repeats has no space behind it for images; take stick or slip, or "
                      "set the period to 0");
  } catch (InputError const& error) {
    wrong.push_back(at("walls", k, "shape") + ": " + error.what());
  }
}

void check_walls(Case const& document, int D, Mistakes& wrong) {
  if (document.walls.size() > most_walls)
    wrong.push_back("/walls: found " + std::to_string(document.walls.size()) + " walls; at most " +
                    std::to_string(most_walls) + " are allowed: join some into a polyline or a container");
  MirrorPlanes planes;
  for (std::size_t k = 0; k < document.walls.size(); ++k) {
    WallEntry const& entry = document.walls[k];
    entry.shape.visit([&]<class S>(std::type_identity<S>, auto const&) {
      if (!S::supports(D))
        wrong.push_back(at("walls", k, "shape") + ": a " + std::string(S::name) + " is not for " + std::to_string(D) +
                        " dimensions");
    });
    D == 2 ? check_mirror<2>(document, k, planes, wrong) : check_mirror<3>(document, k, planes, wrong);
    if (!entry.contact.holds<wall::MaterialFriction>()) continue;
    for (MaterialEntry const& m : document.materials)
      if (!m.law->has_friction())
        wrong.push_back(at("walls", k, "contact") + ": the law '" + std::string(m.law.name()) + "' of material '" +
                        m.name + "' has no friction that a wall could take");
  }
}

void check_transfer(Case const& document, Mistakes& wrong) {
  document.kernel.visit([&]<class K>(std::type_identity<K>, auto const&) {
    document.transfer.visit([&]<class T>(std::type_identity<T>, auto const&) {
      if (!fit_together<K, T>)
        wrong.push_back("/transfer/type: '" + std::string(T::name) + "' cannot be used with the " +
                        std::string(K::name) + " kernel, whose affine inertia is singular at nodes; take pic or flip");
    });
  });
}

void check_measures(Case const& document, int D, Mistakes& wrong) {
  std::vector<std::string> walls;
  for (WallEntry const& entry : document.walls) walls.push_back(entry.name);
  auto const known =
      series_quantities(D, walls, document.output.ledger.holds<ledger::EachStep>(), stations_of(document));
  std::string names;
  for (Quantity const& q : known) names += (names.empty() ? "" : ", ") + q.name;
  for (std::size_t k = 0; k < document.expect.size(); ++k)
    if (std::none_of(known.begin(), known.end(),
                     [&](Quantity const& q) { return q.name == document.expect[k].measure; }))
      wrong.push_back(at("expect", k, "measure") + ": '" + document.expect[k].measure +
                      "' is no measure of this case; there are: " + names);
}

}  // namespace

int dimension_of_kinematics(std::string_view name) {
  int D = 0;
  for_each_type(catalogue::Kinematics{}, [&]<class K>(std::type_identity<K>) {
    if (K::name == name) D = K::dimension;
  });
  return D;
}

std::vector<std::string> inconsistencies(Case const& document) {
  Mistakes wrong;
  int const D = dimension_of_kinematics(document.kinematics.name());
  check_schema(document, wrong);
  check_periods(document, D, wrong);
  check_transfer(document, wrong);
  check_names(document.materials, "materials", wrong);
  check_names(document.bodies, "bodies", wrong);
  check_names(document.walls, "walls", wrong);
  check_bodies(document, D, wrong);
  check_walls(document, D, wrong);
  check_gaps(document, D, wrong);
  check_stations(document, D, wrong);
  check_measures(document, D, wrong);
  return wrong;
}

}  // namespace talus
