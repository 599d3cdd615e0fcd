#pragma once
/// The document of a case: what is simulated, with which policies, and what is kept of it.
///
/// One table an object; reading, checks, schema, manual and echo derive from them (core/config).

#include <optional>
#include <string>
#include <vector>

#include "core/config/choice.hpp"
#include "models/catalogue_bodies.hpp"
#include "models/catalogue_contacts.hpp"
#include "models/catalogue_integrators.hpp"
#include "models/catalogue_kernels.hpp"
#include "models/catalogue_kinematics.hpp"
#include "models/catalogue_motions.hpp"
#include "models/catalogue_seedings.hpp"
#include "models/catalogue_shapes.hpp"
#include "models/catalogue_transfers.hpp"
#include "models/catalogue_velocity_fields.hpp"
#include "models/chosen_law.hpp"
#include "models/stations.hpp"

namespace talus {

struct GridEntry {
  double spacing = 0.01;
  std::vector<double> periods;
  static constexpr auto table() {
    return std::tuple{
        parameter(&GridEntry::spacing, "spacing", "h", "m", "distance between grid nodes", positive).required(),
        parameter(&GridEntry::periods, "periods", "L", "m",
                  "length after which each axis repeats, 0 where it does not; a multiple of four cells", non_negative)};
  }
};

struct MaterialEntry {
  std::string name;
  double density = 1000;
  OpenChoice<ChosenLaw> law;
  static constexpr auto table() {
    return std::tuple{
        parameter(&MaterialEntry::name, "name", "how bodies refer to it").required(),
        parameter(&MaterialEntry::density, "density", "rho", "kg/m^3", "bulk density before deformation", positive)
            .usual(10, 3e4)
            .required(),
        parameter(&MaterialEntry::law, "law", "constitutive law").required()};
  }
};

struct BodyEntry {
  std::string name, material;
  Choice<catalogue::Bodies> shape;
  Choice<catalogue::Seedings> seeding;
  Choice<catalogue::VelocityFields> velocity = Choice<catalogue::VelocityFields>::of<body::AtRest>();
  static constexpr auto table() {
    return std::tuple{parameter(&BodyEntry::name, "name", "what the body is called").required(),
                      parameter(&BodyEntry::material, "material", "name of its material").required(),
                      parameter(&BodyEntry::shape, "shape", "region that it fills").required(),
                      parameter(&BodyEntry::seeding, "seeding", "how it is filled with particles").required(),
                      parameter(&BodyEntry::velocity, "velocity", "initial velocity")};
  }
};

struct WallEntry {
  std::string name;
  Choice<catalogue::Shapes> shape;
  Choice<catalogue::Contacts> contact;
  Choice<catalogue::Motions> motion = Choice<catalogue::Motions>::of<wall::Fixed>();
  static constexpr auto table() {
    return std::tuple{parameter(&WallEntry::name, "name", "what the wall is called").required(),
                      parameter(&WallEntry::shape, "shape", "its geometry").required(),
                      parameter(&WallEntry::contact, "contact", "what it does to what touches it").required(),
                      parameter(&WallEntry::motion, "motion", "how it moves")};
  }
};

/// g (sin theta, -cos theta[, 0]): the first axis points down the slope, the second away from the bed.
struct GravityEntry {
  double magnitude = 9.81, slope_deg = 0;
  static constexpr auto table() {
    return std::tuple{
        parameter(&GravityEntry::magnitude, "magnitude", "g", "m/s^2", "acceleration of gravity", non_negative),
        parameter(&GravityEntry::slope_deg, "slope_deg", "theta", "deg", "slope of the first axis, downwards positive",
                  closed(-180, 180))};
  }
};

struct TimeEntry {
  double end = 1, safety = 0.8, crossing = 0.5, gradient = 0.2;
  static constexpr auto table() {
    return std::tuple{
        parameter(&TimeEntry::end, "end", "t_end", "s", "time at which the run ends", non_negative).required(),
        parameter(&TimeEntry::safety, "safety", "", "1", "share of the elastic bound on the time step",
                  closed(1e-6, 2)),
        parameter(&TimeEntry::crossing, "crossing", "", "1", "cells that a particle may cross in a step",
                  closed(1e-6, 0.5)),
        parameter(&TimeEntry::gradient, "gradient", "", "1", "largest dt |L| of a step", closed(1e-6, 0.5))};
  }
};

/// Whether a run accounts for energy and angular momentum.
namespace ledger {
struct EachStep {
  static constexpr std::string_view name = "each_step",
                                    title = "Every term of energy and angular momentum is summed up in every step";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};
struct None {
  static constexpr std::string_view name = "none", title = "Nothing is summed up; a step is the faster for it";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};
}  // namespace ledger

struct OutputEntry {
  double frames_every = 0.1, series_every = 0.002, checkpoints_every = 0.1;
  Choice<TypeList<ledger::EachStep, ledger::None>> ledger =
      Choice<TypeList<ledger::EachStep, ledger::None>>::of<ledger::EachStep>();
  std::optional<double> profiles_every;
  std::vector<StationEntry> stations;
  static constexpr auto table() {
    return std::tuple{
        parameter(&OutputEntry::frames_every, "frames_every", "", "s", "time between frames", at_least(1e-9)),
        parameter(&OutputEntry::series_every, "series_every", "", "s", "time between rows of the series",
                  at_least(1e-9)),
        parameter(&OutputEntry::checkpoints_every, "checkpoints_every", "", "s", "time between checkpoints",
                  at_least(1e-9)),
        parameter(&OutputEntry::ledger, "ledger", "the account of energy and angular momentum in the summary"),
        parameter(&OutputEntry::stations, "stations", "boxes in which the flow is measured, for series and profiles"),
        parameter(&OutputEntry::profiles_every, "profiles_every", "", "s",
                  "time between the stations' profiles; as long as nothing is said, that between frames",
                  at_least(1e-9))};
  }
};

/// What a quantity of the series should be at a time, and why.
struct Expectation {
  std::string measure, because;
  double time = 0, value = 0, relative = 0, absolute = 0;
  static constexpr auto table() {
    return std::tuple{
        parameter(&Expectation::measure, "measure", "a column of the series").required(),
        parameter(&Expectation::time, "time", "t", "s", "when", non_negative).required(),
        parameter(&Expectation::value, "value", "", "1", "what is expected, in the measure's unit").required(),
        parameter(&Expectation::relative, "relative", "", "1", "tolerance as a share of the value", non_negative),
        parameter(&Expectation::absolute, "absolute", "", "1", "tolerance in the measure's unit; the larger one holds",
                  non_negative),
        parameter(&Expectation::because, "because", "where value and tolerance come from").required()};
  }
};

/// What a run simulates.
struct Case {
  std::string schema, title;
  std::vector<std::string> cite;
  Choice<catalogue::Kinematics> kinematics;
  GridEntry grid;
  Choice<catalogue::Kernels> kernel = Choice<catalogue::Kernels>::of<kernel::Quadratic>();
  Choice<catalogue::Transfers> transfer;
  Choice<catalogue::Integrators> integrator = Choice<catalogue::Integrators>::of<integrator::Usl>();
  std::vector<MaterialEntry> materials;
  std::vector<BodyEntry> bodies;
  std::vector<WallEntry> walls;
  GravityEntry gravity;
  TimeEntry time;
  OutputEntry output;
  std::vector<Expectation> expect;

