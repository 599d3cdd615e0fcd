#include "verification/suite/settled_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "models/boundaries/contacts/mirrored_stick.hpp"
#include "models/boundaries/make_wall.hpp"
#include "models/boundaries/motions/fixed.hpp"
#include "models/boundaries/shapes/half_space.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/laws/cam_clay_mu_i.hpp"
#include "verification/reference/flow/interpolated.hpp"
#include "verification/reference/flow/motion.hpp"
#include "verification/suite/setup.hpp"

namespace talus::verification {

namespace {

using reference::flow::CompressiblePluggedLayer;

constexpr std::size_t parcels = 2000;  // of equal mass in a SteadyLayer

double unstrained_height(double h_0, std::size_t k) {
  return h_0 * (double(k) + 0.5) / double(parcels);
}

/// What all particles of a row begin with.
struct Row {
  double Y, y, p, p_c, stretch;
};

std::vector<Row> rows_of(SettledColumn const& column) {
  int const n = column.cells * column.per_axis;
  std::vector<Row> rows;
  for (int k = 0; k < n; ++k) {
    double const Y = column.layer.layer.h_0 * (k + 0.5) / n;
    rows.push_back(
        {Y, column.layer.height(Y), column.layer.pressure(Y), column.layer.strength(Y), column.layer.stretch(Y)});
  }
  return rows;
}

/// Row by row from the base at each place along the slope.
std::vector<Seed<2>> seeds_of(SettledColumn const& column, std::vector<Row> const& rows) {
  reference::flow::Fluid const& fluid = column.layer.layer.fluid;
  double const h = column.layer.layer.h_0 / column.cells, apart = h / column.per_axis;
  double const half = 0.25 * h;  // of the affine velocity's reach
  std::vector<Seed<2>> seeds;
  for (int i = 0; i < column.width * column.per_axis; ++i)
    for (Row const& row : rows) {
      Seed<2> seed;
      seed.x = {(i + 0.5) * apart, row.y};
      seed.v = {column.speed(row.Y), 0};
      seed.C(0, 1) = (column.speed(row.Y + half) - column.speed(row.Y - half)) / (2 * half * row.stretch);
      seed.mass = fluid.density * apart * apart;
      double const each = -row.p / (2 * fluid.elastic.K());
      double const shear = column.sheared ? row.p * std::tan(column.layer.layer.slope) / (2 * fluid.elastic.G()) : 0;
      seed.strain = {each, each, shear};
      seeds.push_back(seed);
    }
  return seeds;
}

law::CamClayMuI::Parameters parameters_of(reference::flow::Fluid const& fluid) {
  law::CamClayMuI::Parameters law;
  law.E = fluid.elastic.E, law.nu = fluid.elastic.nu;
  law.p_c0 = fluid.hardening.p_c0, law.xi = fluid.hardening.xi, law.beta = fluid.beta;
  law.mu_1 = fluid.friction.mu_1, law.mu_2 = fluid.friction.mu_2, law.I_0 = fluid.friction.I_0;
  law.d = fluid.friction.d, law.rho_s = fluid.friction.rho_s;
  return law;
}

std::unique_ptr<Simulation<2>> begin_settled(SettledColumn const& column) {
  reference::flow::Fluid const& fluid = column.layer.layer.fluid;
  double const slope = column.layer.layer.slope;
  auto scene = scene_of<kinematics::PlaneStrainReduced, law::CamClayMuI>(
      column.scheme, column.layer.layer.h_0 / column.cells, fluid.density, parameters_of(fluid));
  scene.gravity = reference::flow::gravity * Point<2>(std::sin(slope), -std::cos(slope));
  scene.periods = {column.width / block_edge, 0};
  wall::HalfSpace::Parameters const base{{0, 0, 0}, {0, 1, 0}};
  scene.walls.push_back(make_wall<2, wall::HalfSpace, wall::MirroredStick, wall::Fixed>("base", base, {}, {}));
  auto const rows = rows_of(column);
  auto simulation = begin(std::move(scene), seeds_of(column, rows));
  Particles<2>& particles = simulation->particles();
  int const hardening = particles.layout().find("plastic_volumetric_strain"),
            number = particles.layout().find(field::identity);
  particles.for_each([&](std::ptrdiff_t slot, int) {
    Row const& row = rows[static_cast<std::size_t>(particles.get(slot, number)) % rows.size()];
    particles.set(slot, hardening, std::log(fluid.hardening.p_c0 / row.p_c) / fluid.hardening.xi);
  });
  return simulation;
}

std::vector<FlowSample> samples_of(Simulation<2> const& simulation) {
  auto const y = column(simulation, "position", 1), u = column(simulation, "velocity", 0),
             eps_V = column(simulation, "plastic_volumetric_strain", 0);
  std::vector<double> eps[3];
  for (int k = 0; k < 3; ++k) eps[k] = column(simulation, "elastic_strain", k);
  std::vector<FlowSample> samples;
  for (std::size_t p = 0; p < y.size(); ++p) samples.push_back({y[p], u[p], eps[0][p], eps[1][p], eps[2][p], eps_V[p]});
  return samples;
}

}  // namespace

CompressiblePluggedLayer bead_layer(double slope, double beta, double kept, double limiting_angle) {
  return {{reference::flow::glass_beads(limiting_angle, beta), reference::flow::radians(slope), FlowColumn::height},
          kept};
}

SteadyLayer::SteadyLayer(CompressiblePluggedLayer const& layer) {
  std::vector<double> Y;
  for (std::size_t k = 0; k < parcels; ++k) Y.push_back(unstrained_height(layer.layer.h_0, k));
  double J = 0;
  for (double const at : Y) J += layer.stretch(at) / double(parcels);
  solid_fraction = layer.layer.fluid.solid_fraction() / J;
  if (layer.kept > 0) {
    for (double const at : Y) {
      y.push_back(layer.height(at));
      u.push_back(layer.speed(reference::flow::speed_by_quadrature, at));
    }
    top_speed = u.back();
  } else {
    auto const exact = profile_by_quadrature(layer.layer, Y);
    for (auto const& at : exact.at) y.push_back(at.y), u.push_back(at.u);
    top_speed = exact.surface_speed;
  }
  profile = sliced(y, u);
  thickness = 2 * std::accumulate(y.begin(), y.end(), 0.0) / double(parcels);
}

double SteadyLayer::speed(double below) const {
  if (below < 0) return -speed(-below);
  double const place = std::clamp(below * double(parcels) - 0.5, 0.0, double(parcels) - 1);
  auto const k = std::min(static_cast<std::size_t>(place), parcels - 2);
  return u[k] + (place - double(k)) * (u[k + 1] - u[k]);
}

std::vector<FlowProfile> profiles_of(SettledColumn const& column, std::vector<double> const& times, Cost& cost) {
  auto const simulation = begin_settled(column);
  auto const begun = std::chrono::steady_clock::now();
  std::vector<FlowProfile> profiles;
  for (double const t : times) {
    while (simulation->time() < t) simulation->advance(t);
    profiles.push_back(profile_of(samples_of(*simulation), column.layer.layer.fluid.elastic));
  }
  cost.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  cost.steps += simulation->step_count();
  cost.particle_steps += double(simulation->step_count()) * double(simulation->particles().count());
  return profiles;
}

SettledColumn steady_column(CompressiblePluggedLayer const& layer, SteadyLayer const& exact, int cells) {
  double const h_0 = layer.layer.h_0;
  return {layer, [exact, h_0](double Y) { return exact.speed(Y / h_0); }, true, cells};
}

void compare_with_layer(Findings& findings, std::string const& name, FlowProfile const& flow, SteadyLayer const& exact,
                        double asked, std::string const& because, Cost const& cost) {
  double const surface = flow.surface() / exact.surface() - 1, profile = profile_error(flow, exact.profile);
  if (asked > 0) {
    findings.check(name, "error of the surface speed", surface, {-asked, asked}, because, cost);
    findings.check(name, "error of the profile", profile, at_most(asked), because);
  } else {
    findings.note(name, "error of the surface speed", surface, because, cost);
    findings.note(name, "error of the profile", profile, because);
  }
}

std::vector<ExactProfile> exact_motion(reference::flow::CompressibleLayer const& layer,
                                       std::function<double(double)> const& speed, std::vector<double> const& times) {
  using reference::flow::interpolated;
  reference::flow::Motion const motion{layer.fluid, layer.slope, layer.h_0, reference::flow::Motion::Volume::critical,
                                       speed,       false};
  std::vector<ExactProfile> profiles;
  for (auto const& at : extrapolated_motion(motion, 100, times, 1e-9).at) {
    std::vector<double> y, u;
    for (std::size_t k = 0; k < parcels; ++k) {
      double const Y = unstrained_height(layer.h_0, k);
      y.push_back(interpolated(at.Y, at.y, Y));
      u.push_back(interpolated(at.Y, at.u, Y));
    }
    profiles.push_back(sliced(y, u));
  }
  return profiles;
}

Moved check_motion(Findings& findings, std::string const& name, SettledColumn const& column,
                   std::vector<double> const& times, double bar) {
  Cost cost;
  Moved moved{profiles_of(column, times, cost), exact_motion(column.layer.layer, column.speed, times)};
  Plot plot{name + ": u over y", "y [m]", "u [m/s]"};
  for (std::size_t k = 0; k < times.size(); ++k) {
    findings.check(name, fmt::format("error of the profile at {:.3g} s", times[k]),
                   profile_error(moved.found[k], moved.exact[k]), at_most(bar),
                   fmt::format("{:g} %; method of lines by CVODE, extrapolated", 100 * bar), k == 0 ? cost : Cost{});
    plot.curves.push_back({fmt::format("{:.3g} s", times[k]), moved.found[k].y, moved.found[k].u});
    plot.curves.push_back({fmt::format("exact, {:.3g} s", times[k]), moved.exact[k].y, moved.exact[k].u, true});
  }
  findings.plots.push_back(plot);
  return moved;
}

}  // namespace talus::verification
