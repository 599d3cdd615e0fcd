#pragma once
/// Mirrors on the nodes: what core/grid_pass.hpp declares. Equations: core/mirror.hpp.

#include "core/grid_pass.hpp"

namespace talus {

/// (2) for one vector of a node: what changes sign with the velocity comes first, mass and friction behind it.
template <int D>
void GridPass<D>::fold_vector(Image<D> const& image, Point<D> const& shift, NodeVector& real, NodeVector& image_sum) {
  double const mass = image_sum[D];
  for (int d = 0; d < D; ++d) real.set(d, real[d] + image.sign[d] * (image_sum[d] - mass * shift[d]));
  for (int k = D; k < 4; ++k) real.set(k, real[k] + image_sum[k]);
  image_sum = NodeVector(0.0);
}

/// Remembers what a node got, for the walls' impulses and for the ledger.
template <int D>
typename GridPass<D>::Sent GridPass<D>::sent(std::size_t node, double dt) {
  Stages<D> const& stages = *scene_.stages;
  NodeVector const* sums = sums_of(node);
  double const mass = sums[0][D];
  Sent sent{mass};
  NodeVector free(0.0);
  for (int d = 0; d < D; ++d) {
    double const pushed = (stages.apart ? sums[1][d] : 0) + (scene_.body_force ? body_[node][d] : 0);
    sent.momentum[d] = (1 - stages.kept) * sums[0][d] + pushed + mass * dt * scene_.gravity[d];
    if (mass > 0) free.set(d, (sums[0][d] + pushed) / mass + dt * scene_.gravity[d]);
  }
  mirrored_[node] = 1;
  if (scene_.keeps_ledger)
    before_[node] = mass > 0 ? before(node, mass, sums[0], sums[stages.summed - 1], free) : Before{};
  return sent;
}

/// Moves what particles sent to images over to the real nodes, (2).
template <int D>
void GridPass<D>::fold(double t, double dt) {
  auto const& images = mirrors_.images();
  std::size_t const n = images.size();
  for (auto* list : {&sent_, &sent_to_real_, &free_}) list->assign(n, {});
  auto const is_first = [&](std::size_t k) { return k == 0 || images[k].real != images[k - 1].real; };
  for (std::size_t k = 0; k < n; ++k) {
    if (is_first(k)) sent_to_real_[k] = sent(images[k].real, dt);
    sent_[k] = sent(images[k].node, dt);
  }
  std::size_t first = 0;
  for (std::size_t k = 0; k < n; ++k) {
    Image<D> const& image = images[k];
    if (is_first(k)) first = k;
    NodeVector *real = sums_of(image.real), *behind = sums_of(image.node);
    int const last = scene_.stages->summed - 1;
    // the image feels the image of gravity; the step will give the real node's to all
    for (int d = 0; d < D; ++d)
      real[last].set(d, real[last][d] + (image.sign[d] - 1) * sent_[k].mass * dt * scene_.gravity[d]);
    Point<D> const shift = mirrors_.shift(image, t + dt);
    for (int v = last; v > 0; --v) fold_vector(image, Point<D>::Zero(), real[v], behind[v]);
    fold_vector(image, shift, real[0], behind[0]);
    if (scene_.body_force) fold_vector(image, Point<D>::Zero(), body_[image.real], body_[image.node]);
    double const mass = real[0][D];
    free_[first] = {mass};
    for (int d = 0; d < D && mass > 0; ++d)
      free_[first].momentum[d] = real[0][d] + (last > 0 ? real[last][d] : 0) +
                                 (scene_.body_force ? body_[image.real][d] : 0) + mass * dt * scene_.gravity[d];
  }
}

/// Gives the images their velocities, (1).
template <int D>
void GridPass<D>::unfold(double t) {
  auto const told = static_cast<std::size_t>(scene_.stages->told);
  for (Image<D> const& image : mirrors_.images()) {
    Point<D> const c = mirrors_.shift(image, t);
    for (std::size_t v = 0; v < told; ++v) {
      NodeVector const& real = nodes_[image.real * told + v];
      NodeVector& behind = nodes_[image.node * told + v];
      for (int k = 0; k < (D == 2 ? 4 : D); ++k) behind.set(k, image.sign[k % D] * real[k] + c[k % D]);
    }
  }
}

/// The walls' impulses: what the particles' momentum will have changed by and nothing else accounts for,
///
///   sum_i m_i (v_i - alpha v_i^old) - (1 - alpha) (mv)_i - f_i        over a real node and its images,
///
/// less what other walls did to the real node.
template <int D>
void GridPass<D>::account_for_mirrors() {
  auto const& images = mirrors_.images();
  auto const told = static_cast<std::size_t>(scene_.stages->told);
  double const kept = scene_.stages->kept;
  auto const gained = [&](std::size_t node, Sent const& own) {
    NodeVector const* v = nodes_.data() + node * told;
    Point<D> sum = -own.momentum;
    for (int d = 0; d < D; ++d)
      sum[d] += own.mass * (v[0][d] - (kept > 0 ? kept * (D == 2 ? v[0][2 + d] : v[told - 1][d]) : 0));
    return sum;
  };
  for (std::size_t k = 0; k < images.size(); ++k) {
    Image<D> const& image = images[k];
    Point<D> sum = gained(image.node, sent_[k]);
    if (k == 0 || image.real != images[k - 1].real) {
      sum += gained(image.real, sent_to_real_[k]) + free_[k].momentum;
      for (int d = 0; d < D; ++d) sum[d] -= free_[k].mass * nodes_[image.real * told][d];
    }
    impulses_[image.real / nodes_per_block * scene_.walls.size() + static_cast<std::size_t>(mirrors_.wall(image))] +=
        sum;
  }
}

}  // namespace talus
