#pragma once
/// Frames for ParaView and Python: particles as a VTK unstructured grid of vertices, and the list of frames.
///
/// Format: VTK XML (.vtu, version 1.0): appended raw blocks, UInt64 headers, little endian. The column "position"
/// becomes the points; every other column becomes point data under its name; columns of two components get a third,
/// zero, as VTK wants of vectors. Values are written as they are (64 bits), time and step as field data. Source: The
/// VTK User's Guide, "VTK File Formats", Kitware.

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/snapshot.hpp"

namespace talus::io {

/// Writes a frame atomically; without particles too. Throws FileError; std::logic_error without a column "position".
void write_vtu(std::filesystem::path const& path, Snapshot const& snapshot);

/// Reads a frame that `write_vtu` wrote, bit for bit; "position" comes first. Throws FileError where the file cannot be
/// read, is cut short, or was not written by Talus.
[[nodiscard]] Snapshot read_vtu(std::filesystem::path const& path);

/// One frame of a run: its time [s] and its file, relative to the list.
struct Frame {
  double time = 0;
  std::string file;

  friend bool operator==(Frame const&, Frame const&) = default;
};

/// Writes the list of all frames (.pvd, a ParaView collection) atomically. Throws FileError.
void write_frame_list(std::filesystem::path const& path, std::vector<Frame> const& frames);

/// Reads a list that `write_frame_list` wrote. Throws FileError.
[[nodiscard]] std::vector<Frame> read_frame_list(std::filesystem::path const& path);

}  // namespace talus::io
