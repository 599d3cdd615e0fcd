#pragma once
/// Pictures of a run, from its frames and its series, drawn by gnuplot.

#include <filesystem>
#include <string>

namespace talus::io {

/// What the pictures show: particles coloured by the magnitude of a field, at up to so many instants from the first to
/// the last frame, at equal distances where the number of frames allows it.
struct PictureOptions {
  std::string field = "velocity";
  int instants = 6;
};

/// Draws into `<run folder>/plots`, each as .png and .svg:
///   particles       a sheet of all chosen instants; in three dimensions obliquely from above
///   particles_side  in three dimensions also from the side
///   particles_last  the last instant
///   motion          front and centre of mass in time, as far as the series has them
/// The script pictures.gp and its data stay there: `cd plots; gnuplot pictures.gp` draws again.
/// Returns why there are no pictures (gnuplot is missing, no frames), for people; nothing where all is well.
/// Throws FileError where the run cannot be read or the plots not be written, InputError for an unknown field.
[[nodiscard]] std::string draw_pictures(std::filesystem::path const& run_folder, PictureOptions const& options = {});

}  // namespace talus::io
