#pragma once
/// A small described document with a member of every kind, for the tests of core/config.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/config/any_value.hpp"
#include "core/config/choice.hpp"
#include "core/config/parameters.hpp"

namespace talus::sample {

struct Linear {
  static constexpr std::string_view name = "linear", title = "Linear kernel";
  struct Parameters {
    static constexpr auto table() { return std::tuple{}; }
  };
};

struct Spline {
  static constexpr std::string_view name = "spline", title = "B-spline", source = "Schoenberg (1946)";
  struct Parameters {
    int degree = 2;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::degree, "degree", "d", "1", "degree", closed(2, 3))};
    }
  };
};

struct Grain {
  double diameter = 1e-3;
  static constexpr auto table() {
    return std::tuple{parameter(&Grain::diameter, "diameter", "d", "m", "grain diameter", left_open(0, 0.1))};
  }
};

struct Friction {
  static constexpr std::string_view name = "friction", title = "Friction of a granular flow";
  struct Parameters {
    double E = 1e6, nu = 0.3, mu_1 = 0.3, mu_2 = 0.6;
    Grain grain{.diameter = 7e-4};
    static constexpr auto table() {
      return std::tuple{
          parameter(&Parameters::E, "young_modulus", "E", "Pa", "Young's modulus", positive)
              .validated(1e4, 1e9, "a made-up source")
              .required(),
          parameter(&Parameters::nu, "poisson_ratio", "\\nu", "1", "Poisson's ratio", open(-1, 0.5)),
          parameter(&Parameters::mu_1, "mu_1", "\\mu_1", "1", "friction at rest", non_negative),
          parameter(&Parameters::mu_2, "mu_2", "\\mu_2", "1", "friction at speed, | at infinity", non_negative),
          parameter(&Parameters::grain, "grain", "the grains")};
    }
    static std::optional<std::string> check(Parameters const& p) {
      if (p.mu_1 <= p.mu_2) return {};
      return "mu_1 must not exceed mu_2";
    }
  };
};

struct Elastic {
  static constexpr std::string_view name = "elastic", title = "Elastic solid";
  struct Parameters {
    double E = 1e6;
    static constexpr auto table() {
      return std::tuple{parameter(&Parameters::E, "young_modulus", "E", "Pa", "Young's modulus", positive).required()};
    }
  };
};

using Kernels = TypeList<Linear, Spline>;
using Laws = TypeList<Elastic, Friction>;

struct Body {
  std::string material;
  Coordinates low, high{1, 1};
  double density = 1000;
  static constexpr auto table() {
    return std::tuple{parameter(&Body::material, "material", "name of its material").required(),
                      parameter(&Body::low, "low", "x_0", "m", "lowest corner"),
                      parameter(&Body::high, "high", "x_1", "m", "highest corner"),
                      parameter(&Body::density, "density", "\\rho", "kg/m^3", "density", positive)};
  }
};

struct Stop {
  double speed = 0;
  static constexpr auto table() {
    return std::tuple{parameter(&Stop::speed, "speed", "v", "m/s", "slower than this", positive).required()};
  }
};

struct Space {
  int dimension = 2;
  std::vector<bool> periodic{false, false};
  Choice<Kernels> kernel = Choice<Kernels>::of<Spline>();
  static constexpr auto table() {
    return std::tuple{parameter(&Space::dimension, "dimension", "D", "1", "number of axes", closed(2, 3)),
                      parameter(&Space::periodic, "periodic", "whether opposite sides are one").per_axis(),
                      parameter(&Space::kernel, "kernel", "weights of the nodes")};
  }
};

struct Scene {
  std::string title = "untitled";
  Space space;
  Choice<Laws> law;
  std::vector<Body> bodies;
  std::int64_t steps = 10;
  std::uint64_t seed = 1;
  double slope_deg = 0;
  std::vector<double> times{0.5, 1};
  std::vector<Coordinates> probes;
  std::optional<Stop> stop;
  std::vector<AnyValue> notes;
  static constexpr auto table() {
    return std::tuple{parameter(&Scene::title, "title", "what it is"),
                      parameter(&Scene::space, "space", "the space"),
                      parameter(&Scene::law, "law", "the material"),
                      parameter(&Scene::bodies, "bodies", "what is there").sized(1).required(),
                      parameter(&Scene::steps, "steps", "n", "1", "number of steps", at_least(1)),
                      parameter(&Scene::seed, "seed", "", "1", "seed of random numbers"),
                      parameter(&Scene::slope_deg, "slope_deg", "\\theta", "deg", "slope", right_open(0, 90)),
                      parameter(&Scene::times, "times", "t", "s", "times of output", non_negative).sized(0, 4),
                      parameter(&Scene::probes, "probes", "x", "m", "points of measurement"),
                      parameter(&Scene::stop, "stop", "when to stop"),
                      parameter(&Scene::notes, "notes", "values of any kind")};
  }
};

/// The shortest document that is right.
inline constexpr std::string_view shortest =
    R"({"law": {"type": "elastic", "young_modulus": 2e5}, "bodies": [{"material": "sand"}]})";

}  // namespace talus::sample
