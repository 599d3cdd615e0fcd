#include "core/material_point.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/errors.hpp"

namespace talus {

namespace {

static_assert(lanes >= 7, "a point and its six derivatives are lanes of one chunk");
constexpr std::array<std::array<int, 2>, 6> places_of{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

double largest(Components6 const& values) {
  double most = 0;
  for (double const value : values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

template <int D>
MaterialPoint<D>::MaterialPoint(std::unique_ptr<Material<D>> material, int strain_size)
    : material_(std::move(material)), layout_(D, strain_size), across_(D == 2 && strain_size == 4) {
  layout_.unite(Fields<field::Position, field::Velocity, field::Mass, field::ElasticStrain>{});
  material_->declare(layout_);
  layout_.unite(Fields<field::Identity>{});
  material_->bind(layout_);
  places_ = {layout_.find(field::position),  layout_.find(field::velocity),   layout_.find(field::mass),
             layout_.find("elastic_strain"), layout_.find("affine_velocity"), layout_.find(field::identity)};
  chunk_.assign(static_cast<std::size_t>(layout_.packs()), Lanes(0.0));
  chunk_[static_cast<std::size_t>(places_.mass)] = Lanes(material_->density);  // of unit volume
  std::vector<std::pair<int, double>> values;
  material_->start(values);
  for (auto const& [pack, value] : values) chunk_[static_cast<std::size_t>(pack)] = Lanes(value);
}

template <int D>
bool MaterialPoint<D>::leads(int component) const {
  auto const [i, j] = places_of[static_cast<std::size_t>(component)];
  return i < D && j < D;
}

template <int D>
Batch<D> MaterialPoint<D>::batch(Chunk& chunk) const {
  Batch<D> b;
  b.chunks = chunk.data();
  b.ahead = chunk.data();
  b.count = 1;
  b.particles = lanes;
  b.stride = layout_.packs();
  b.at = places_;
  b.spacing = 1;
  b.first.fill(0);
  return b;
}

template <int D>
std::vector<Components6> MaterialPoint<D>::after(std::span<Components6 const> motions, double dt, Chunk& chunk) const {
  chunk = chunk_;
  Matrix<Lanes, D> gradient;
  for (std::size_t c = 0; c < 6; ++c) {
    auto const [i, j] = places_of[c];
    if (i >= D || j >= D) continue;
    for (int lane = 0; lane < lanes; ++lane)
      gradient(i, j).set(lane, motions[std::min(static_cast<std::size_t>(lane), motions.size() - 1)][c]);
  }
  Motion lost;
  Load<D> load;
  material_->update(batch(chunk), &gradient, dt, lost, &load, false, nullptr);
  std::vector<Lanes> derived;
  material_->derive(batch(chunk), 0, derived);
  std::vector<Components6> stresses(motions.size());
  for (std::size_t m = 0; m < motions.size(); ++m) {
    int const lane = static_cast<int>(m);
    for (std::size_t c = 0; c < 6; ++c) {
      auto const [i, j] = places_of[c];
      if (i < D && j < D) stresses[m][c] = load.force(i, j)[lane];
    }
    if (across_) stresses[m][2] = -3 * derived[0][lane] - stresses[m][0] - stresses[m][1];  // derived: p first
  }
  return stresses;
}

/// Newton's method for the motions `free`; the Jacobian by differences, which are lanes of one step of the law, as are
/// the eight lengths that a Newton step may take.
template <int D>
Components6 MaterialPoint<D>::solve(Components6 motion, std::vector<std::size_t> const& free,
                                    std::array<std::optional<double>, 6> const& targets, double dt) {
  auto const n = static_cast<Eigen::Index>(free.size());
  Chunk chunk;
  auto const miss = [&](Components6 const& stress) {
    Eigen::VectorXd r(n);
    for (Eigen::Index k = 0; k < n; ++k)
      r[k] = stress[free[static_cast<std::size_t>(k)]] - *targets[free[static_cast<std::size_t>(k)]];
    return r;
  };
  double const modulus = material_->volumetric_modulus();
  for (iterations_ = 1; iterations_ <= 100; ++iterations_) {
    double const nudge = std::max(1e-6 * largest(motion), 1e-12);
    std::vector<Components6> tries(free.size() + 1, motion);
    for (std::size_t k = 0; k < free.size(); ++k) tries[k + 1][free[k]] += nudge;
    auto const stresses = after(tries, dt, chunk);
    Eigen::VectorXd const r = miss(stresses[0]);
    double const scale = std::max(largest(stresses[0]), largest(stress_));
    if (r.lpNorm<Eigen::Infinity>() <= 1e-12 * scale + 1e-16 * modulus) return motion;
    Eigen::MatrixXd jacobian(n, n);
    for (Eigen::Index k = 0; k < n; ++k)
      jacobian.col(k) = (miss(stresses[static_cast<std::size_t>(k) + 1]) - r) / nudge;
    Eigen::VectorXd const full = -jacobian.completeOrthogonalDecomposition().solve(r);
    std::vector<Components6> shorter(static_cast<std::size_t>(lanes), motion);
    for (std::size_t m = 0; m < shorter.size(); ++m)
      for (std::size_t k = 0; k < free.size(); ++k)
        shorter[m][free[k]] += std::ldexp(full[static_cast<Eigen::Index>(k)], -static_cast<int>(m));
    auto const results = after(shorter, dt, chunk);
    std::size_t best = 0;
    for (std::size_t m = 1; m < results.size(); ++m)
      if (!(miss(results[best]).norm() <= miss(results[m]).norm())) best = m;
    bool const settled = !(miss(results[best]).norm() < r.norm());
    if (settled && r.lpNorm<Eigen::Infinity>() <= 1e-9 * scale) return motion;  // no digits are left to gain
    motion = shorter[best];
    if (settled && iterations_ > 20) break;
  }
  std::string names;
  for (std::size_t const c : free) names += (names.empty() ? "" : ", ") + std::string(component_names[c]);
  throw RunError(
      "at t = " + std::to_string(time_) + " s no motion was found that brings the stress " + names +
      " to its target in one step: the law cannot carry it, or not so fast. Take shorter steps, ask for less, "
      "or lead the motion instead of the stress");
}

template <int D>
void MaterialPoint<D>::step(Components6 const& motion, std::array<std::optional<double>, 6> const& targets,
                            double until) {
  double const dt = until - time_;
  Components6 led = motion;
  std::vector<std::size_t> free;
  for (std::size_t c = 0; c < 6; ++c)
    if (targets[c]) {
      free.push_back(c);
      // as in the last step; at first as if an isotropic pressure were wanted, under which every law is elastic
      led[c] =
          last_dt_ > 0 ? last_motion_[c] * dt / last_dt_ : (*targets[c] - stress_[c]) / material_->volumetric_modulus();
    }
  iterations_ = 0;
  if (!free.empty()) led = solve(led, free, targets, dt);
  commit(led, dt);
  time_ = until;
}

template <int D>
void MaterialPoint<D>::commit(Components6 const& motion, double dt) {
  Chunk chunk;
  Components6 const stress = after({&motion, 1}, dt, chunk).front();
  for (std::size_t c = 0; c < 6; ++c) {
    if (!std::isfinite(stress[c]) || !std::isfinite(motion[c]))
      throw RunError("at t = " + std::to_string(time_) + " s the stress " + std::string(component_names[c]) +
                     " is not finite; take shorter steps");
    if (c < 3 && motion[c] <= -1)
      throw RunError("at t = " + std::to_string(time_) + " s a step turns the point inside out; take shorter steps");
    work_ += 0.5 * (stress[c] + stress_[c]) * motion[c];
    strain_[c] += motion[c];
  }
  chunk_ = chunk;
  stress_ = stress;
  last_motion_ = motion;
  last_dt_ = dt;
}

template <int D>
std::vector<Quantity> MaterialPoint<D>::quantities() const {
  std::vector<Quantity> list{{"time", "t", "s", "time"}};
  for (int c = 0; c < 6; ++c) {
    std::string const name(component_names[static_cast<std::size_t>(c)]);
    if (leads(c)) list.push_back({"strain_" + name, "e", "1", "integral of the velocity gradient " + name});
  }
  for (int c = 0; c < 6; ++c) {
    std::string const name(component_names[static_cast<std::size_t>(c)]);
    if (leads(c) || (across_ && c == 2)) list.push_back({"stress_" + name, "tau", "Pa", "Kirchhoff stress " + name});
  }
  list.push_back({"volume_strain", "ln J", "1", "logarithm of volume over initial volume; positive in dilation"});
  list.push_back(
      {"work", "W", "J/m^3", "work of the stress since the start, per reference volume; of first order in the step"});
  list.push_back({"elastic_energy", "Psi", "J/m^3", "stored energy per reference volume"});
  list.push_back({"stress_ratio", "q/p", "1", "shear stress over pressure; 0 where there is no pressure"});
  list.push_back({"iterations", "k", "1", "iterations of the last search for a stress"});
  auto const add = [&](FieldInfo const& info) {
    list.push_back(
        {std::string(info.name), std::string(info.symbol), std::string(info.unit), std::string(info.meaning)});
  };
  for (FieldInfo const& info : material_->derived()) add(info);
  for (Column const& column : layout_.columns())
    if (column.offset > places_.strain && column.offset < places_.identity) add(column.info);
  return list;
}

template <int D>
std::vector<double> MaterialPoint<D>::measure() const {
  std::vector<double> row{time_};
  for (int c = 0; c < 6; ++c)
    if (leads(c)) row.push_back(strain_[static_cast<std::size_t>(c)]);
  for (int c = 0; c < 6; ++c)
    if (leads(c) || (across_ && c == 2)) row.push_back(stress_[static_cast<std::size_t>(c)]);
  std::vector<Lanes> derived;
  material_->derive(batch(chunk_), 0, derived);
  Batch<D> one = batch(chunk_);
  one.particles = 1;
  double const p = derived[0][0], q = derived[1][0];
  row.insert(row.end(), {std::log(derived[2][0]), work_, material_->elastic_energy(one), p > 0 ? q / p : 0,
                         static_cast<double>(iterations_)});
  for (Lanes const& value : derived) row.push_back(value[0]);
  for (Column const& column : layout_.columns())
    if (column.offset > places_.strain && column.offset < places_.identity)
      row.push_back(chunk_[static_cast<std::size_t>(column.offset)][0]);
  return row;
}

template class MaterialPoint<2>;
template class MaterialPoint<3>;

}  // namespace talus
