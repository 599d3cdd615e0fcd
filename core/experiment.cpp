#include "core/experiment.hpp"

namespace talus {

namespace {

void add_ledger(int D, std::vector<Quantity>& list) {
  for (int d = D == 2 ? 2 : 0; d < 3; ++d) {
    std::string const axis(axis_names[d]);
    list.push_back({"angular_momentum_" + axis, "L", "kg m^2/s", "angular momentum about the origin, along " + axis});
  }
  list.push_back({"kinetic_energy_affine", "K", "J", "kinetic energy with that of the affine velocities"});
  list.push_back({"work_gravity", "W_g", "J", "work of gravity since the start"});
  list.push_back({"work_walls", "W_w", "J", "work of the walls since the start; friction takes energy: negative"});
  list.push_back({"work_plastic", "W_p", "J", "stored energy that the return maps have taken since the start"});
  list.push_back({"loss_transfer", "W_t", "J", "kinetic energy lost between particles and nodes since the start"});
  list.push_back({"loss_stepping", "W_s", "J", "energy lost to the finite length of the steps since the start"});
  list.push_back({"energy_residual", "", "1", "what the terms of the energy leave over, relative to the largest"});
}

}  // namespace

std::vector<Quantity> series_quantities(int D, std::vector<std::string> const& walls, bool ledger,
                                        std::vector<Station> const& stations) {
  std::vector<Quantity> list{{"time", "t", "s", "time"},
                             {"step", "n", "1", "steps taken"},
                             {"dt", "dt", "s", "last time step"},
                             {"front", "x_f", "m", "advance of the farthest particle along x"}};
  for (int d = 0; d < D; ++d) {
    std::string const axis(axis_names[d]);
    list.push_back({"centre_of_mass_" + axis, "x_c", "m", "centre of mass along " + axis});
  }
  for (int d = 0; d < D; ++d) {
    std::string const axis(axis_names[d]);
    list.push_back({"mean_velocity_" + axis, "v_c", "m/s", "momentum over mass along " + axis});
  }
  list.push_back({"speed_rms", "v_rms", "m/s", "root mean square of the speed, by mass"});
  list.push_back({"speed_max", "v_max", "m/s", "largest speed"});
  list.push_back({"kinetic_energy", "E_k", "J", "kinetic energy of the particles' velocities"});
  list.push_back({"elastic_energy", "E_e", "J", "stored elastic energy"});
  list.push_back({"potential_energy", "E_g", "J", "potential energy of gravity, zero at the origin"});
  list.push_back(
      {"volume_ratio", "J", "1", "volume over initial volume of all particles; solid fraction is phi_0 / J"});
  for (std::string const& wall : walls)
    for (int d = 0; d < D; ++d)
      list.push_back(
          {"impulse_" + wall + "_" + std::string(axis_names[d]), "I", "kg m/s", "impulse of the wall since the start"});
  if (ledger) add_ledger(D, list);
  for (Station const& station : stations)
    for (Quantity& quantity : station_quantities(station)) list.push_back(std::move(quantity));
  return list;
}

}  // namespace talus
