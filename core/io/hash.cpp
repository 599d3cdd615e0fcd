#include "core/io/hash.hpp"

#include <sha2.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace talus::io {

static_assert(std::endian::native == std::endian::little, "the state is hashed as it lies in memory");

struct Sha256::Context {
  SHA2_CTX state;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  SHA256Init(&context_->state);
}

Sha256::~Sha256() = default;

void Sha256::add(void const* data, std::size_t size) {
  SHA256Update(&context_->state, static_cast<std::uint8_t const*>(data), size);
}

std::string Sha256::digest() {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> text{};
  return SHA256End(&context_->state, text.data());
}

std::string sha256(std::string_view bytes) {
  Sha256 hash;
  hash.add(bytes);
  return hash.digest();
}

namespace {

/// Positions of the particles in the order of their ids.
std::vector<std::size_t> order_of_ids(Snapshot const& snapshot) {
  auto const* id = snapshot.find("id");
  if (id == nullptr || id->components != 1) throw std::logic_error("the state has no column 'id' to be hashed by");
  std::vector<std::size_t> order(snapshot.particles());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t p) { return id->values[p]; });
  auto const same = [&](std::size_t p, std::size_t q) { return id->values[p] == id->values[q]; };
  if (std::ranges::adjacent_find(order, same) != order.end())
    throw std::logic_error("two particles bear the same id: the state cannot be hashed");
  return order;
}

template <class T>
void add_bits(Sha256& hash, T value) {
  hash.add(&value, sizeof value);
}

}  // namespace

std::string state_hash(Snapshot const& snapshot) {
  auto const order = order_of_ids(snapshot);
  std::vector<NamedColumn const*> columns;
  for (auto const& column : snapshot.columns) columns.push_back(&column);
  std::ranges::sort(columns, {}, &NamedColumn::name);

  Sha256 hash;
  add_bits(hash, snapshot.time);
  add_bits(hash, snapshot.step);
  add_bits(hash, static_cast<std::int64_t>(snapshot.dimension));
  add_bits(hash, static_cast<std::int64_t>(order.size()));
  for (auto const* column : columns) {
    auto const width = static_cast<std::size_t>(column->components);
    hash.add(column->name.c_str(), column->name.size() + 1);
    add_bits(hash, static_cast<std::int64_t>(width));
    std::vector<double> sorted(column->values.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      std::copy_n(&column->values[order[k] * width], width, &sorted[k * width]);
    hash.add(sorted.data(), sorted.size() * sizeof(double));
  }
  return hash.digest();
}

}  // namespace talus::io
