#include <algorithm>
#include <functional>
#include <numeric>

#include "core/io/hdf5.hpp"

namespace talus::io::hdf5 {

namespace {

/// Texts of up to `size` bytes, filled up with NUL.
Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "no type of text");
  check(H5Tset_size(type, size), "no type of text");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "no type of text");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "no type of text");
  return type;
}

Handle space_of(Extent const& extent) {
  return {extent.empty() ? H5Screate(H5S_SCALAR)
                         : H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr),
          H5Sclose, "no extent"};
}

std::string until_nul(std::string_view text) {
  return std::string(text.substr(0, std::min(text.find('\0'), text.size())));
}

Handle new_properties() {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "no data set");
  check(H5Pset_obj_track_times(properties, false), "no data set");  // the same state gives the same bytes
  return properties;
}

Handle write(hid_t group, std::string const& name, Extent const& extent, hid_t stored, hid_t given, hid_t properties,
             void const* values) {
  auto const space = space_of(extent);
  Handle data(H5Dcreate2(group, name.c_str(), stored, space, H5P_DEFAULT, properties, H5P_DEFAULT), H5Dclose,
              "the data set '" + name + "' cannot be made");
  check(H5Dwrite(data, given, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "'" + name + "' cannot be written");
  return data;
}

void write_attribute(hid_t object, std::string const& name, hid_t stored, hid_t given, void const* value) {
  auto const space = space_of({});
  Handle const attribute(H5Acreate2(object, name.c_str(), stored, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "the attribute '" + name + "' cannot be made");
  check(H5Awrite(attribute, given, value), "the attribute '" + name + "' cannot be written");
}

Handle open_attribute(hid_t object, std::string const& name) {
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose, "it has no attribute '" + name + "'"};
}

void read(hid_t data, hid_t type, void* values) {
  check(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), "a data set cannot be read");
}

}  // namespace

void write_attribute(hid_t object, std::string const& name, std::int64_t value) {
  write_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64, &value);
}

void write_attribute(hid_t object, std::string const& name, double value) {
  write_attribute(object, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, std::string const& name, std::string const& value) {
  auto const type = text_type(std::max<std::size_t>(1, value.size()));
  write_attribute(object, name, type, type, value.c_str());
}

void read_attribute(hid_t object, std::string const& name, std::int64_t& value) {
  check(H5Aread(open_attribute(object, name), H5T_NATIVE_INT64, &value), "the attribute '" + name + "' is no integer");
}

void read_attribute(hid_t object, std::string const& name, double& value) {
  check(H5Aread(open_attribute(object, name), H5T_NATIVE_DOUBLE, &value), "the attribute '" + name + "' is no number");
}

void read_attribute(hid_t object, std::string const& name, std::string& value) {
  auto const attribute = open_attribute(object, name);
  Handle const type(H5Aget_type(attribute), H5Tclose, "the attribute '" + name + "' has no type");
  std::string text(H5Tget_size(type), '\0');
  check(H5Aread(attribute, type, text.data()), "the attribute '" + name + "' is no text");
  value = until_nul(text);
}

Kind kind_of(hid_t data) {
  Handle const type(H5Dget_type(data), H5Tclose, "a data set has no type");
  auto const kind = H5Tget_class(type);
  if (kind == H5T_STRING) return Kind::text;
  return kind == H5T_INTEGER ? Kind::integer : Kind::number;
}

Extent extent_of(hid_t data) {
  Handle const space(H5Dget_space(data), H5Sclose, "a data set has no extent");
  auto const axes = H5Sget_simple_extent_ndims(space);
  check(axes, "a data set has no extent");
  Extent extent(static_cast<std::size_t>(axes));
  check(H5Sget_simple_extent_dims(space, extent.data(), nullptr), "a data set has no extent");
  return extent;
}

std::size_t count_of(Extent const& extent) {
  return std::accumulate(extent.begin(), extent.end(), std::size_t{1}, std::multiplies<>());
}

Handle write_data(hid_t group, std::string const& name, Extent const& extent, double const* values) {
  return write(group, name, extent, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, new_properties(), values);
}

Handle write_data(hid_t group, std::string const& name, Extent const& extent, std::int64_t const* values) {
  return write(group, name, extent, H5T_STD_I64LE, H5T_NATIVE_INT64, new_properties(), values);
}

Handle write_data(hid_t group, std::string const& name, Extent const& extent, std::string const* values) {
  auto const count = count_of(extent);
  std::size_t longest = 1;
  for (std::size_t k = 0; k < count; ++k) longest = std::max(longest, values[k].size());
  std::string block(count * longest, '\0');
  for (std::size_t k = 0; k < count; ++k) block.replace(k * longest, values[k].size(), values[k]);
  auto const type = text_type(longest);
  return write(group, name, extent, type, type, new_properties(), block.data());
}

Handle write_packed(hid_t group, std::string const& name, Extent const& extent, double const* values) {
  constexpr hsize_t numbers_per_chunk = 1 << 17;  // 1 MiB
  Extent chunk = extent;
  auto const row = count_of({extent.begin() + 1, extent.end()});
  chunk.front() = std::clamp<hsize_t>(numbers_per_chunk / row, 1, extent.front());
  auto const properties = new_properties();
  check(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "no chunks");
  check(H5Pset_shuffle(properties), "no shuffle filter");
  check(H5Pset_deflate(properties, 1), "no deflate filter");
  check(H5Pset_fletcher32(properties), "no checksum filter");
  return write(group, name, extent, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, properties, values);
}

void read_data(hid_t data, std::vector<double>& values) {
  values.resize(count_of(extent_of(data)));
  read(data, H5T_NATIVE_DOUBLE, values.data());
}

void read_data(hid_t data, std::vector<std::int64_t>& values) {
  values.resize(count_of(extent_of(data)));
  read(data, H5T_NATIVE_INT64, values.data());
}

void read_data(hid_t data, std::vector<std::string>& values) {
  Handle const type(H5Dget_type(data), H5Tclose, "a data set has no type");
  auto const size = H5Tget_size(type);
  auto const count = count_of(extent_of(data));
  std::string block(count * size, '\0');
  read(data, type, block.data());
  values.clear();
  for (std::size_t k = 0; k < count; ++k) values.push_back(until_nul(std::string_view(block).substr(k * size, size)));
}

}  // namespace talus::io::hdf5
