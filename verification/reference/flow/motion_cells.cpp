#include "verification/reference/flow/motion_cells.hpp"

#include <gsl/gsl_sf_lambert.h>

#include <limits>

namespace talus::reference::flow {

MotionCells::MotionCells(Motion const& motion, int n) : motion_(motion), n_(n) {
  double const rho = motion.fluid.density, w = rho * gravity * std::cos(motion.slope);
  for (int k = 1; k <= n; ++k) {
    normal_.push_back(w * (motion.h_0 - node(k - 0.5)));
    width_.push_back(node(k) - node(k - 1));
    mass_.push_back(rho * ((k < n ? node(k + 0.5) : motion.h_0) - node(k - 0.5)));
  }
  speed_size_ = std::max(std::abs(motion.speed(motion.h_0)), 0.1 * std::sqrt(gravity * motion.h_0));
  if (motion.volume == Motion::Volume::hardening) return;
  Fluid const& f = motion.fluid;
  for (double const N : normal_) {
    double p = N, J = 1;
    if (motion.volume == Motion::Volume::critical) {
      double const a = 1 / f.hardening.xi, c = f.hardening.p_c0 * (1 - f.beta) / 2;
      p = root([&](double x) { return std::log(x / N) - a * std::log(c / x) + x / f.elastic.K(); }, 0.1 * N, 10 * N);
      J = p / N;
    }
    critical_.push_back({p, f.critical_strength(p), f.omega() * p, f.omega() * p, J});
  }
}

double MotionCells::node(double k) const {
  double const s = 1 - k / n_;
  return motion_.h_0 * (1 - s * s);
}

/// p_c = r 2 p/(1 - beta) and p = N exp(eps - p/K).
double MotionCells::initial_eps(double N) const {
  Fluid const& f = motion_.fluid;
  return root(
      [&](double eps) {
        double const p_c = f.hardening.p_c0 * std::exp(-f.hardening.xi * eps);
        double const p = p_c * (1 - f.beta) / (2 * motion_.strength_ratio);
        return std::log(p / N) - eps + p / f.elastic.K();
      },
      -0.5, 0.5);
}

std::vector<MotionCells::Cell> MotionCells::start() const {
  std::vector<Cell> cells;
  for (std::size_t k = 0; k < count(); ++k) {
    double const below = motion_.speed(node(static_cast<double>(k))),
                 above = motion_.speed(node(static_cast<double>(k + 1)));
    Cell cell{0, motion_.volume == Motion::Volume::hardening ? initial_eps(normal_[k]) : 0, above};
    auto const here = local(k, cell.eps);
    double const gamma = (above - below) / (width_[k] * here.stretch);
    if (motion_.sheared) cell.tau = std::copysign(motion_.fluid.stress(std::abs(gamma), here.p, here.p_c), gamma);
    cells.push_back(cell);
  }
  return cells;
}

MotionCells::Local MotionCells::local(std::size_t k, double eps) const {
  if (!critical_.empty()) return critical_[k];
  Fluid const& f = motion_.fluid;
  double const K = f.elastic.K(), p = K * gsl_sf_lambert_W0(std::exp(eps) * normal_[k] / K);
  double const p_c = f.hardening.p_c0 * std::exp(-f.hardening.xi * eps);
  return {p, p_c, f.size(p, p_c), p + f.beta * p_c, p / normal_[k]};
}

double MotionCells::plastic_rate(Local const& here, double tau) const {
  MuI const& m = motion_.fluid.friction;
  double const above = std::abs(tau) - m.mu_1 * here.S, room = m.mu_2 * here.S - std::abs(tau);
  if (!(room > 0)) return std::numeric_limits<double>::quiet_NaN();
  return above <= 0 ? 0 : std::copysign(m.Q() * std::sqrt(here.P) * above / room, tau);
}

double MotionCells::stress_rate(std::size_t k, Local const& here, double u_below, double u_above,
                                double plastic_rate) const {
  return motion_.fluid.elastic.G() * ((u_above - u_below) / (width_[k] * here.stretch) - plastic_rate);
}

double MotionCells::volume_rate(Local const& here, double tau, double plastic_rate) const {
  if (!critical_.empty()) return 0;
  double const mu = std::abs(tau) / here.S;
  return std::abs(plastic_rate) * mu * ((1 - motion_.fluid.beta) * here.p_c - 2 * here.p) / (2 * here.S);
}

double MotionCells::acceleration(std::size_t k, double below, double above) const {
  return gravity * std::sin(motion_.slope) + (above - below) / mass_[k];
}

double MotionCells::flow_imbalance(Local const& here, double tau, double plastic_rate) const {
  MuI const& m = motion_.fluid.friction;
  double const above = std::max(std::abs(tau) - m.mu_1 * here.S, 0.0), room = m.mu_2 * here.S - std::abs(tau);
  double const lack = plastic_rate * room - std::copysign(m.Q() * std::sqrt(here.P) * above, tau);
  return room > 0 ? lack / (m.mu_2 * here.S) : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Snapshot> MotionCells::snapshots(std::vector<std::vector<double>> const& states,
                                             std::vector<double> const& times, std::size_t width,
                                             std::size_t speed) const {
  std::vector<Snapshot> list;
  for (std::size_t t = 0; t < times.size(); ++t) {
    Snapshot s{times[t], {0}, {0}, {motion_.speed(0)}, {}, {}, {}, {}};
    for (std::size_t k = 0; k < count(); ++k) {
      double const* const here = states[t].data() + width * k;
      auto const state = local(k, here[1]);
      s.Y.push_back(node(static_cast<double>(k + 1)));
      s.y.push_back(s.y.back() + width_[k] * state.stretch);
      s.u.push_back(here[speed]);
      s.tau.push_back(here[0]), s.p.push_back(state.p), s.p_c.push_back(state.p_c);
      s.stretch.push_back(state.stretch);
    }
    list.push_back(std::move(s));
  }
  return list;
}

}  // namespace talus::reference::flow
