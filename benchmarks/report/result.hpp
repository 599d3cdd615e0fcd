#pragma once
/// What a benchmark gives: tables of measured rows, and charts of them.

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/timing/estimate.hpp"

namespace talus::bench {

/// What a value should reach. `stretch` is hoped for beyond `least`.
struct Bar {
  std::optional<double> least = {}, most = {}, stretch = {};

  [[nodiscard]] bool met(double value) const { return !(least && !(value >= *least)) && !(most && !(value <= *most)); }
};

struct Row {
  std::string name, unit;
  Estimate value;
  std::optional<Bar> bar = {};
  std::vector<std::string> more = {};  ///< one text for each of the table's further columns
};

struct Table {
  std::string title;
  std::vector<std::string> columns = {};  ///< further ones, behind the value
  std::vector<Row> rows = {};
  std::vector<std::string> notes = {};  ///< what is assumed
};

/// Points of one colour; `low` and `high` are the ends of their error bars, or empty.
struct Curve {
  std::string name;
  std::vector<double> x = {}, y = {}, low = {}, high = {};
};

/// Curves over numbers, or bars over `labels` (then x counts from 0). Axis labels bear the units.
struct Chart {
  std::string name, title, x_label, y_label;
  std::vector<std::string> labels = {};
  std::vector<Curve> curves = {};
  std::vector<double> lines = {};  ///< horizontal ones: bars to be reached
  bool log_x = false;
};

struct Result {
  std::vector<Table> tables;
  std::vector<Chart> charts = {};
};

/// A result with the benchmark it is of, and how long that took [s].
struct Measured {
  std::string name, what;
  Result result;
  double seconds = 0;
};

}  // namespace talus::bench
