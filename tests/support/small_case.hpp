#pragma once
/// Small cases in the plane and in space, and a state of each that a run can go on from.

#include <memory>
#include <string>
#include <vector>

#include "core/io/checkpoint.hpp"
#include "models/compose.hpp"
#include "models/documents.hpp"

namespace talus::support {

/// The sum of its masses has other bits in the order of the blocks than in that of the bodies.
inline constexpr char const* in_the_plane = R"({"schema": "talus/case/1", "title": "small",
  "kinematics": {"type": "plane_strain"}, "grid": {"spacing": 0.1, "periods": [0, 1.2]},
  "kernel": {"type": "quadratic"}, "transfer": {"type": "aflip", "alpha": 0.9}, "integrator": {"type": "usl"},
  "materials": [{"name": "clay", "density": 1445.4, "law": {"type": "cam_clay"}},
                {"name": "rubber", "density": 677.2, "law": {"type": "hencky"}}],
  "bodies": [
    {"name": "a", "material": "clay", "shape": {"type": "box", "min": [0, 0.1], "max": [0.5, 0.3]},
     "seeding": {"type": "lattice", "per_axis": 1}},
    {"name": "b", "material": "rubber", "shape": {"type": "box", "min": [0, 0.3], "max": [0.3, 0.5]},
     "seeding": {"type": "lattice", "per_axis": 1}}],
  "walls": [{"name": "base", "shape": {"type": "half_space", "point": [0, 0], "normal": [0, 1]},
             "contact": {"type": "coulomb", "friction": 0.3}}],
  "time": {"end": 1},
  "output": {"stations": [{"name": "toe", "min": [0, 0], "max": [0.3, 0.4]}]}})";

inline constexpr char const* in_space = R"({"schema": "talus/case/1", "title": "small",
  "kinematics": {"type": "solid"}, "grid": {"spacing": 0.1},
  "kernel": {"type": "linear"}, "transfer": {"type": "flip"}, "integrator": {"type": "musl"},
  "materials": [{"name": "sand", "density": 1500, "law": {"type": "drucker_prager"}}],
  "bodies": [{"name": "a", "material": "sand", "shape": {"type": "box", "min": [0, 0, 0], "max": [0.3, 0.2, 0.2]},
              "seeding": {"type": "lattice", "per_axis": 1}}],
  "time": {"end": 1}})";

/// The values of a document.
inline Case case_of(char const* text) {
  Document const document = parse(text, "small case");
  Reader reader(document);
  Case values = read_case(document, reader);
  reader.throw_if_mistaken();
  return values;
}

/// A case, and the state it has reached after a few steps.
struct CaseUnderWay {
  Case values;
  io::Checkpoint state;

  explicit CaseUnderWay(char const* text) : values(case_of(text)) {
    auto const experiment = fresh();
    for (int step = 0; step < 3; ++step) experiment->advance(1);
    state = experiment->checkpoint();
  }
  [[nodiscard]] std::unique_ptr<Experiment> fresh() const {
    std::vector<std::string> warnings;
    return compose(values, warnings);
  }
};

}  // namespace talus::support
