# What the scripts that draw SVG files share: colors, and a drawing.
#
# SPDX-License-Identifier: LGPL-3.0-or-later

POINT, PALE, STRIP, CUT, PAIR, CELL = ("#1d3557", "#8fa3b8", "#f6d9a8", "#b3261e", "#2a7f3f",
                                       "#cfe3f5")
FONT = 'font-family="Helvetica, Arial, sans-serif"'


class Drawing:
    def __init__(self, width, height, title):
        self.parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                      f'viewBox="0 0 {width} {height}" {FONT}>', f"<title>{title}</title>",
                      '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="6" refY="3" '
                      'orient="auto-start-reverse"><path d="M0,0 L6,3 L0,6" fill="none" '
                      'stroke="#222"/></marker></defs>',
                      f'<rect width="{width}" height="{height}" fill="white"/>']

    def rectangle(self, x, y, width, height, fill="none", stroke="none"):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" '
                          f'height="{height:.1f}" fill="{fill}" stroke="{stroke}"/>')

    def line(self, a, b, color, style='stroke-width="2"'):
        self.parts.append(f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" '
                          f'stroke="{color}" {style}/>')

    def arrow(self, a, b):
        self.line(a, b, "#222", 'stroke-width="1.2" marker-start="url(#tip)" '
                  'marker-end="url(#tip)"')

    def circle(self, at, radius=4.5, fill=POINT, style=""):
        self.parts.append(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="{radius:.1f}" '
                          f'fill="{fill}" {style}/>')

    def text(self, x, y, words, anchor="middle", color="#222", style=""):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-size="13" fill="{color}" '
                          f'text-anchor="{anchor}" {style}>{words}</text>')

    def write(self, file):
        with open(file, "w") as out:
            out.write("\n".join(self.parts + ["</svg>"]) + "\n")
