#include "core/station.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace talus {

namespace {

constexpr double surface_share = 0.05;  ///< of the mass, that is the surface [1]
constexpr double depth_share = 0.99;    ///< of the mass, that lies below the top [1]

/// a / b, nan where there is nothing to take a mean of.
double over(double a, double b) {
  return b > 0 ? a / b : std::numeric_limits<double>::quiet_NaN();
}

/// Sums over some of a station's particles.
class Sums {
 public:
  explicit Sums(Snapshot const& samples)
      : samples_(&samples),
        mass_of_(samples.find(sample::mass)),
        before_of_(samples.find(sample::initial_volume)),
        ratio_of_(samples.find(sample::volume_ratio)),
        solid_of_(samples.find(sample::solid_volume)),
        weight_(samples.columns.size()),
        sum_(samples.columns.size()) {}

  /// share: how much of the particle is taken.
  void add(std::size_t particle, double share = 1) {
    double const m = share * mass_of_->values[particle];
    for (std::size_t k = 0; k < sum_.size(); ++k) {
      double const value = samples_->columns[k].values[particle];
      if (std::isnan(value)) continue;
      weight_[k] += m;
      sum_[k] += m * value;
    }
    mass_ += m;
    double const before = share * before_of_->values[particle];
    before_ += before;
    after_ += before * ratio_of_->values[particle];
    if (solid_of_ != nullptr) solid_ += share * solid_of_->values[particle];
  }

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] double mean(std::size_t column) const { return over(sum_[column], weight_[column]); }
  [[nodiscard]] double mean(std::string_view name) const {
    return mean(static_cast<std::size_t>(samples_->find(name) - samples_->columns.data()));
  }
  /// sum q / sum p: what the stress of the whole mobilises. A mean of q/p would be ruled by particles without load.
  [[nodiscard]] double friction() const {
    double const p = mean(sample::pressure);
    return p != 0 ? mean(sample::shear_stress) / p : std::numeric_limits<double>::quiet_NaN();
  }
  [[nodiscard]] double volume_ratio() const { return over(after_, before_); }
  [[nodiscard]] double solid_fraction() const { return over(solid_, after_); }

 private:
  Snapshot const* samples_;
  NamedColumn const *mass_of_, *before_of_, *ratio_of_, *solid_of_;
  std::vector<double> weight_, sum_;
  double mass_ = 0, before_ = 0, after_ = 0, solid_ = 0;
};

/// A station's particles as a layer: their sums, those near its surface, and how its height is spread.
struct Layer {
  Station const& station;
  Sums all, surface;
  double variance = 0;  ///< of the height [m^2]
  double top = 0;       ///< height below which `depth_share` of the mass lies [m]

  Layer(Station const& its_station, Snapshot const& samples) : station(its_station), all(samples), surface(samples) {
    auto const& m = samples.find(sample::mass)->values;
    auto const& y = samples.find(sample::height)->values;
    std::vector<std::size_t> order(m.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t const p : order) all.add(p);
    double const mean = all.mean(sample::height);
    for (std::size_t const p : order) variance += m[p] * (y[p] - mean) * (y[p] - mean);
    variance = over(variance, all.mass());
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return y[a] > y[b]; });
    take_surface(order, m);
    top = top_of(order, m, y);
  }

 private:
  /// The uppermost particles; of the last one as much as is still missing.
  void take_surface(std::vector<std::size_t> const& from_above, std::vector<double> const& m) {
    double missing = surface_share * all.mass();
    for (std::size_t const p : from_above) {
      if (!(missing > 0)) return;
      surface.add(p, std::min(1.0, missing / m[p]));
      missing -= m[p];
    }
  }
  [[nodiscard]] double top_of(std::vector<std::size_t> const& from_above, std::vector<double> const& m,
                              std::vector<double> const& y) const {
    double above = 0;
    for (std::size_t const p : from_above)
      if ((above += m[p]) > (1 - depth_share) * all.mass()) return y[p];
    return over(0, 0);
  }
};

/// A column that a station adds to the series.
struct Measure {
  std::string_view name, symbol, unit, meaning;
  double (*of)(Layer const&);
  bool of_grains = false;  ///< only where the laws tell the density of grains
};

