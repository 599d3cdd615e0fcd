#include "verification/reference/material_point.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace talus::reference {

namespace {

/// I without zz in reduced plane strain.
Matrix unit(Elasticity const& elastic) {
  Matrix r = Matrix::Identity();
  if (elastic.normals == 2) r(2, 2) = 0;
  return r;
}

double log_stretch(double h) {
  return 0.5 * std::log1p(2 * h);
}

/// Everything that the rates ask of a state.
struct Point {
  Matrix h, eps, tau, s;
  Stress stress;

  Point(Elasticity const& elastic, double const* y) : h(symmetric(y)) {
    Matrix const I = unit(elastic);
    eps = state_of(y).eps;
    double const trace = eps.trace(), G = elastic.G();
    tau = elastic.lambda() * trace * Matrix::Identity() + 2 * G * eps;
    s = 2 * G * (eps - trace / elastic.normals * I);
    stress = {-elastic.K() * trace, s.norm() / std::sqrt(2.0), y[6]};
  }

  [[nodiscard]] Driving under(Matrix const& l) const { return {l.trace(), s.cwiseProduct(l).sum()}; }
};

}  // namespace

Matrix symmetric(double const* six) {
  Matrix h;
  h << six[0], six[3], six[5], six[3], six[1], six[4], six[5], six[4], six[2];
  return h;
}

void store_symmetric(Matrix const& h, double* six) {
  Matrix const m = 0.5 * (h + h.transpose());
  std::array<double, 6> const entries{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2)};
  std::copy(entries.begin(), entries.end(), six);
}

Coordinates coordinates_of(State const& state) {
  Eigen::SelfAdjointEigenSolver<Matrix> const axes(state.eps);
  Eigen::Vector3d const h = axes.eigenvalues().unaryExpr([](double e) { return 0.5 * std::expm1(2 * e); });
  Coordinates y{};
  store_symmetric(axes.eigenvectors() * h.asDiagonal() * axes.eigenvectors().transpose(), y.data());
  y[6] = state.eps_V;
  return y;
}

State state_of(double const* y) {
  Eigen::SelfAdjointEigenSolver<Matrix> const axes(symmetric(y));
  Eigen::Vector3d const eps = axes.eigenvalues().unaryExpr(&log_stretch);
  return {axes.eigenvectors() * eps.asDiagonal() * axes.eigenvectors().transpose(), y[6]};
}

Coordinates sizes_of(RateLaw const& law) {
  Coordinates sizes;
  sizes.fill(law.scale / law.elastic.K());
  sizes[6] = 1e-2;
  return sizes;
}

Row row_of(RateLaw const& law, double t, Matrix const& l, double const* y, bool plastic) {
  Point const at(law.elastic, y);
  Flow const flow = plastic ? law.flow(at.stress, at.under(l)) : Flow{0, 0};
  auto const& [p, q, eps_V] = at.stress;
  return {t, {at.eps, eps_V}, at.tau, p, q, law.strength(eps_V), 2 * q * flow.shear, flow.volume, plastic};
}

bool rates(RateLaw const& law, bool plastic, Matrix const& l, double const* y, double* dy) {
  Point const at(law.elastic, y);
  Flow const flow = plastic ? law.flow(at.stress, at.under(l)) : Flow{0, 0};
  Matrix const D_P = flow.shear * at.s + flow.volume / law.elastic.normals * unit(law.elastic);
  Matrix const D = 0.5 * (l + l.transpose());
  store_symmetric(D + l * at.h + at.h * l.transpose() - D_P - 2 * D_P * at.h, dy);  // (1)
  dy[6] = flow.volume;
  return std::all_of(dy, dy + coordinates, [](double x) { return std::isfinite(x); });
}

Matrix stress_rate(RateLaw const& law, double const* y, double const* dy) {
  Eigen::SelfAdjointEigenSolver<Matrix> const axes(symmetric(y));
  Matrix const N = axes.eigenvectors();
  Matrix rate = N.transpose() * symmetric(dy) * N;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      double const x = axes.eigenvalues()[a], gap = axes.eigenvalues()[b] - x, u = 2 * gap / (1 + 2 * x);
      rate(a, b) *= (std::abs(u) < 1e-12 ? 1 - 0.5 * u : std::log1p(u) / u) / (1 + 2 * x);
    }
  rate = N * rate * N.transpose();
  return law.elastic.lambda() * rate.trace() * Matrix::Identity() + 2 * law.elastic.G() * rate;
}

double event(RateLaw const& law, bool plastic, Matrix const& l, double const* y) {
  Point const at(law.elastic, y);
  return plastic && !law.viscous ? law.loading(at.stress, at.under(l)) : law.excess(at.stress);
}

bool starts_plastic(RateLaw const& law, bool was_plastic, Matrix const& l, double const* y) {
  constexpr double on_surface = 1e-12, drift = 1e-8;
  Point const at(law.elastic, y);
  double const excess = law.excess(at.stress);
  if (law.viscous && excess > on_surface) return true;
  if (!law.viscous && excess > drift) {
    std::ostringstream text;
    text << "a rate-independent law starts outside of its yield surface: p " << at.stress.p << " Pa, q " << at.stress.q
         << " Pa, excess " << excess;
    throw std::domain_error(text.str());
  }
  return (was_plastic || excess > -on_surface) && law.loading(at.stress, at.under(l)) > 0;
}

}  // namespace talus::reference
