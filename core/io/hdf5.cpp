#include "core/io/hdf5.hpp"

namespace talus::io::hdf5 {

namespace {

/// Called for each entry of the error stack, the innermost first: keeps that one.
herr_t keep_first(unsigned number, H5E_error2_t const* error, void* text) {
  if (number == 0 && error->desc != nullptr) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

std::string name_of_member(hid_t group, hsize_t position) {
  auto const size = H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, position, nullptr, 0, H5P_DEFAULT);
  check(size, "a member's name cannot be read");
  std::string name(static_cast<std::size_t>(size) + 1, '\0');
  check(
      H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, position, name.data(), name.size(), H5P_DEFAULT),
      "a member's name cannot be read");
  name.pop_back();
  return name;
}

}  // namespace

Silence::Silence() {
  H5Eget_auto2(H5E_DEFAULT, &print_, &argument_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Silence::~Silence() {
  H5Eset_auto2(H5E_DEFAULT, print_, argument_);
}

void check(std::int64_t result, std::string_view what) {
  if (result >= 0) return;
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  throw Error(std::string(what) + (reason.empty() ? "" : " (HDF5: " + reason + ")"));
}

Handle::Handle(hid_t id, Close close, std::string_view what) : id_(id), close_(close) {
  check(id, what);
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

Handle new_file() {
  constexpr std::size_t grow_by = 1 << 20;
  Handle const access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "no file in memory");
  check(H5Pset_fapl_core(access, grow_by, false), "no file in memory");
  return {H5Fcreate("checkpoint in memory", H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose, "no file in memory"};
}

Handle open_image(std::string_view bytes) {
  Handle const access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "no file in memory");
  check(H5Pset_fapl_core(access, 1 << 20, false), "no file in memory");
  void* const source = const_cast<char*>(bytes.data());  // the call copies the bytes and leaves them as they are
  check(H5Pset_file_image(access, source, bytes.size()), "no file in memory");
  return {H5Fopen("checkpoint in memory", H5F_ACC_RDONLY, access), H5Fclose, "it is no HDF5 file"};
}

std::string image_of(Handle const& file, std::size_t room) {
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "the file cannot be completed");
  auto const size = H5Fget_file_image(file, nullptr, 0);
  check(size, "the file cannot be completed");
  std::string bytes(room + static_cast<std::size_t>(size), '\0');
  check(H5Fget_file_image(file, bytes.data() + room, bytes.size() - room), "the file cannot be completed");
  return bytes;
}

Handle new_group(hid_t parent, std::string const& name) {
  Handle const properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "no group");
  check(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED), "no group");
  check(H5Pset_obj_track_times(properties, false), "no group");
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT), H5Gclose,
          "the group '" + name + "' cannot be made"};
}

Handle open_group(hid_t parent, std::string const& name) {
  return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, "it has no group '" + name + "'"};
}

std::vector<std::string> members(hid_t group) {
  H5G_info_t info;
  check(H5Gget_info(group, &info), "a group cannot be read");
  std::vector<std::string> names;
  for (hsize_t k = 0; k < info.nlinks; ++k) names.push_back(name_of_member(group, k));
  return names;
}

Handle open_data(hid_t group, std::string const& name) {
  return {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, "it has no data set '" + name + "'"};
}

}  // namespace talus::io::hdf5
