// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// The drawing of tracks; see track_picture.h.

#include "track_picture.h"

#include "summary.h"
#include "svg.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>

namespace near_pairs {
namespace {

// Colors of Okabe and Ito, which color-blind people can tell apart too.
const char* const approach_color = "#D55E00";
const char* const track_colors[] = {"#999999", "#009E73"};

constexpr double left_of_tracks = 96, top_of_tracks = 64, widest = 900, highest = 620;
constexpr double narrowest = 560, height_of_legend_row = 24;
constexpr std::size_t longest_path_of_tracks = 2000; // characters: a program draws long ones slowly

class Track_drawing
{
public:
  Track_drawing(std::ostream& svg, const Tracks& tracks, const Options& options)
    : svg_(svg), tracks_(tracks), options_(options)
  {
    place_panel();
  }

  void draw(const std::vector<Approach>& pairs)
  {
    begin(pairs.size());
    for(const std::size_t file : {0, 1})
      draw_lines(file == 0 ? 0 : tracks_.first_size,
                 file == 0 ? tracks_.first_size : tracks_.tracks.size(), track_colors[file]);
    draw_approaches(pairs);
    draw_legend();
    svg_ << "</svg>\n";
  }

private:
  bool is_map() const { return tracks_.scene.is_geographic || tracks_.scene.unit == "deg"; }

  Position position_of(const std::array<double, 3>& place) const
  {
    if(!tracks_.scene.is_geographic)
      return {place[0], place[1]};
    const std::array<double, 2> degrees = degrees_of(place);
    return {degrees[1], degrees[0]};
  }

  Position position_of(const Fix& fix) const
  {
    if(tracks_.scene.is_geographic)
      return {tracks_.scene.column(fix.point, 1), tracks_.scene.column(fix.point, 0)};
    return {tracks_.scene.coordinate(fix.point, 0), tracks_.scene.coordinate(fix.point, 1)};
  }

  void place_panel()
  {
    const double most = std::numeric_limits<double>::max();
    Position low = {most, most}, high = {-most, -most};
    for(const Track& track : tracks_.tracks)
      for(const Piece& piece : track.pieces)
        for(const Fix& fix : piece) {
          const Position p = position_of(fix);
          low = {std::min(low.x, p.x), std::min(low.y, p.y)};
          high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        }
    if(low.x > high.x)
      low = high = {0, 0};
    const double middle = (low.y + high.y) / 2 * std::acos(-1.) / 180;
    const double aspect = tracks_.scene.is_geographic ? std::max(0.05, std::cos(middle)) : 1;
    const double extent = std::max((high.x - low.x) * aspect, high.y - low.y);
    const double room = extent > 0 ? extent / 30 : std::max({1., std::abs(low.x), std::abs(low.y)});
    panel_.low = {low.x - room / aspect, low.y - room};
    panel_.high = {high.x + room / aspect, high.y + room};
    panel_.y_scale = std::min(widest / ((high.x - low.x) * aspect + 2 * room),
                              highest / (high.y - low.y + 2 * room));
    panel_.x_scale = panel_.y_scale * aspect;
    check_window(panel_);
    panel_.left = std::max(left_of_tracks, y_axis_width(panel_));
    panel_.top = top_of_tracks;
  }

  std::string name_of(std::size_t file) const
  {
    return shortened(std::filesystem::path(options_.files[file]).filename().string(), 40);
  }

  double legend_top() const { return panel_.bottom() + 76; }