constexpr std::array measures{
    Measure{"mass", "m", "kg", "mass in the station", [](Layer const& l) { return l.all.mass(); }},
    Measure{"depth", "h", "m", "twice the mean height: depth of a layer of uniform density on the lower face",
            [](Layer const& l) { return 2 * l.all.mean(sample::height); }},
    Measure{"thickness", "h", "m",
            "sqrt(12) times the standard deviation of the height: depth of a layer of uniform density anywhere",
            [](Layer const& l) { return std::sqrt(12 * l.variance); }},
    Measure{"top", "h", "m", "height below which 99 % of the mass lies", [](Layer const& l) { return l.top; }},
    Measure{"mean_speed", "u", "m/s", "mean velocity along the flow",
            [](Layer const& l) { return l.all.mean(sample::flow_velocity); }},
    Measure{"surface_speed", "u_s", "m/s", "mean velocity along the flow of the uppermost 5 % of the mass",
            [](Layer const& l) { return l.surface.mean(sample::flow_velocity); }},
    Measure{"flux", "Q", "kg/s", "mass that flows through a section: momentum over the station's length",
            [](Layer const& l) {
              double const m = l.all.mass();
              return m > 0 ? m * l.all.mean(sample::flow_velocity) / l.station.extent(l.station.flow) : 0;
            }},
    Measure{"pressure", "p", "Pa", "mean pressure", [](Layer const& l) { return l.all.mean(sample::pressure); }},
    Measure{"mobilised_friction", "q/p", "1", "mean shear stress over mean pressure",
            [](Layer const& l) { return l.all.friction(); }},
    Measure{"volume_ratio", "J", "1", "volume over initial volume",
            [](Layer const& l) { return l.all.volume_ratio(); }},
    Measure{"solid_fraction", "phi", "1", "volume of grains over volume",
            [](Layer const& l) { return l.all.solid_fraction(); }, true}};

/// A bin of a profile.
struct Bin {
  double time, middle;  ///< [s]; height above the lower face [m]
  Sums sums;
};

/// A column of a profile besides the means of the samples' columns.
struct BinMeasure {
  std::string_view name, symbol, unit, meaning;
  double (*of)(Bin const&);
  bool of_grains = false;
};

constexpr std::array bin_measures{
    BinMeasure{"time", "t", "s", "time", [](Bin const& b) { return b.time; }},
    BinMeasure{"middle", "y", "m", "height of the bin's middle", [](Bin const& b) { return b.middle; }},
    BinMeasure{"height", "y", "m", "mean height", [](Bin const& b) { return b.sums.mean(sample::height); }},
    BinMeasure{"mass", "m", "kg", "mass in the bin", [](Bin const& b) { return b.sums.mass(); }},
    BinMeasure{"mobilised_friction", "q/p", "1", "mean shear stress over mean pressure",
               [](Bin const& b) { return b.sums.friction(); }},
    BinMeasure{"volume_ratio", "J", "1", "volume over initial volume",
               [](Bin const& b) { return b.sums.volume_ratio(); }},
    BinMeasure{"solid_fraction", "phi", "1", "volume of grains over volume",
               [](Bin const& b) { return b.sums.solid_fraction(); }, true}};

/// The samples' columns of which a profile has the means: those that are not told in another way, or not at all.
std::vector<std::size_t> averaged(Snapshot const& samples) {
  constexpr std::array apart{sample::mass, sample::height, sample::initial_volume, sample::solid_volume,
                             sample::volume_ratio};
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < samples.columns.size(); ++k)
    if (std::find(apart.begin(), apart.end(), samples.columns[k].name) == apart.end()) columns.push_back(k);
  return columns;
}

/// Calls f(entry) for the entries of a table that hold for the station.
template <class Table, class F>
void for_each_told(Table const& table, Station const& station, F const& f) {
  for (auto const& entry : table)
    if (!entry.of_grains || !station.initial_fraction.empty()) f(entry);
}

template <class Entry>
Quantity quantity_of(Entry const& e, std::string const& prefix = {}) {
  return {prefix + std::string(e.name), std::string(e.symbol), std::string(e.unit), std::string(e.meaning)};
}

}  // namespace

std::vector<Quantity> station_quantities(Station const& station) {
  std::vector<Quantity> list;
  for_each_told(measures, station, [&](Measure const& m) { list.push_back(quantity_of(m, station.name + "_")); });
  return list;
}

std::vector<double> measure(Station const& station, Snapshot const& samples) {
  Layer const layer(station, samples);
  std::vector<double> values;
  for_each_told(measures, station, [&](Measure const& m) { values.push_back(m.of(layer)); });
  return values;
}

Profile profile(Station const& station, Snapshot const& samples) {
  double const width = station.extent(station.depth) / station.bins;
  std::vector<Bin> bins;
  for (int b = 0; b < station.bins; ++b) bins.push_back({samples.time, (b + 0.5) * width, Sums(samples)});
  auto const& heights = samples.find(sample::height)->values;
  for (std::size_t p = 0; p < heights.size(); ++p)
    bins[static_cast<std::size_t>(std::clamp(std::floor(heights[p] / width), 0.0, station.bins - 1.0))].sums.add(p);

  auto const means = averaged(samples);
  Profile made{station.name, {}, std::vector<std::vector<double>>(bins.size())};
  for_each_told(bin_measures, station, [&](BinMeasure const& m) {
    made.quantities.push_back(quantity_of(m));
    for (std::size_t b = 0; b < bins.size(); ++b) made.rows[b].push_back(m.of(bins[b]));
  });
  for (std::size_t const k : means) {
    made.quantities.push_back(quantity_of(samples.columns[k]));
    for (std::size_t b = 0; b < bins.size(); ++b) made.rows[b].push_back(bins[b].sums.mean(k));
  }
  return made;
}

}  // namespace talus
