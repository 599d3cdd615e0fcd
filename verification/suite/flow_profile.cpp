#include "verification/suite/flow_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verification/reference/flow/fluid.hpp"
#include "verification/suite/shipped.hpp"

namespace talus::verification {

namespace {

NamedColumn const& named(Snapshot const& snapshot, std::string const& name) {
  return *std::ranges::find(snapshot.columns, name, &NamedColumn::name);
}

std::vector<FlowSample> samples_of(Snapshot const& snapshot) {
  auto const &x = named(snapshot, "position").values, &v = named(snapshot, "velocity").values,
             &eps = named(snapshot, "elastic_strain").values,
             &eps_V = named(snapshot, "plastic_volumetric_strain").values;
  std::vector<FlowSample> samples;
  for (std::size_t p = 0; 2 * p < x.size(); ++p)
    samples.push_back({x[2 * p + 1], v[2 * p], eps[3 * p], eps[3 * p + 1], eps[3 * p + 2], eps_V[p]});
  return samples;
}

/// Means of y and p, and how p lies about its line over y: sums of products about the means (Welford).
struct Spread {
  double n = 0, mean_y = 0, mean_p = 0, yy = 0, yp = 0, pp = 0;

  void add(double y, double p) {
    n += 1;
    double const from_y = y - mean_y, from_p = p - mean_p;
    mean_y += from_y / n;
    mean_p += from_p / n;
    yy += from_y * (y - mean_y);
    yp += from_y * (p - mean_p);
    pp += from_p * (p - mean_p);
  }
  [[nodiscard]] double about_line() const { return std::sqrt(std::max(0.0, pp - (yy > 0 ? yp * yp / yy : 0)) / n); }
};

}  // namespace

FlowProfile profile_of(std::vector<FlowSample> samples, reference::Elasticity const& elastic) {
  std::ranges::sort(samples, {}, &FlowSample::y);
  std::size_t const n = samples.size();
  FlowProfile profile;
  std::vector<Spread> spreads(slices);
  for (std::size_t k = 0; k < n; ++k) {
    FlowSample const& one = samples[k];
    std::size_t const s = k * slices / n;
    double const volume = one.eps_xx + one.eps_yy, pressure = -elastic.K() * volume;
    spreads[s].add(one.y, pressure);
    profile.u[s] += one.u;
    profile.shear_stress[s] += 2 * elastic.G() * one.eps_xy;
    profile.normal_stress[s] -= elastic.lambda() * volume + 2 * elastic.G() * one.eps_yy;
    profile.thickness += 2 * one.y / double(n);
    profile.stretch += std::exp(volume + one.eps_V) / double(n);
  }
  for (std::size_t s = 0; s < slices; ++s) {
    for (auto* list : {&profile.u, &profile.shear_stress, &profile.normal_stress}) (*list)[s] /= spreads[s].n;
    profile.y[s] = spreads[s].mean_y;
    profile.pressure[s] = spreads[s].mean_p;
    if (s >= 2 && s < slices - 2) profile.scatter += spreads[s].about_line() / spreads[s].mean_p / (slices - 4);
  }
  return profile;
}

double FlowProfile::friction() const {
  return std::accumulate(shear_stress.begin(), shear_stress.end(), 0.0) /
         std::accumulate(pressure.begin(), pressure.end(), 0.0);
}

std::vector<std::string> FlowColumn::all_changes() const {
  double const h = height / cells, width = 12 * h;
  std::vector<std::string> all{fmt::format("/grid/spacing={}", h),
                               fmt::format("/grid/periods=[{}, 0]", width),
                               fmt::format("/gravity/slope_deg={}", slope),
                               "/bodies/0/shape/min=[0, 0]",
                               fmt::format("/bodies/0/shape/max=[{}, {}]", width, height),
                               R"(/bodies/0/seeding={"type": "lattice", "per_axis": 3})",
                               "/bodies/0/velocity/origin=[0, 0]",
                               fmt::format("/bodies/0/velocity/gradient=[[0, {}], [0, 0]]", gradient),
                               R"(/materials/0/law/type="cam_clay_mu_i_two_stage")",
                               R"(/walls/0/contact={"type": "mirrored_stick"})",
                               "/output/stations=[]"};
  all.insert(all.end(), changes.begin(), changes.end());
  return all;
}

std::vector<FlowProfile> profiles_of(std::string const& study, std::vector<std::string> const& changes,
                                     std::vector<double> const& times, Cost& cost) {
  Document document = shipped(study, changes);
  set_value(document, R"(/output/ledger={"type": "none"})");
  Composed const composed = program().compose(document);
  reference::Elasticity const elastic = reference::flow::glass_beads(40, 0).elastic;
  std::vector<FlowProfile> profiles;
  visit_times(*composed.experiment, times, cost,
              [&] { profiles.push_back(profile_of(samples_of(composed.experiment->state()), elastic)); });
  return profiles;
}

FlowProfile mean_of(std::vector<FlowProfile> const& profiles) {
  FlowProfile mean;
  double const share = 1.0 / double(profiles.size());
  for (FlowProfile const& one : profiles) {
    for (auto const list : {&FlowProfile::y, &FlowProfile::u, &FlowProfile::pressure, &FlowProfile::shear_stress,
                            &FlowProfile::normal_stress})
      for (std::size_t s = 0; s < slices; ++s) (mean.*list)[s] += share * (one.*list)[s];
    mean.thickness += share * one.thickness;
    mean.stretch += share * one.stretch;
    mean.scatter += share * one.scatter;
  }
  return mean;
}

ExactProfile sliced(std::vector<double> const& y, std::vector<double> const& u) {
  ExactProfile exact;
  double const share = double(slices) / double(y.size());
  for (std::size_t k = 0; k < y.size(); ++k) {
    exact.y[k * slices / y.size()] += share * y[k];
    exact.u[k * slices / y.size()] += share * u[k];
  }
  return exact;
}

double profile_error(FlowProfile const& profile, ExactProfile const& exact) {
  double off = 0, all = 0;
  for (std::size_t s = 0; s < slices; ++s) {
    auto const above = std::ranges::upper_bound(exact.y, profile.y[s]) - exact.y.begin();
    auto const k = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, slices - 1));
    double const slope = (exact.u[k] - exact.u[k - 1]) / (exact.y[k] - exact.y[k - 1]);
    double const u = exact.u[k] + slope * (profile.y[s] - exact.y[k]);
    off += (profile.u[s] - u) * (profile.u[s] - u);
    all += u * u;
  }
  return std::sqrt(off / all);
}

std::vector<double> evenly(double from, double to, int n) {
  std::vector<double> times;
  for (int k = 0; k <= n; ++k) times.push_back(from + (to - from) * k / n);
  return times;
}

}  // namespace talus::verification
