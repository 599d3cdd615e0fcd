#include <array>
#include <sstream>

#include "models/boundaries/extent.hpp"
#include "models/compose.hpp"

namespace talus {

namespace {

/// Where the values of real materials lie [unit]: a value far outside is allowed, but often is in another unit.
struct Usual {
  std::string_view pointer, unit;
  double low, high;
};
constexpr std::array usual{
    Usual{"/density", " kg/m^3", 10, 3e4},
    Usual{"/law/young_modulus", " Pa", 10, 1e13},
    Usual{"/law/M", "", 0, 3},
    Usual{"/law/mu_1", "", 0, 3},
    Usual{"/law/mu_2", "", 0, 3},
    Usual{"/law/grain_diameter", " m", 1e-7, 0.1},
    Usual{"/law/grain_density", " kg/m^3", 10, 3e4},
};

std::string in_short(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

void suspect_materials(Document const& document, std::string const& base, std::size_t count, Reader& reader) {
  for (std::size_t k = 0; k < count; ++k)
    for (Usual const& u : usual) {
      std::string const pointer = base + "/materials/" + std::to_string(k) + std::string(u.pointer);
      nlohmann::json::json_pointer const at(pointer);
      if (!document.value.contains(at) || !document.value[at].is_number()) continue;
      double const value = document.value[at];
      if (value < u.low || value > u.high)
        reader.warn(pointer, in_short(value) + std::string(u.unit),
                    in_short(u.low) + " to " + in_short(u.high) + std::string(u.unit) + ", as of real materials",
                    "is the unit right?");
    }
}

void suspect_walls(Case const& document, std::string const& base, Reader& reader) {
  double const least = 3 * document.grid.spacing;
  for (std::size_t k = 0; k < document.walls.size(); ++k)
    document.walls[k].shape.visit([&]<class S>(std::type_identity<S>, auto const& shape) {
      if constexpr (std::is_same_v<typename S::Parameters, wall::Extent>)
        for (std::size_t axis = 0; axis < shape.min.size(); ++axis)
          if (double const extent = shape.max[axis] - shape.min[axis]; extent < least)
            reader.warn(base + "/walls/" + std::to_string(k) + "/shape", "an extent of " + in_short(extent) + " m",
                        "at least " + in_short(least) + " m, the reach of a particle",
                        "particles on both sides of it share nodes; take a finer grid");
    });
}

void suspect_bodies(Case const& document, std::string const& base, Reader& reader) {
  for (std::size_t k = 0; k < document.bodies.size(); ++k)
    document.bodies[k].seeding.visit([&]<class S>(std::type_identity<S>, auto const& seeding) {
      bool one = false;
      if constexpr (requires { seeding.per_axis; }) one = seeding.per_axis == 1;
      if constexpr (requires { seeding.per_cell; }) one = seeding.per_cell == 1;
      if (one)
        reader.warn(base + "/bodies/" + std::to_string(k) + "/seeding", "one particle a cell", "four or more",
                    "stress is integrated too coarsely, and gaps open where the material stretches");
    });
}

void suspect_times(Case const& document, std::string const& base, Reader& reader) {
  if (document.time.safety > 1)
    reader.warn(base + "/time/safety", in_short(document.time.safety), "at most 1",
                "steps beyond the elastic bound are not stable");
  for (std::size_t k = 0; k < document.expect.size(); ++k)
    if (document.expect[k].time > document.time.end)
      reader.warn(base + "/expect/" + std::to_string(k) + "/time", in_short(document.expect[k].time) + " s",
                  "at most /time/end, " + in_short(document.time.end) + " s", "this will not be judged");
}

}  // namespace

void add_suspicions(Case const& values, Document const& document, std::string const& base, Reader& reader) {
  suspect_materials(document, base, values.materials.size(), reader);
  suspect_walls(values, base, reader);
  suspect_bodies(values, base, reader);
  suspect_times(values, base, reader);
}

}  // namespace talus
