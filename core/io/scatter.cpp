#include "core/io/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include "core/errors.hpp"

namespace talus::io {

namespace {

double dot(Direction const& a, Direction const& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction place(NamedColumn const& position, std::size_t p) {
  auto const width = static_cast<std::size_t>(position.components);
  Direction result{};
  for (std::size_t k = 0; k < std::min<std::size_t>(3, width); ++k) result[k] = position.values[p * width + k];
  return result;
}

double magnitude(NamedColumn const& column, std::size_t p) {
  auto const width = static_cast<std::size_t>(column.components);
  if (width == 1) return column.values[p];
  double square = 0;
  for (std::size_t k = 0; k < width; ++k) square += column.values[p * width + k] * column.values[p * width + k];
  return std::sqrt(square);
}

bool is_finite(Direction const& x) {
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

/// Place on a curve that fills a square, of a point with coordinates in [0, 1]: the bits of both in turn (Morton 1966).
/// Every n-th point along it is an even sample of the square.
std::uint32_t place_on_curve(double x, double y) {
  std::uint32_t const i = static_cast<std::uint32_t>(x * 65535), j = static_cast<std::uint32_t>(y * 65535);
  std::uint32_t place = 0;
  for (std::uint32_t bit = 0; bit < 16; ++bit) place |= (i >> bit & 1) << (2 * bit) | (j >> bit & 1) << (2 * bit + 1);
  return place;
}

}  // namespace

NamedColumn const& column_of(Snapshot const& snapshot, std::string const& name) {
  if (auto const* column = snapshot.find(name)) return *column;
  std::string known;
  for (auto const& column : snapshot.columns) known += (known.empty() ? "" : ", ") + column.name;
  throw InputError("the frames have no field '" + name + "'; they have " + known);
}

View side_view() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
}

View oblique_view() {
  constexpr double turn = 30 * std::numbers::pi / 180, tilt = 25 * std::numbers::pi / 180;
  double const ct = std::cos(turn), st = std::sin(turn), cl = std::cos(tilt), sl = std::sin(tilt);
  return {{ct, 0, -st}, {-st * sl, cl, -ct * sl}, {st * cl, sl, ct * cl}};
}

void Bounds::include(Direction const& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], point[k]);
    high[k] = std::max(high[k], point[k]);
  }
}

Bounds bounds_of(Snapshot const& snapshot) {
  auto const& position = column_of(snapshot, "position");
  Bounds bounds;
  for (std::size_t p = 0; p < snapshot.particles(); ++p)
    if (auto const x = place(position, p); is_finite(x)) bounds.include(x);
  return bounds;
}

std::vector<Dot> dots_of(Snapshot const& snapshot, View const& view, std::string const& field) {
  struct Placed {
    double depth;
    std::uint32_t place;
    Dot dot;
  };
  auto const& position = column_of(snapshot, "position");
  auto const& column = column_of(snapshot, field);
  std::vector<Placed> placed;
  Bounds plane;
  for (std::size_t p = 0; p < snapshot.particles(); ++p) {
    auto const x = place(position, p);
    double const value = magnitude(column, p);
    if (!is_finite(x) || !std::isfinite(value)) continue;
    placed.push_back({dot(x, view.toward), 0, {dot(x, view.right), dot(x, view.up), value}});
    plane.include({placed.back().dot.x, placed.back().dot.y, 0});
  }
  double const side = std::max({plane.high[0] - plane.low[0], plane.high[1] - plane.low[1], 1e-300});
  for (auto& each : placed)
    each.place = place_on_curve((each.dot.x - plane.low[0]) / side, (each.dot.y - plane.low[1]) / side);
  std::ranges::sort(placed, [](Placed const& a, Placed const& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.place < b.place;
  });
  std::vector<Dot> dots;
  for (auto const& each : placed) dots.push_back(each.dot);
  return dots;
}

double spacing_of(Snapshot const& snapshot) {
  auto const& position = column_of(snapshot, "position");
  auto const bounds = bounds_of(snapshot);
  auto const n = static_cast<double>(snapshot.particles());
  if (n < 2 || bounds.empty()) return 0;
  auto const extent = [&](std::size_t k) { return bounds.high[k] - bounds.low[k]; };
  double const longest = std::max({extent(0), extent(1), extent(2)});
  double const power = snapshot.dimension;
  double spacing = longest / std::pow(n, 1 / power);
  for (int pass = 0; pass < 3 && spacing > 0; ++pass) {  // cells of about 2^D particles, as far as they are known
    std::set<std::array<std::int64_t, 3>> cells;
    for (std::size_t p = 0; p < snapshot.particles(); ++p) {
      auto const x = place(position, p);
      if (!is_finite(x)) continue;
      std::array<std::int64_t, 3> cell{};
      for (std::size_t k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>((x[k] - bounds.low[k]) / (2 * spacing));
      cells.insert(cell);
    }
    spacing = 2 * spacing * std::pow(static_cast<double>(cells.size()) / n, 1 / power);
  }
  return spacing;
}

}  // namespace talus::io
