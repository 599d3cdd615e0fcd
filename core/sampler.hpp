#pragma once
/// Takes the particles that a station sees out of a scene.

#include <algorithm>
#include <limits>
#include <span>

#include "core/scene.hpp"
#include "core/station.hpp"

namespace talus {

template <int D>
class Sampler {
 public:
  /// time [s] and step are those of the samples.
  Sampler(Station const& station, Scene<D> const& scene, double time, std::int64_t step)
      : station_(station), scene_(scene), layout_(scene.layout()), samples_{time, step, D, {}} {
    for (int d = 0; d < D; ++d)
      periods_[d] = double(scene.periods[static_cast<std::size_t>(d)]) * block_edge * scene.spacing;
    add_columns();
  }

  /// Takes what the station sees of a batch, in the order of storage.
  void take(Material<D> const& material, Batch<D> const& batch) {
    loads_.clear();
    for (int c = 0; c < batch.count; ++c) {
      derived_.clear();
      for (int lane = 0; lane < batch.filled(c); ++lane) {
        Point<D> x;
        for (int d = 0; d < D; ++d) x[d] = batch.chunk(c)[batch.at.position + d][lane];
        if (!sees(x)) continue;
        if (loads_.empty()) begin(material, batch);
        if (derived_.empty()) material.derive(batch, c, derived_);
        take_particle(material.density, batch, c, lane, x);
      }
    }
  }

  [[nodiscard]] Snapshot const& samples() const { return samples_; }

 private:
  /// Where the number of a column is, for the law at hand.
  struct Source {
    int derived = -1, stored = -1;
  };

  /// Whether the station sees the place x, which is brought into the station's period where an axis repeats.
  bool sees(Point<D>& x) const {
    for (int d = 0; d < D; ++d) {
      auto const axis = static_cast<std::size_t>(d);
      double const low = station_.low[axis], period = periods_[d];
      if (period > 0) x[d] -= std::floor((x[d] - low) / period) * period;
      bool const whole = period > 0 && station_.extent(axis) > period * (1 - 1e-9);
      if (!whole && !(x[d] >= low && x[d] < station_.high[axis])) return false;
    }
    return true;
  }

  void add_columns() {
    auto const add = [&](std::string_view name, char const* symbol, char const* unit, std::string meaning) {
      samples_.columns.push_back({std::string(name), symbol, unit, std::move(meaning), 1, {}});
    };
    char const* const volume = D == 2 ? "m^2" : "m^3";
    add(sample::mass, "m_p", "kg", "mass");
    add(sample::initial_volume, "V_p^0", volume, "volume before deformation");
    add(sample::height, "y", "m", "height above the station's lower face");
    add(sample::flow_velocity, "u", "m/s", "velocity along the flow");
    if (!station_.initial_fraction.empty()) add(sample::solid_volume, "V_s", volume, "volume of the grains");
    for (std::string_view const axis : std::span(axis_names).first(D))
      add("velocity_" + std::string(axis), "v", "m/s", "velocity along " + std::string(axis));
    add("normal_stress", "-tau_nn", "Pa", "stress along the depth, positive in compression");
    add("tangential_stress", "tau_nt", "Pa", "stress along the flow on planes across the depth");
    fixed_ = samples_.columns.size();
    for (auto const& material : scene_.materials) {
      for (FieldInfo const& info : material->derived()) add_field(info);
      for (FieldInfo const& info : kept_by(*material)) add_field(info);
    }
  }

  void add_field(FieldInfo const& info) {
    if (samples_.find(info.name) == nullptr)
      samples_.columns.push_back(
          {std::string(info.name), std::string(info.symbol), std::string(info.unit), std::string(info.meaning), 1, {}});
  }

  /// The scalars that a law keeps between steps.
  [[nodiscard]] std::vector<FieldInfo> kept_by(Material<D> const& material) const {
    Layout own(D, scene_.strain_size);
    material.declare(own);
    std::vector<FieldInfo> fields;
    for (Column const& column : own.columns())
      if (column.components == 1) fields.push_back(column.info);
    return fields;
  }

  /// Stresses of a batch, and where its law has the fields.
  void begin(Material<D> const& material, Batch<D> const& batch) {
    loads_.resize(static_cast<std::size_t>(batch.count));
    material.load(batch, false, loads_.data());
    auto const derived = material.derived();
    auto const kept = kept_by(material);
    auto const place = [](std::vector<FieldInfo> const& list, std::string_view name) {
      auto const at = std::find_if(list.begin(), list.end(), [&](FieldInfo const& i) { return i.name == name; });
      return at == list.end() ? -1 : static_cast<int>(at - list.begin());
    };
    sources_.clear();
    for (std::size_t k = fixed_; k < samples_.columns.size(); ++k) {
      std::string const& name = samples_.columns[k].name;
      sources_.push_back({place(derived, name), place(kept, name) < 0 ? -1 : layout_.find(name)});
    }
    auto const is_this = [&](auto const& m) { return m.get() == &material; };
    number_ = static_cast<std::size_t>(std::find_if(scene_.materials.begin(), scene_.materials.end(), is_this) -
                                       scene_.materials.begin());
  }

  void take_particle(double density, Batch<D> const& batch, int c, int lane, Point<D> const& x) {
    Lanes const* chunk = batch.chunk(c);
    auto const flow = static_cast<int>(station_.flow), depth = static_cast<int>(station_.depth);
    double const mass = chunk[batch.at.mass][lane], volume = mass / density;
    auto const& force = loads_[static_cast<std::size_t>(c)].force;
    std::size_t k = 0;
    auto const put = [&](double value) { samples_.columns[k++].values.push_back(value); };
    put(mass);
    put(volume);
    put(x[depth] - station_.low[station_.depth]);
    put(chunk[batch.at.velocity + flow][lane]);
    if (!station_.initial_fraction.empty()) put(volume * station_.initial_fraction[number_]);
    for (int d = 0; d < D; ++d) put(chunk[batch.at.velocity + d][lane]);
    put(-force(depth, depth)[lane] / volume);
    put(force(std::min(flow, depth), std::max(flow, depth))[lane] / volume);
    for (Source const& source : sources_)
      put(source.derived >= 0  ? derived_[static_cast<std::size_t>(source.derived)][lane]
          : source.stored >= 0 ? chunk[source.stored][lane]
                               : std::numeric_limits<double>::quiet_NaN());
  }

  Station const& station_;
  Scene<D> const& scene_;
  Layout layout_;
  Snapshot samples_;
  Point<D> periods_;
  std::size_t fixed_ = 0;  ///< columns before those of the laws
  std::vector<Source> sources_;
  std::vector<Lanes> derived_;
  std::vector<Load<D>> loads_;
  std::size_t number_ = 0;  ///< of the material at hand
};

}  // namespace talus
