#pragma once
/// The step of the material point method, written down once more without any of the program's machinery but its laws.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "core/fields.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/symmetric_function.hpp"

namespace talus::support {

/// Cardinal B-spline of a degree by the recursion of Cox and de Boor, and its slope.
inline double spline(int degree, double u) {
  if (degree == 0) return -0.5 <= u && u < 0.5 ? 1 : 0;
  double const edge = 0.5 * (degree + 1);
  return ((edge + u) * spline(degree - 1, u + 0.5) + (edge - u) * spline(degree - 1, u - 0.5)) / degree;
}
inline double slope(int degree, double u) {
  return spline(degree - 1, u + 0.5) - spline(degree - 1, u - 0.5);
}

/// A step of the material point method as a textbook has it: one particle after the other, nodes in a map.
template <class Kinematics, class Law>
struct ByHand {
  static constexpr int D = Kinematics::dimension;
  using Shape = typename Kinematics::Shape;
  using Tensor = Eigen::Matrix<double, D, D>;
  /// Velocity that the walls leave a node that would move from x to `to`.
  using Walls = std::function<Point<D>(Point<D> const& x, Point<D> const& to, Point<D> v)>;

  struct Particle {
    Point<D> x, v;
    Tensor C = Tensor::Zero();
    Symmetric<double, Shape> strain{};
    Record<double, typename Law::State> state;
    double mass = 0;
  };

  using Index = std::array<int, static_cast<std::size_t>(D)>;
  struct Node {
    double mass = 0;
    Point<D> momentum = Point<D>::Zero(), force = Point<D>::Zero(), old = Point<D>::Zero(), v = Point<D>::Zero();
  };

  int degree;
  bool affine;
  double alpha, spacing, density, least_mass;
  Law law;
  Point<D> gravity;
  Walls walls;
  std::vector<Particle> particles{};
  std::map<Index, Node> nodes{};

  void fill(std::vector<Seed<D>> const& seeds) {
    for (auto const& seed : seeds)
      particles.push_back({seed.x, seed.v, Tensor::Zero(), {}, law.template initial<Shape>(), seed.mass});
  }

  void step(double dt) {
    nodes.clear();
    for (Particle const& p : particles) to_nodes(p);
    for (auto& [index, node] : nodes) move(index, node, dt);
    for (Particle& p : particles) from_nodes(p, dt);
  }

  [[nodiscard]] Point<D> place(Index const& index) const {
    Point<D> x;
    for (int d = 0; d < D; ++d) x[d] = index[static_cast<std::size_t>(d)] * spacing;
    return x;
  }

  /// Calls f(index, weight, gradient of the weight) for the nodes that a particle at x sees.
  template <class F>
  void for_each_node(Point<D> const& x, F const& f) const {
    int const width = degree + 2;
    Index first;
    for (std::size_t d = 0; d < D; ++d)
      first[d] = static_cast<int>(std::floor(x[static_cast<int>(d)] / spacing - 0.5 * (degree + 1)));
    for (int number = 0; number < std::pow(width, D); ++number) {
      Index index = first;
      int rest = number;
      for (std::size_t d = 0; d < D; ++d, rest /= width) index[d] += rest % width;
      double weight = 1;
      Point<D> gradient = Point<D>::Constant(1 / spacing);
      for (int d = 0; d < D; ++d) {
        double const u = x[d] / spacing - index[static_cast<std::size_t>(d)];
        weight *= spline(degree, u);
        for (int k = 0; k < D; ++k) gradient[k] *= k == d ? slope(degree, u) : spline(degree, u);
      }
      if (weight > 0) f(index, weight, gradient);
    }
  }

  void to_nodes(Particle const& p) {
    auto const stress = law.stress(p.strain);
    Tensor tau;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) tau(i, j) = stress(i, j);
    for_each_node(p.x, [&](Index const& index, double weight, Point<D> const& gradient) {
      Node& node = nodes[index];
      node.mass += weight * p.mass;
      node.momentum += weight * p.mass * (p.v + (affine ? Point<D>(p.C * (place(index) - p.x)) : Point<D>::Zero()));
      node.force -= p.mass / density * tau * gradient;
    });
  }

  void move(Index const& index, Node& node, double dt) const {
    node.old = node.momentum / node.mass;
    node.v = node.old + dt * (node.force / std::max(node.mass, least_mass) + gravity);
    node.v = walls(place(index), place(index) + dt * node.v, node.v);
  }

  void from_nodes(Particle& p, double dt) {
    Point<D> pic = Point<D>::Zero(), old = Point<D>::Zero();
    Tensor B = Tensor::Zero(), L = Tensor::Zero();
    for_each_node(p.x, [&](Index const& index, double weight, Point<D> const& gradient) {
      Node const& node = nodes.at(index);
      pic += weight * node.v;
      old += weight * node.old;
      B += weight * node.v * (place(index) - p.x).transpose();
      L += node.v * gradient.transpose();
    });
    p.v = alpha * (p.v + pic - old) + (1 - alpha) * pic;
    p.x += dt * pic;
    p.C = B * 12 / ((degree + 1) * spacing * spacing);
    strain(p, dt * L);
    p.strain = law.project(p.strain, p.state, dt);
  }

  /// b <- (I + dt L) b (I + dt L)^T for b = exp(2 eps), as b - I so that small strains keep their digits.
  static void strain(Particle& p, Tensor const& H) {
    Tensor eps;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) eps(i, j) = p.strain(i, j);
    Tensor const F = Tensor::Identity() + H;
    Tensor const b_less_one = symmetric_function(eps, [](double e) { return std::expm1(2 * e); });
    Tensor const next = F * b_less_one * F.transpose() + H + H.transpose() + H * H.transpose();
    eps = symmetric_function(next, [](double b) { return 0.5 * std::log1p(b); });
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) p.strain(i, j) = 0.5 * (eps(i, j) + eps(j, i));
  }
};

}  // namespace talus::support
