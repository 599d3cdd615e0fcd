#pragma once
/// A run's motion in time, as a script for gnuplot.

#include <string>

#include "core/io/picture_page.hpp"
#include "core/io/series.hpp"

namespace talus::io {

/// Commands that draw front and centre of mass (the columns front, centre_of_mass_x, ...) over the column time, one
/// panel each, from `../series.csv` into `motion.<extension>.tmp`; empty where the series has none of them, or no two
/// rows.
[[nodiscard]] std::string motion_script(Series const& series, PictureFormat const& format);

}  // namespace talus::io
