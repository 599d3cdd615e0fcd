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

NamedColumn const& column_of(Snapshot const& snapshot, std::string const& name) {
  if (auto const* column = snapshot.find(name)) return *column;
  std::string known;
  for (auto const& column : snapshot.columns) known += (known.empty() ? "" : ", ") + column.name;
  throw InputError("the frames have no field '" + name + "'; they have " + known);
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

/// A number that looks random, the same for the same particle (splitmix64: Steele, Lea & Flood 2014,
/// doi:10.1145/2660193.2660195).
std::uint64_t mixed(std::uint64_t n) {
  n += 0x9e3779b97f4a7c15;
  n = (n ^ (n >> 30)) * 0xbf58476d1ce4e5b9;
  n = (n ^ (n >> 27)) * 0x94d049bb133111eb;
  return n ^ (n >> 31);
}

}  // namespace

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
    std::uint64_t order;
    Dot dot;
  };
  auto const& position = column_of(snapshot, "position");
  auto const& column = column_of(snapshot, field);
  std::vector<Placed> placed;
  for (std::size_t p = 0; p < snapshot.particles(); ++p) {
    auto const x = place(position, p);
    double const value = magnitude(column, p);
    if (is_finite(x) && std::isfinite(value))
      placed.push_back({dot(x, view.toward), mixed(p), {dot(x, view.right), dot(x, view.up), value}});
  }
  std::ranges::sort(placed, [](Placed const& a, Placed const& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.order < b.order;
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
