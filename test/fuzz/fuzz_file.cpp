// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// Gives any bytes to near_pairs as a file of one format, in each way to read it. A reader may
// refuse them, by Error, or return a scene that keeps its promises; nothing else.

#include "error.h"
#include "feature.h"
#include "point_file.h"
#include "row_reader.h"
#include "tracks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

extern const char* const fuzz_format; // the extension of the file, in fuzz_format.cpp

namespace {

// A file of its own for each process, removed at the end.
class Temporary_file
{
public:
  Temporary_file()
    : path_(std::filesystem::temp_directory_path()
            / ("near_pairs_fuzz_" + std::to_string(std::random_device()()) + fuzz_format))
  {}

  ~Temporary_file() { std::filesystem::remove(path_); }

  std::string path() const { return path_.string(); }

  void fill(const std::uint8_t* data, std::size_t size) const
  {
    std::ofstream(path_, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }

private:
  std::filesystem::path path_;
};

void require(bool condition)
{
  if(!condition)
    std::abort();
}

void check(const near_pairs::Scene& scene, std::size_t most_points)
{
  require(scene.dimension == 2 || scene.dimension == 3);
  require(scene.doubles.empty() || scene.exact.empty());
  require((scene.doubles.size() + scene.exact.size()) % scene.dimension == 0);
  require(scene.size() <= most_points);
  require(scene.ids.empty() || scene.ids.size() == scene.size());
  require(std::all_of(scene.doubles.begin(), scene.doubles.end(),
                      [](double coordinate) { return std::isfinite(coordinate); }));
}

void check(const std::vector<near_pairs::Feature>& features)
{
  for(const near_pairs::Feature& feature : features) {
    for(const auto& triangle : feature.mesh.triangles)
      for(std::size_t corner : triangle)
        require(corner < feature.mesh.points.size());
    for(const auto& point : feature.mesh.points)
      for(double coordinate : point)
        require(std::isfinite(coordinate));
  }
}

void check(const near_pairs::Tracks& tracks)
{
  const near_pairs::Scene& scene = tracks.scene;
  require(scene.doubles.empty() || scene.exact.empty());
  require(std::all_of(scene.doubles.begin(), scene.doubles.end(),
                      [](double coordinate) { return std::isfinite(coordinate); }));
  for(const near_pairs::Track& track : tracks.tracks)
    for(const near_pairs::Piece& piece : track.pieces)
      for(std::size_t i = 0; i < piece.size(); ++i) {
        require(piece[i].point < scene.size());
        require(piece[i].tick >= 0 && (i == 0 || piece[i - 1].tick < piece[i].tick));
      }
}

void read_as_tracks(near_pairs::Options options)
{
  options.readings.assign(1, options);
  try {
    check(near_pairs::read_tracks(options));
  }
  catch(const near_pairs::Error&) {
  }
}

// Times or velocities in the first columns.
void read_motion(near_pairs::Options options)
{
  if(!near_pairs::is_table(options.files.front(), options))
    return;
  options.time = "1";
  read_as_tracks(options);
  options.max_gap = near_pairs::parse_exact("0.5");
  options.columns = {"2", "3"};
  options.id = "4";
  read_as_tracks(options);
  options.time.clear();
  options.velocity = {"4", "5"};
  options.until = *near_pairs::parse_exact("720");
  read_as_tracks(options);
  options.geographic = true;
  options.altitude = "1";
  options.velocity.emplace_back("6");
  read_as_tracks(options);
}

void read(near_pairs::Options options, std::size_t most_points)
{
  options.readings.assign(1, options);
  std::string system;
  try {
    if(near_pairs::has_features(options.files.front(), options))
      check(near_pairs::read_features(near_pairs::Input(options.files.front()), options, system));
    else
      check(near_pairs::read_scene(options), most_points);
  }
  catch(const near_pairs::Error&) {
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const Temporary_file file;
  file.fill(data, size);
  const bool is_compressed = size > 1 && data[0] == 0x1F && data[1] == 0x8B;
  const std::size_t most_points = is_compressed ? 1100 * size : size; // deflate makes 1032 of one
  near_pairs::Options options;
  options.files = {file.path()};
  read_motion(options);
  options.closest = true; // so that ids are kept
  read(options, most_points);
  options.solids = true;
  read(options, most_points);
  options.solids = false;
  options.is_periodic = true; // with the cell that the file tells
  read(options, most_points);
  options.is_periodic = false;
  options.frame = 2;
  read(options, most_points);
  options.frame = 1;
  options.dimension = 2;
  read(options, most_points);
  options.dimension = 0;
  options.skip_missing = true;
  read(options, most_points);
  options.skip_missing = false;
  options.decimal = true;
  read(options, most_points);
  options.kernel = "exact";
  read(options, most_points);
  options.decimal = false;
  options.geographic = true;
  read(options, most_points);
  options.columns = {"2", "1"};
  read(options, most_points);
  options.no_header = true;
  options.separator = ' ';
  options.id = "1";
  options.comma_numbers = options.skip_missing = true;
  read(options, most_points);
  return 0;
}
