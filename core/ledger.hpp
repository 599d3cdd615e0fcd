#pragma once
/// What became of energy, momentum and angular momentum: every term by a sum of its own, so that what is left over
/// tells of a mistake.
///
/// Of a step from t to t + dt, with v_i^old the nodes' velocities before it, v_i* those that forces and gravity make of
/// them, v_i' those that the walls leave, v_i^L those that the gradient L_p is taken from (v_i', or the remapped ones),
/// I_i the impulse of stress and b_p the body force's acceleration:
///
///   gravity    sum_p m_p g . (x_p' - x_p)                                                          (1)
///   body force sum_p m_p b_p . (x_p' - x_p)                                                        (2)
///   walls      sum_i m_i (v_i' - v_i*) . (v_i' + v_i*) / 2                                         (3)
///   plastic    sum_p V_p^0 (Psi(eps^trial) - Psi(eps'))                                            (4)
///   transfer   (K_p - K_i^old) + (K_i' - K_p')                                                     (5)
///   stepping   sum_i I_i . v_i^L + m_i dt (g + b_i) . v_i' - m_i (v_i* - v_i^old) . (v_i* + v_i^old) / 2
///              - sum_p V_p^0 (Psi(eps^trial) - Psi(eps) - tau_p : dt L_p)                          (6)
///
///   (K + E_e)' - (K + E_e) = gravity + body force + walls - plastic - transfer - stepping          (7)
///
/// (4): what the return map takes of the stored energy. (6): what the finite step makes of the work of the forces. (7)
/// holds to rounding if the nodes' work is the particles': sum_i I_i . v_i^L = -sum_p V_p^0 tau_p : dt L_p, and
/// sum_i m_i v_i' = sum_p m_p (x_p' - x_p)/dt. Angular momentum, about the origin, likewise; the impulses of stress have
/// none. K counts what affine velocities carry: sum_p m_p (|v_p|^2 + D_p |C_p|^2)/2, D_p = inertia h^2; the spin of a
/// particle is m_p D_p times twice the axial vector of C_p.

#include <cmath>

#include "core/batch.hpp"
#include "core/tensor.hpp"

