#pragma once
/// What is composed, in words: what core/experiment_of.hpp declares.

#include "core/experiment_of.hpp"
#include "core/in_short.hpp"

namespace talus {

/// A limit of core/time_step.hpp with what sets it.
template <int D>
std::string limit_in_words(Scene<D> const& scene, std::string_view limiter) {
  StepLimits const& limits = scene.limits;
  if (limiter == "elastic")
    return in_short(limits.safety) + " of what a particle of " + stiffest(scene).material->name +
           " without neighbours bears (/time/safety)";
  if (limiter == "crossing")
    return "a particle may cross " + in_short(limits.crossing) + " of a cell in a step (/time/crossing)";
  if (limiter == "gradient") return "dt |L| may be " + in_short(limits.gradient) + " (/time/gradient)";
  return "the end is landed on";
}

template <int D>
Explanation ExperimentOf<D>::explain() const {
  Scene<D> const& scene = simulation_->scene();
  Layout const& layout = simulation_->particles().layout();
  Stages<D> const& stages = *scene.stages;
  Explanation told;
  told.policies = policies_;
  for (Column const& c : layout.columns())
    told.fields.push_back({std::string(c.info.name), std::string(c.info.symbol) + " [" + std::string(c.info.unit) +
                                                         "], " + std::to_string(8 * c.components) +
                                                         " B: " + std::string(c.info.meaning)});
  auto const when = [](bool yes, std::vector<Explanation::Line>& here, std::vector<Explanation::Line>& there,
                       Explanation::Line line, Explanation::Line otherwise) {
    if (yes)
      here.push_back(std::move(line));
    else
      there.push_back(std::move(otherwise));
  };
  bool const affine = layout.find("affine_velocity") >= 0;
  told.stages.push_back({"load", "stress of each particle from its elastic strain"});
  told.stages.push_back({"particles to grid", std::string("mass, momentum") + (affine ? " with affine term" : "") +
                                                  ", internal force" +
                                                  (stages.friction ? ", friction of the material" : "")});
  told.stages.push_back({"grid", "arenas summed in fixed order, nodes accelerated"});
  when(!scene.walls.empty(), told.stages, told.left_out,
       {"walls", std::to_string(scene.walls.size()) + " walls, only at nodes near them"}, {"walls", "there are none"});
  when(stages.remaps, told.stages, told.left_out, {"remap", "moved particles back to the grid, walls again (MUSL)"},
       {"remap", "the integrator takes the gradient from the moved nodes"});
  told.stages.push_back({"grid to particles", "velocity, position, dt L"});
  told.stages.push_back({"law", "trial strain, return map, state"});
  when(scene.keeps_ledger, told.stages, told.left_out,
       {"ledger", "work, losses and angular momentum of the step, each by a sum of its own"},
       {"ledger", "/output/ledger is none"});
  if (!affine) told.left_out.push_back({"affine velocity", "not stored: the transfer's mode is constant"});
  if (!stages.incremental && !stages.remaps)
    told.left_out.push_back({"second node velocity", "no increment and no remap asks for one"});
  if (!stages.friction) told.left_out.push_back({"friction field", "no wall takes its friction from the material"});
  told.left_out.push_back({"stress, deformation gradient", "never stored: the elastic strain gives both"});
  bool const periodic = std::any_of(scene.periods.begin(), scene.periods.end(), [](auto n) { return n > 0; });
  if (!periodic) told.left_out.push_back({"periodicity", "no axis repeats"});
  told.dimension = D;
  told.bytes_per_particle = layout.bytes_per_particle();
  std::ptrdiff_t slots = 0;
  for (Run const& run : simulation_->particles().runs()) slots += std::ptrdiff_t{run.chunks()} * lanes;
  told.padded_bytes_per_particle = told.bytes_per_particle * double(slots) / double(particles());
  told.particles = particles();
  told.blocks = simulation_->grid().particle_blocks();
  told.bytes = simulation_->bytes();
  told.spacing = scene.spacing;
  told.first_step = simulation_->next(std::numeric_limits<double>::infinity());
  told.limited_by = limit_in_words(scene, told.first_step.limiter);
  for (auto const& m : scene.materials)
    told.wave_speed = std::max(told.wave_speed, std::sqrt(m->wave_modulus() / m->density));
  told.courant = told.wave_speed * told.first_step.dt / scene.spacing;
  return told;
}

}  // namespace talus
