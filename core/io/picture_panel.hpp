#pragma once
/// One instant as a panel of a picture.

#include <filesystem>
#include <string>

#include "core/io/picture_page.hpp"
#include "core/io/scatter.hpp"

namespace talus::io {

/// What all panels of a run have in common: where their data go, what colours the particles, the box around them at all
/// instants, and about their distance [m].
struct Scenery {
  std::filesystem::path folder;
  std::string field;
  Bounds bounds;
  double spacing = 0;
};

/// The particles of a snapshot from the side, with axes, or obliquely, in their box. Writes the panel's data as
/// `<view>_<number>.dat`; throws FileError.
[[nodiscard]] Panel make_panel(Scenery const& scenery, Snapshot const& snapshot, std::string const& number,
                               bool oblique);

}  // namespace talus::io
