#include "core/in_short.hpp"
#include "models/boundaries/extent.hpp"
#include "models/compose.hpp"

namespace talus {

namespace {

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

void add_suspicions(Case const& values, std::string const& base, Reader& reader) {
  suspect_walls(values, base, reader);
  suspect_bodies(values, base, reader);
  suspect_times(values, base, reader);
}

}  // namespace talus
