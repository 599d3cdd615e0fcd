#include "verification/suite/flow_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "core/cli/program.hpp"
#include "core/io/files.hpp"
#include "models/boundaries/contacts/mirrored_stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "verification/reference/flow/compressible_layer.hpp"
#include "verification/reference/flow/interpolated.hpp"
#include "verification/suite/places.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

NamedColumn const& named(Snapshot const& snapshot, std::string const& name) {
  return *std::ranges::find(snapshot.columns, name, &NamedColumn::name);
}

/// A particle as far as a profile needs it.
struct Sample {
  double y, u, eps_xx, eps_yy, eps_xy;
};

std::vector<Sample> samples_of(Snapshot const& snapshot) {
  auto const &x = named(snapshot, "position").values, &v = named(snapshot, "velocity").values,
             &eps = named(snapshot, "elastic_strain").values;
  std::vector<Sample> samples;
  for (std::size_t p = 0; 2 * p < x.size(); ++p)
    samples.push_back({x[2 * p + 1], v[2 * p], eps[3 * p], eps[3 * p + 1], eps[3 * p + 2]});
  return samples;
}

std::vector<Sample> samples_of(Simulation<2> const& simulation) {
  auto const y = column(simulation, "position", 1), u = column(simulation, "velocity", 0);
  std::vector<double> eps[3];
  for (int k = 0; k < 3; ++k) eps[k] = column(simulation, "elastic_strain", k);
  std::vector<Sample> samples;
  for (std::size_t p = 0; p < y.size(); ++p) samples.push_back({y[p], u[p], eps[0][p], eps[1][p], eps[2][p]});
  return samples;
}

FlowProfile profile_of(std::vector<Sample> samples) {
  reference::Elasticity const elastic = reference::flow::glass_beads(40, 0).elastic;
  std::ranges::sort(samples, {}, &Sample::y);
  std::size_t const n = samples.size();
  FlowProfile profile;
  std::vector<double> square(slices), count(slices);
  for (std::size_t k = 0; k < n; ++k) {
    Sample const& one = samples[k];
    std::size_t const s = k * slices / n;
    double const volume = one.eps_xx + one.eps_yy, pressure = -elastic.K() * volume;
    profile.y[s] += one.y;
    profile.u[s] += one.u;
    profile.pressure[s] += pressure;
    profile.shear_stress[s] += 2 * elastic.G() * one.eps_xy;
    profile.normal_stress[s] -= elastic.lambda() * volume + 2 * elastic.G() * one.eps_yy;
    square[s] += pressure * pressure;
    count[s] += 1;
    profile.thickness += 2 * one.y / double(n);
  }
  for (std::size_t s = 0; s < slices; ++s) {
    for (auto* list :
         {&profile.y, &profile.u, &profile.pressure, &profile.shear_stress, &profile.normal_stress, &square})
      (*list)[s] /= count[s];
    double const mean = profile.pressure[s];
    if (s >= 2 && s < slices - 2)
      profile.scatter += std::sqrt(std::max(0.0, square[s] / (mean * mean) - 1)) / (slices - 4);
  }
  return profile;
}

/// Three particles along each axis of a cell of the unstrained layer, 12 cells along the slope.
std::vector<Seed<2>> settled_seeds(SettledColumn const& column, reference::flow::Fluid const& fluid) {
  double const h = FlowColumn::height / column.cells;
  auto const lattice_places = lattice<2>({0, 0}, {12, column.cells}, {3, 3}, h);
  std::vector<double> Y;
  for (auto const& X : lattice_places) Y.push_back(X[1]);
  auto const at = reference::flow::small_shear_profile({fluid, column.slope, FlowColumn::height}, Y).at;
  std::vector<Seed<2>> seeds;
  for (std::size_t k = 0; k < Y.size(); ++k) {
    Seed<2> seed;
    seed.x = {lattice_places[k][0], at[k].y};
    double const half = 0.25 * h;  // of the affine velocity's reach
    seed.v = {column.speed(Y[k]), 0};
    seed.C(0, 1) = (column.speed(Y[k] + half) - column.speed(Y[k] - half)) / (2 * half * at[k].stretch);
    seed.mass = fluid.density * h * h / 9;
    double const each = -at[k].p / (2 * fluid.elastic.K());
    seed.strain = {each, each, 0};
    seeds.push_back(seed);
  }
  return seeds;
}

std::unique_ptr<Simulation<2>> begin_settled(SettledColumn const& column) {
  reference::flow::Fluid const fluid = reference::flow::glass_beads(40, 0);
  law::CamClayMuI::Parameters law;
  law.mu_1 = column.mu_1;
  law.mu_2 = column.mu_2;
  auto scene = scene_of<kinematics::PlaneStrainReduced, law::CamClayMuI>(
      column.scheme, FlowColumn::height / column.cells, fluid.density, law);
  scene.gravity = reference::flow::gravity * Point<2>(std::sin(column.slope), -std::cos(column.slope));
  scene.periods = {12 / block_edge, 0};
  wall::HalfSpace::Parameters const base{{0, 0, 0}, {0, 1, 0}};
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::MirroredStick, wall::Fixed>("base", base, {}, {}));
  auto simulation = begin(std::move(scene), settled_seeds(column, fluid));
  Particles<2>& particles = simulation->particles();
  int const strain = particles.layout().find("elastic_strain"),
            hardening = particles.layout().find("plastic_volumetric_strain");
  particles.for_each([&](std::ptrdiff_t slot, int) {
    double const p = -2 * fluid.elastic.K() * particles.get(slot, strain);
    particles.set(slot, hardening, std::log(law.p_c0 / (2 * p)) / law.xi);
  });
  return simulation;
}

}  // namespace

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
  std::string const file = std::string(studies) + "/" + study;
  Document document = parse(io::read_file(file), file);
  set_value(document, R"(/output/ledger={"type": "none"})");
  for (std::string const& change : changes) set_value(document, change);
  Composed const composed = program().compose(document);
  Experiment& experiment = *composed.experiment;
  auto const begun = std::chrono::steady_clock::now();
  std::vector<FlowProfile> profiles;
  for (double const t : times) {
    while (experiment.time() < t) experiment.advance(t);
    profiles.push_back(profile_of(samples_of(experiment.state())));
  }
  cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.steps += experiment.steps();
  cost.particle_steps += double(experiment.steps()) * double(experiment.particles());
  return profiles;
}

std::vector<FlowProfile> profiles_of(SettledColumn const& column, std::vector<double> const& times, Cost& cost) {
  auto const simulation = begin_settled(column);
  auto const begun = std::chrono::steady_clock::now();
  std::vector<FlowProfile> profiles;
  for (double const t : times) {
    while (simulation->time() < t) simulation->advance(t);
    profiles.push_back(profile_of(samples_of(*simulation)));
  }
  cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.steps += simulation->step_count();
  cost.particle_steps += double(simulation->step_count()) * double(simulation->particles().count());
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
    mean.scatter += share * one.scatter;
  }
  return mean;
}

double profile_error(FlowProfile const& profile, std::vector<double> const& y, std::vector<double> const& u) {
  double off = 0, all = 0;
  for (std::size_t s = 0; s < slices; ++s) {
    double const exact = reference::flow::interpolated(y, u, std::min(profile.y[s], y.back()));
    off += (profile.u[s] - exact) * (profile.u[s] - exact);
    all += exact * exact;
  }
  return std::sqrt(off / all);
}

std::vector<double> evenly(double from, double to, int n) {
  std::vector<double> times;
  for (int k = 0; k <= n; ++k) times.push_back(from + (to - from) * k / n);
  return times;
}

}  // namespace talus::verification