  void begin(std::size_t pairs)
  {
    const std::string title = "Pairs of tracks of " + name_of(0)
                              + (options_.files.size() == 2 ? " and " + name_of(1) : "");
    const std::string counts
      = "n = " + std::to_string(tracks_.tracks.size()) + " tracks, k = " + std::to_string(pairs)
        + " pairs, distance " + shortened(distance_in_words(options_, tracks_.scene.unit), 40)
        + (tracks_.are_looked_ahead ? ", until " + shortened(options_.until_text, 20) : "");
    const double width
      = panel_.left
        + std::max({panel_.width(), narrowest, text_width(title, 19), text_width(counts)}) + 30;
    const double height = legend_top() + height_of_legend_row * (options_.files.size() + 1);
    svg_ << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
         << "' viewBox='0 0 " << width << ' ' << height
         << "' font-family='sans-serif' font-size='13' fill='#222'>\n"
         << "<rect width='100%' height='100%' fill='white'/>\n";
    write_text(svg_, {panel_.left, 30}, title, "font-size='19'");
    write_text(svg_, {panel_.left, 51}, counts);
    const std::array<std::string, 3>& names = tracks_.scene.names.front();
    write_axes(svg_, panel_, is_map() ? "longitude (deg)" : shortened(names[0], 30),
               is_map() ? "latitude (deg)" : shortened(names[1], 30));
  }

  void write_path(std::string& path, const char* color, double width)
  {
    if(!path.empty())
      svg_ << "<path fill='none' stroke-linecap='round' stroke='" << color << "' stroke-width='"
           << width << "' d='" << path << "'/>\n";
    path.clear();
  }

  // A line across the 180th meridian would run around the map: it is left out.
  bool is_drawn(Position a, Position b) const
  {
    return !tracks_.scene.is_geographic || std::abs(a.x - b.x) < 180;
  }

  // A piece of one fix, and one that is too short to be seen, is a dot.
  void draw_lines(std::size_t begin, std::size_t end, const char* color)
  {
    std::string path;
    std::set<std::string> dots;
    for(std::size_t track = begin; track < end; ++track)
      for(const Piece& piece : tracks_.tracks[track].pieces) {
        Position last = position_of(piece.front());
        std::string last_pixels = pixels(panel_.place(last)), line = 'M' + last_pixels;
        for(const Fix& fix : piece) {
          const Position next = position_of(fix);
          const std::string next_pixels = pixels(panel_.place(next));
          if(next_pixels != last_pixels)
            line += (is_drawn(last, next) ? 'L' : 'M') + next_pixels;
          last = next;
          last_pixels = next_pixels;
        }
        if(line.find('L') == std::string::npos)
          dots.insert(last_pixels);
        else
          path += line;
        if(path.size() > longest_path_of_tracks)
          write_path(path, color, 0.8);
      }
    write_path(path, color, 0.8);
    if(!dots.empty())
      write_dots(svg_, dots, color, 1.6);
  }

  void draw_approaches(const std::vector<Approach>& pairs)
  {
    std::string path;
    std::set<std::string> dots;
    for(const Approach& pair : pairs) {
      const Position a = position_of(tracks_.place_at(pair.i, pair.rounded_tick()));
      const Position b = position_of(tracks_.place_at(pair.j, pair.rounded_tick()));
      const std::string begin = pixels(panel_.place(a)), end = pixels(panel_.place(b));
      dots.insert({begin, end});
      if(begin != end && is_drawn(a, b))
        path += 'M' + begin + 'L' + end;
      if(path.size() > longest_path_of_tracks)
        write_path(path, approach_color, 1.2);
    }
    write_path(path, approach_color, 1.2);
    if(!dots.empty())
      write_dots(svg_, dots, approach_color, 3);
  }

  void draw_legend()
  {
    const double x = panel_.left + 6;
    double y = legend_top();
    const auto row = [&](const char* color, const std::string& text) {
      svg_ << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='" << color << "'/>\n";
      write_text(svg_, {x + 14, y + 5}, text);
      y += height_of_legend_row;
    };
    for(std::size_t file = 0; file < options_.files.size(); ++file)
      row(track_colors[file], "track of " + name_of(file));
    row(approach_color, "closest approach of a pair");
  }

  std::ostream& svg_;
  const Tracks& tracks_;
  const Options& options_;
  Panel panel_;
};

} // namespace

void draw_tracks(std::ostream& svg, const Tracks& tracks, const std::vector<Approach>& pairs,
                 const Options& options)
{
  Track_drawing(svg, tracks, options).draw(pairs);
}

} // namespace near_pairs
