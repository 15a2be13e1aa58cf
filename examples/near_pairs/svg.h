// Copyright (c) 2026 The Thick_intersection_d authors.
// SPDX-License-Identifier: LGPL-3.0-or-later

// What an SVG drawing with panels is made of: positions, text, frames, axes and a scale bar.

#ifndef NEAR_PAIRS_SVG_H
#define NEAR_PAIRS_SVG_H

#include <ostream>
#include <set>
#include <string>

namespace near_pairs {

struct Position
{
  double x, y;
};

// A window of the scene and the rectangle of the drawing, in pixels, that shows it.
struct Panel
{
  Position low = {0, 0}, high = {1, 1}; // of the window, in the unit of the scene
  double left = 0, top = 0;
  double x_scale = 1, y_scale = 1; // pixels per unit; they differ for longitude and latitude

  double width() const { return (high.x - low.x) * x_scale; }
  double height() const { return (high.y - low.y) * y_scale; }
  double bottom() const { return top + height(); }
  Position center() const { return {(low.x + high.x) / 2, (low.y + high.y) / 2}; }
  Position place(Position p) const
  {
    return {left + (p.x - low.x) * x_scale, top + (high.y - p.y) * y_scale};
  }
  bool shows(Position p) const
  {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
  }
};

// Throws Error if doubles cannot tell how long the sides of the window are.
void check_window(const Panel& panel);

// A number in the fewest characters that tell it to `digits` digits.
std::string short_number(double value, int digits = 10);

// "x y", to a tenth of a pixel.
std::string pixels(Position p);

// At least the width of a text, in pixels: which font shows it is not known.
double text_width(const std::string& text, double font_size = 13);

// `style` is a list of SVG attributes.
void write_text(std::ostream& svg, Position p, const std::string& text, const char* style = "");

// Draws a dot at each of the places, which pixels() made: dots that look the same are drawn once.
void write_dots(std::ostream& svg, const std::set<std::string>& places, const char* color,
                double size);

void write_frame(std::ostream& svg, const Panel& panel, const char* color);

// The frame of a panel with ticks, their numbers and the names of the axes.
void write_axes(std::ostream& svg, const Panel& panel, const std::string& x_name,
                const std::string& y_name);

// The room that the numbers and the name of the axis need on the left of a panel.
double y_axis_width(const Panel& panel);

// A bar of a round length under the panel; one unit of the scene is `factor` times `unit`.
void write_scale_bar(std::ostream& svg, const Panel& panel, double factor,
                     const std::string& unit);

} // namespace near_pairs

#endif // NEAR_PAIRS_SVG_H
