#include "verification/reference/stability/arrangement.hpp"

#include <cmath>

#include "verification/reference/linear_algebra.hpp"
#include "verification/reference/stability/bisection.hpp"

namespace talus::reference {

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Weights and gradients of particles (rows) at all nodes around them (columns).
struct Stencils {
  MatrixXd nodes;  ///< their places, one a column
  MatrixXd weight;
  std::vector<MatrixXd> slope;  ///< along each axis
  VectorXd mass;                ///< of nodes

  Stencils(Arrangement const& particles, int degree) {
    Index const D = particles.places.front().size(), P = static_cast<Index>(particles.places.size());
    VectorXd low = particles.places.front(), high = low;
    for (auto const& x : particles.places) low = low.cwiseMin(x), high = high.cwiseMax(x);
    low = (low.array() - 2).floor();
    VectorXd const counts = (high.array() + 3).floor() - low.array();
    auto const total = static_cast<Index>(counts.prod());
    nodes.resize(D, total);
    weight.resize(P, total);
    slope.assign(static_cast<std::size_t>(D), MatrixXd(P, total));
    for (Index i = 0; i < total; ++i) {
      for (Index d = 0, rest = i; d < D; rest /= static_cast<Index>(counts[d++]))
        nodes(d, i) = low[d] + double(rest % static_cast<Index>(counts[d]));
      for (Index p = 0; p < P; ++p) set(particles.places[static_cast<std::size_t>(p)], degree, p, i);
    }
    mass = weight.transpose() * VectorXd::Map(particles.masses.data(), P);
  }

 private:
  void set(VectorXd const& x, int degree, Index p, Index i) {
    Index const D = x.size();
    VectorXd const r = x - nodes.col(i);
    weight(p, i) = 1;
    for (Index d = 0; d < D; ++d) weight(p, i) *= cardinal_spline(degree, r[d]);
    for (Index d = 0; d < D; ++d) {
      double product = cardinal_spline_slope(degree, r[d]);
      for (Index other = 0; other < D; ++other)
        if (other != d) product *= cardinal_spline(degree, r[other]);
      slope[static_cast<std::size_t>(d)](p, i) = product;
    }
  }
};

/// v, C and e of all particles, column by column a particle: C and e as D x D matrices.
struct State {
  MatrixXd v;
  std::vector<MatrixXd> C, e;
};

State unpack(VectorXd const& numbers, Index D, Index P) {
  State state{MatrixXd::Map(numbers.data(), D, P), {}, {}};
  for (Index p = 0; p < P; ++p) {
    state.C.emplace_back(MatrixXd::Map(numbers.data() + D * P + p * D * D, D, D));
    state.e.emplace_back(MatrixXd::Map(numbers.data() + D * P + (P + p) * D * D, D, D));
  }
  return state;
}

VectorXd pack(State const& state) {
  Index const D = state.v.rows(), P = state.v.cols();
  VectorXd numbers(D * P + 2 * P * D * D);
  MatrixXd::Map(numbers.data(), D, P) = state.v;
  for (Index p = 0; p < P; ++p) {
    auto const own = static_cast<std::size_t>(p);
    MatrixXd::Map(numbers.data() + D * P + p * D * D, D, D) = state.C[own];
    MatrixXd::Map(numbers.data() + D * P + (P + p) * D * D, D, D) = state.e[own];
  }
  return numbers;
}

MatrixXd stress(MatrixXd const& e, double nu) {
  double const lambda = nu / ((1 + nu) * (1 - 2 * nu)), G = 1 / (2 * (1 + nu));
  return lambda * e.trace() * MatrixXd::Identity(e.rows(), e.cols()) + G * (e + e.transpose());
}

State stepped(State state, Arrangement const& particles, Stencils const& at, Transfer const& transfer, double dt) {
  Index const D = state.v.rows(), P = state.v.cols(), N = at.mass.size();
  double const D_p = (transfer.degree + 1) / 12.0;
  MatrixXd before = MatrixXd::Zero(D, N), after = MatrixXd::Zero(D, N);
  for (Index i = 0; i < N; ++i) {
    if (at.mass[i] < 1e-300) continue;
    VectorXd impulse = VectorXd::Zero(D);
    for (Index p = 0; p < P; ++p) {
      auto const own = static_cast<std::size_t>(p);
      double const share = particles.masses[own] / at.mass[i];
      VectorXd gradient(D);
      for (Index d = 0; d < D; ++d) gradient[d] = at.slope[static_cast<std::size_t>(d)](p, i);
      VectorXd shown = state.v.col(p);
      if (transfer.affine) shown += state.C[own] * (at.nodes.col(i) - particles.places[own]);
      before.col(i) += share * at.weight(p, i) * shown;                       // (1)
      impulse -= dt * share * stress(state.e[own], particles.nu) * gradient;  // (2)
    }
    after.col(i) = before.col(i) + impulse;
  }
  for (Index p = 0; p < P; ++p) {
    auto const own = static_cast<std::size_t>(p);
    VectorXd const w = at.weight.row(p).transpose();
    state.v.col(p) = transfer.alpha * (state.v.col(p) - before * w) + after * w;  // (3)
    state.C[own].setZero();
    for (Index i = 0; i < N; ++i) {
      VectorXd gradient(D);
      for (Index d = 0; d < D; ++d) gradient[d] = at.slope[static_cast<std::size_t>(d)](p, i);
      if (transfer.affine)
        state.C[own] += w[i] / D_p * after.col(i) * (at.nodes.col(i) - particles.places[own]).transpose();
      state.e[own] += dt * after.col(i) * gradient.transpose();  // (4)
    }
  }
  return state;
}

}  // namespace

MatrixXd step_matrix(Arrangement const& particles, Transfer const& transfer, double dt) {
  Index const D = particles.places.front().size(), P = static_cast<Index>(particles.places.size());
  Index const size = D * P + 2 * P * D * D;
  Stencils const at(particles, transfer.degree);
  MatrixXd matrix(size, size);
  for (Index k = 0; k < size; ++k)
    matrix.col(k) = pack(stepped(unpack(VectorXd::Unit(size, k), D, P), particles, at, transfer, dt));
  return matrix;
}

double growth_of_a_step(Arrangement const& particles, Transfer const& transfer, double dt) {
  return eigenvalues_of(step_matrix(particles, transfer, dt)).cwiseAbs().maxCoeff();
}

double longest_step(Arrangement const& particles, Transfer const& transfer) {
  return largest_where_true([&](double dt) { return growth_of_a_step(particles, transfer, dt) <= 1 + defect; });
}

double sharpest_place(int degree) {
  double most = 0, place = 0;
  for (int k = 1; k < 10000; ++k) {
    double const x = k / 10000.0 - 5e-6;
    double sum = 0;
    for (int i = -2; i <= 3; ++i)
      if (double const weight = cardinal_spline(degree, x - i); weight > 0) {
        double const slope = cardinal_spline_slope(degree, x - i);
        sum += slope * slope / weight;
      }
    if (sum > most) most = sum, place = x;
  }
  return place;
}

}  // namespace talus::reference
