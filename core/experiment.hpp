#pragma once
/// A composed case at run time, whatever its dimension: what running, resuming and explaining need of it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/checkpoint.hpp"
#include "core/station.hpp"
#include "core/time_step.hpp"

namespace talus {

/// The columns of the series in D dimensions with walls of these names.
/// ledger: with what the ledger tells.
[[nodiscard]] std::vector<Quantity> series_quantities(int D, std::vector<std::string> const& walls, bool ledger,
                                                      std::vector<Station> const& stations);

/// What is composed, for people: one line each.
struct Explanation {
  struct Line {
    std::string name, text;
  };
  std::vector<Line> policies;  ///< kind of policy and what was chosen
  std::vector<Line> fields;    ///< field, symbol and size a particle
  std::vector<Line> stages;    ///< what a step runs, in order
  std::vector<Line> left_out;  ///< what it does not store, compute or run, and why
  int dimension = 0;
  int bytes_per_particle = 0;            ///< of what the step stores
  double padded_bytes_per_particle = 0;  ///< with the empty lanes of partly filled chunks
  std::size_t particles = 0, blocks = 0, bytes = 0;
  double spacing = 0;
  TimeStep first_step;
  std::string limited_by;              ///< the limit of the first step, in words
  double wave_speed = 0, courant = 0;  ///< fastest wave [m/s]; c dt / h of the first step
};

/// What became of a quantity that is conserved: its terms, and what they leave over.
struct Balance {
  struct Term {
    std::string name;
    std::vector<double> value;
  };
  std::string name, unit;
  std::vector<Term> terms;
  std::vector<double> residual;
  double relative = 0;  ///< size of the residual over that of the largest term [1]
};

class Experiment {
 public:
  Experiment() = default;
  Experiment(Experiment const&) = delete;
  virtual ~Experiment() = default;

  [[nodiscard]] virtual double time() const = 0;
  [[nodiscard]] virtual long steps() const = 0;
  [[nodiscard]] virtual std::size_t particles() const = 0;
  /// One step towards `end`, on which the last one lands exactly. Throws RunError.
  virtual TimeStep advance(double end) = 0;
  /// Number of particle sorts so far.
  [[nodiscard]] virtual long sorts() const = 0;

  /// The columns of the series, and their values now.
  [[nodiscard]] virtual std::vector<Quantity> quantities() const = 0;
  [[nodiscard]] virtual std::vector<double> measure() const = 0;
  /// What the stations see over their depth now, one profile each. Their columns are the same at all times.
  [[nodiscard]] virtual std::vector<Profile> profiles() const = 0;

  /// Mass, momentum, angular momentum (where no axis repeats) and energy since the start; none where the case keeps no
  /// ledger.
  [[nodiscard]] virtual std::vector<Balance> balances() const = 0;

  /// What is stored of the particles, in the order of storage.
  [[nodiscard]] virtual Snapshot state() const = 0;
  /// That, and what can be computed from it: pressure, shear stress, volume ratio, what the laws derive.
  [[nodiscard]] virtual Snapshot frame() const = 0;

  /// All that a run needs to go on with the same bits.
  [[nodiscard]] virtual io::Checkpoint checkpoint() const = 0;
  /// Takes the state of a checkpoint of the same composition. Throws CheckpointError.
  virtual void restore(io::Checkpoint const& checkpoint) = 0;

  [[nodiscard]] virtual Explanation explain() const = 0;
};

}  // namespace talus