  static constexpr std::string_view tag = "talus/case/1";
  static constexpr auto table() {
    return std::tuple{
        parameter(&Case::schema, "schema", "kind and version of the document: talus/case/1").required(),
        parameter(&Case::title, "title", "one line on what the case is").required(),
        parameter(&Case::cite, "cite", "DOIs of the work that the case stands on"),
        parameter(&Case::kinematics, "kinematics", "space, and the shape of strain and stress in it").required(),
        parameter(&Case::grid, "grid", "background grid").required(),
        parameter(&Case::kernel, "kernel", "weights between particles and nodes"),
        parameter(&Case::transfer, "transfer", "how velocities pass between particles and nodes").required(),
        parameter(&Case::integrator, "integrator", "order of the stages of a step"),
        parameter(&Case::materials, "materials", "materials").required().sized(1),
        parameter(&Case::bodies, "bodies", "bodies of particles").required().sized(1),
        parameter(&Case::walls, "walls", "walls"),
        parameter(&Case::gravity, "gravity", "gravity"),
        parameter(&Case::time, "time", "end and steps").required(),
        parameter(&Case::output, "output", "what is written, and how often"),
        parameter(&Case::expect, "expect", "what the run should give; a run that misses it ends with exit code 5")};
  }
};

}  // namespace talus
