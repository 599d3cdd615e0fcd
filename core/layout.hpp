#pragma once
/// Where the fields of a scene lie inside a chunk of particles.

#include <algorithm>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "core/fields.hpp"

namespace talus {

/// One field as it is stored: `components` packs from pack number `offset` of each chunk on.
struct Column {
  FieldInfo info;
  int components = 0;
  int offset = 0;
};

/// The fields that a scene's policies ask for, each once, in the order of first mention.
class Layout {
 public:
  /// dimension: of space; strain_size: numbers of the kinematics' strain.
  Layout(int dimension, int strain_size) : dimension_(dimension), strain_size_(strain_size) {}

  /// Adds the fields of a list that are not there yet.
  template <Field... F>
  void unite(Fields<F...>) {
    (add(info_of<F>()), ...);
  }

  /// First pack of a field in a chunk, or -1 where the scene does not store it.
  template <Field F>
  [[nodiscard]] int find(F) const {
    return find(F::name);
  }
  [[nodiscard]] int find(std::string_view name) const {
    for (Column const& c : columns_)
      if (c.info.name == name) return c.offset;
    return -1;
  }

  [[nodiscard]] std::vector<Column> const& columns() const { return columns_; }
  [[nodiscard]] int dimension() const { return dimension_; }
  /// Packs of one chunk.
  [[nodiscard]] int packs() const { return packs_; }
  /// Bytes of a particle that the step uses: everything but the number kept for output.
  [[nodiscard]] int bytes_per_particle() const {
    int const output_only = find(field::identity) < 0 ? 0 : 1;
    return (packs_ - output_only) * static_cast<int>(sizeof(double));
  }

 private:
  void add(FieldInfo const& info) {
    if (find(info.name) >= 0) return;
    int const n = info.components(dimension_, strain_size_);
    columns_.push_back({info, n, packs_});
    packs_ += n;
  }

  int dimension_, strain_size_;
  int packs_ = 0;
  std::vector<Column> columns_;
};

}  // namespace talus
