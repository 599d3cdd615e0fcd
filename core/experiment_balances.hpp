#pragma once
/// What became of the conserved quantities: what core/experiment_of.hpp declares.

#include "core/experiment_of.hpp"

namespace talus {

namespace detail {

template <class V>
Balance::Term term(std::string name, V const& value) {
  return {std::move(name), std::vector<double>(value.begin(), value.end())};
}
inline Balance::Term term(std::string name, double value) {
  return {std::move(name), {value}};
}

/// Sets what is relative to the largest of the terms, or to `scale` if that is larger.
inline Balance closed(Balance balance, double scale) {
  auto const size = [](std::vector<double> const& v) {
    double square = 0;
    for (double const x : v) square += x * x;
    return std::sqrt(square);
  };
  for (Balance::Term const& t : balance.terms) scale = std::max(scale, size(t.value));
  balance.relative = scale > 0 ? size(balance.residual) / scale : 0;
  return balance;
}

template <int D>
Balance energy_balance(Ledger<D> const& l) {
  return closed(
      {"energy",
       "J",
       {term("kinetic_start", l.start.kinetic), term("kinetic_end", l.now.kinetic),
        term("elastic_start", l.start.elastic), term("elastic_end", l.now.elastic), term("gravity_work", l.gravity),
        term("body_force_work", l.body_force.work), term("wall_work", l.walls), term("plastic_work", l.plastic),
        term("transfer_loss", l.transfer), term("stepping_loss", l.stepping)},
       {l.energy_residual()},
       0},
      0);
}

template <int D>
Balance spin_balance(Ledger<D> const& l) {
  Spin<D> const residual = l.spin_residual();
  return closed(
      {"angular_momentum",
       "kg m^2/s",
       {term("start", l.start.spin), term("end", l.now.spin), term("gravity", l.gravity_torque),
        term("body_force", l.body_force.torque), term("walls", l.wall_torque), term("transfer_loss", l.transfer_spin)},
       term("", residual).value,
       0},
      std::sqrt(2 * l.now.kinetic * l.now.second_moment));
}

}  // namespace detail

template <int D>
std::vector<Balance> ExperimentOf<D>::balances() const {
  Scene<D> const& scene = simulation_->scene();
  if (!scene.keeps_ledger) return {};
  Ledger<D> const& l = simulation_->ledger();
  Momentum<D> const& came = simulation_->momentum();
  double const mass = simulation_->mass();
  double now = 0;
  int const at = simulation_->particles().layout().find(field::mass);
  simulation_->particles().for_each([&](std::ptrdiff_t slot, int) { now += simulation_->particles().get(slot, at); });
  Balance momentum{"momentum", "kg m/s", {}, {}, 0};
  momentum.terms = {detail::term("start", l.start.momentum), detail::term("end", l.now.momentum),
                    detail::term("gravity", came.gravity), detail::term("body_force", l.body_force.impulse)};
  Point<D> residual = l.now.momentum - l.start.momentum - came.gravity - l.body_force.impulse;
  for (std::size_t w = 0; w < came.walls.size(); ++w) {
    momentum.terms.push_back(detail::term("wall_" + scene.walls[w]->name, came.walls[w]));
    residual -= came.walls[w];
  }
  momentum.residual = detail::term("", residual).value;
  std::vector<Balance> all{
      detail::closed({"mass", "kg", {detail::term("start", mass), detail::term("end", now)}, {now - mass}, 0}, 0),
      detail::closed(std::move(momentum), std::sqrt(2 * l.now.kinetic * mass)), detail::energy_balance(l)};
  if (std::all_of(scene.periods.begin(), scene.periods.end(), [](auto n) { return n == 0; }))
    all.push_back(detail::spin_balance(l));
  return all;
}

}  // namespace talus
