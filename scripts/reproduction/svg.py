# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pictures in SVG: on white, so that they can be read in light and dark pages."""

import math
from xml.sax.saxutils import escape

# Distinguishable without colour vision; those of core/base/svg.h.
COLOURS = ["#1f4e79", "#d95f02", "#1b9e77", "#7570b3", "#e6ab02", "#a6761d", "#666666", "#e7298a"]
INK, GRID, PAPER = "#222222", "#dddddd", "#ffffff"


class Picture:
    """Collects shapes; y goes downwards, lengths are pixels."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.parts = []

    def line(self, x1, y1, x2, y2, colour=INK, width=1.0, dash=None):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(
            f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
            f'stroke="{colour}" stroke-width="{width:g}"{dashes}/>'
        )

    def path(self, points, colour=INK, width=1.0, fill="none", closed=False, opacity=1.0):
        steps = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.parts.append(
            f'<path d="M{steps}{"Z" if closed else ""}" fill="{fill}" fill-opacity="{opacity:g}" '
            f'stroke="{colour}" stroke-width="{width:g}"/>'
        )

    def rectangle(self, x, y, width, height, fill):
        self.parts.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" height="{height:.1f}" '
            f'fill="{fill}"/>'
        )

    def circle(self, x, y, radius, fill):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius:g}" fill="{fill}"/>')

    def text(self, x, y, text, anchor="start", colour=INK, bold=False):
        weight = ' font-weight="bold"' if bold else ""
        self.parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}"{weight}>'
            f"{escape(text)}</text>"
        )

    def legend(self, x, y, names, step):
        """Squares of colour and names, `step` pixels apart."""
        for k, name in enumerate(names):
            self.rectangle(x + k * step, y - 10, 12, 12, COLOURS[k])
            self.text(x + k * step + 18, y, name)

    def __str__(self):
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
            f'viewBox="0 0 {self.width} {self.height}" font-family="sans-serif" font-size="12">\n'
            f'<rect width="100%" height="100%" fill="{PAPER}"/>\n'
            + "\n".join(self.parts) + "\n</svg>\n"
        )


class LogAxis:
    """Places of numbers on a logarithmic axis whose ends are given in pixels."""

    def __init__(self, low, high, begin, end):
        self.low, self.high = low, high
        self.begin, self.end = begin, end

    def __call__(self, value):
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.begin + share * (self.end - self.begin)


def step_near(range_, count):
    """A round step (1, 2 or 5 times a power of ten) that cuts `range_` in about `count` parts."""
    rough = range_ / count
    power = 10 ** math.floor(math.log10(rough))
    return next(m * power for m in (1, 2, 5, 10) if m * power >= rough)