namespace talus {

/// Angular momentum: about z in the plane, a vector in space [kg m^2/s].
template <int D>
using Spin = Eigen::Matrix<double, D == 2 ? 1 : 3, 1>;

template <int D>
[[nodiscard]] Spin<D> cross(Point<D> const& a, Point<D> const& b) {
  if constexpr (D == 2) return Spin<D>(a[0] * b[1] - a[1] * b[0]);
  if constexpr (D == 3) return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of strain, over particles [J]: sum V^0 tau : dt L, and the energy stored before, on trial and after.
template <class T = double>
struct StrainWork {
  T power = T(0.0), before = T(0.0), trial = T(0.0), after = T(0.0);

  StrainWork& operator+=(StrainWork const& b) {
    power += b.power;
    before += b.before;
    trial += b.trial;
    after += b.after;
    return *this;
  }
};

/// Sums over particles.
template <int D>
struct Totals {
  double kinetic = 0, elastic = 0;           ///< [J]
  Point<D> momentum = Point<D>::Zero();      ///< [kg m/s]
  Point<D> first_moment = Point<D>::Zero();  ///< sum m x [kg m]
  double second_moment = 0;                  ///< sum m |x|^2 [kg m^2]
  Spin<D> spin = Spin<D>::Zero();

  Totals& operator+=(Totals const& b) {
    second_moment += b.second_moment;
    kinetic += b.kinetic;
    elastic += b.elastic;
    momentum += b.momentum;
    first_moment += b.first_moment;
    spin += b.spin;
    return *this;
  }
};

/// Sums over nodes of one step; spins are about the origin.
template <int D>
struct NodeTotals {
  double before = 0, after = 0;  ///< kinetic energy with v^old and v' [J]
  double walls = 0;              ///< (3) [J]
  double stepping = 0;           ///< the nodes' part of (6) [J]
  Spin<D> spin_before = Spin<D>::Zero(), spin_after = Spin<D>::Zero(), wall_torque = Spin<D>::Zero();

  NodeTotals& operator+=(NodeTotals const& b) {
    before += b.before;
    after += b.after;
    walls += b.walls;
    stepping += b.stepping;
    spin_before += b.spin_before;
    spin_after += b.spin_after;
    wall_torque += b.wall_torque;
    return *this;
  }
};

/// Impulse, work (2) and torque of the body force.
template <int D>
struct BodyForceTotals {
  double work = 0;
  Point<D> impulse = Point<D>::Zero();
  Spin<D> torque = Spin<D>::Zero();

  BodyForceTotals& operator+=(BodyForceTotals const& b) {
    work += b.work;
    impulse += b.impulse;
    torque += b.torque;
    return *this;
  }
};

/// What came in and went since the start.
template <int D>
struct Ledger {
  Totals<D> start, now;
  BodyForceTotals<D> body_force;
  double gravity = 0, walls = 0, plastic = 0, transfer = 0, stepping = 0;  ///< (1), (3) ... (6) [J]
  Spin<D> gravity_torque = Spin<D>::Zero(), wall_torque = Spin<D>::Zero(), transfer_spin = Spin<D>::Zero();

  /// Enters a step of dt under gravity g; `after`: the particles at its end.
  void enter(double dt, Point<D> const& g, Totals<D> const& after, StrainWork<> const& strain,
             NodeTotals<D> const& nodes, BodyForceTotals<D> const& body) {
    body_force += body;
    gravity += g.dot(after.first_moment - now.first_moment);
    walls += nodes.walls;
    plastic += strain.trial - strain.after;
    transfer += (now.kinetic - nodes.before) + (nodes.after - after.kinetic);
    stepping += nodes.stepping - (strain.trial - strain.before - strain.power);
    gravity_torque += cross<D>(now.first_moment, Point<D>(dt * g));
    wall_torque += nodes.wall_torque;
    transfer_spin += (now.spin - nodes.spin_before) + (nodes.spin_after - after.spin);
    now = after;
  }

  /// What (7) leaves over [J].
  [[nodiscard]] double energy_residual() const {
    return (now.kinetic - start.kinetic) + (now.elastic - start.elastic) -
           (gravity + body_force.work + walls - plastic - transfer - stepping);
  }
  /// That over the largest of its terms [1].
  [[nodiscard]] double relative_energy_residual() const {
    double largest = 0;
    for (double const term : {now.kinetic, start.kinetic, now.elastic, start.elastic, gravity, body_force.work, walls,
                              plastic, transfer, stepping})
      largest = std::max(largest, std::abs(term));
    return largest > 0 ? energy_residual() / largest : 0;
  }
  [[nodiscard]] Spin<D> spin_residual() const {
    return now.spin - start.spin - (gravity_torque + body_force.torque + wall_torque - transfer_spin);
  }
};

/// Sum over lanes, in their order.
[[nodiscard]] inline double sum_of(Lanes const& values) {
  double sum = 0;
  for (int lane = 0; lane < lanes; ++lane) sum += values[lane];
  return sum;
}

/// Sums over the particles of a batch, but for their elastic energy. inertia: D_p [m^2]. Empty lanes have no mass.
template <int D>
[[nodiscard]] Totals<D> totals_of(Batch<D> const& batch, double inertia) {
  constexpr int spins = D == 2 ? 1 : 3;
  Lanes square(0.0), second(0.0), momentum[D]{}, first[D]{}, spin[spins]{};
  for (int c = 0; c < batch.count; ++c) {
    Lanes const* chunk = batch.chunk(c);
    Lanes const m = chunk[batch.at.mass], *x = chunk + batch.at.position, *v = chunk + batch.at.velocity;
    Lanes v_square(0.0), x_square(0.0);
    for (int d = 0; d < D; ++d) {
      v_square += v[d] * v[d];
      x_square += x[d] * x[d];
      momentum[d] += m * v[d];
      first[d] += m * x[d];
    }
    for (int k = 0; k < spins; ++k) {
      int const i = D == 2 ? 0 : (k + 1) % 3, j = D == 2 ? 1 : (k + 2) % 3;
      Lanes own = x[i] * v[j] - x[j] * v[i];
      if (batch.at.affine >= 0) {
        Lanes const* C = chunk + batch.at.affine;
        own += Lanes(inertia) * (C[j * D + i] - C[i * D + j]);
      }
      spin[k] += m * own;
    }
    if (batch.at.affine >= 0)
      for (int k = 0; k < D * D; ++k)
        v_square += Lanes(inertia) * chunk[batch.at.affine + k] * chunk[batch.at.affine + k];
    square += m * v_square;
    second += m * x_square;
  }
  Totals<D> sum;
  sum.kinetic = 0.5 * sum_of(square);
  sum.second_moment = sum_of(second);
  for (int d = 0; d < D; ++d) {
    sum.momentum[d] = sum_of(momentum[d]);
    sum.first_moment[d] = sum_of(first[d]);
  }
  for (int k = 0; k < spins; ++k) sum.spin[k] = sum_of(spin[k]);
  return sum;
}

}  // namespace talus
