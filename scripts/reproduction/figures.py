# SPDX-License-Identifier: AGPL-3.0-or-later
"""Figures that no command of ameco draws: the sketches of figures 1, 4 and 5, and plots."""

import math

from .svg import COLOURS, GRID, INK, LogAxis, Picture, step_near


def read_section(path, keyword, skip=0):
    """Rows of numbers of a section of a text file in Medit's format."""
    words = iter(path.read_text().split("\n"))
    for line in words:
        if line.strip() == keyword:
            break
    count = int(next(words))
    for _ in range(skip):
        next(words)
    return [[float(word) for word in next(words).split()] for _ in range(count)]


def read_plane_mesh(path):
    """Points (x, y), and triangles of indices from 0."""
    points = [tuple(row[:2]) for row in read_section(path, "Vertices")]
    triangles = [[int(v) - 1 for v in row[:3]] for row in read_section(path, "Triangles")]
    return points, triangles


def read_plane_metric(path):
    """Tensors (xx, xy, yy), one per node."""
    return read_section(path, "SolAtVertices", skip=1)


def unit_ball(centre, tensor, scale):
    """Outline of the tensor's unit ball, `scale` times as large, around a place."""
    xx, xy, yy = tensor
    outline = []
    for k in range(72):
        c, s = math.cos(math.tau * k / 72), math.sin(math.tau * k / 72)
        radius = scale / math.sqrt(xx * c * c + 2 * xy * c * s + yy * s * s)
        outline.append((centre[0] + radius * c, centre[1] + radius * s))
    return outline


class Window:
    """A part of the plane in a rectangle of pixels; y goes up, both axes have the same scale."""

    def __init__(self, low, high, left, top, width):
        self.low, self.left, self.top = low, left, top
        self.scale = width / (high[0] - low[0])
        self.height = (high[1] - low[1]) * self.scale

    def __call__(self, point):
        x, y = point
        return (
            self.left + (x - self.low[0]) * self.scale,
            self.top + self.height - (y - self.low[1]) * self.scale,
        )


def draw_mesh(picture, window, points, triangles, colour):
    for triangle in triangles:
        picture.path([window(points[v]) for v in triangle], colour, 0.8, closed=True)


def model_layer(mesh, node):
    """Figure 1: a strip of stretched triangles over a wall that turns under the node `node`."""
    points, triangles = read_plane_mesh(mesh)
    low = [min(p[k] for p in points) for k in (0, 1)]
    high = [max(p[k] for p in points) for k in (0, 1)]
    window = Window(low, high, 40, 20, 560)
    picture = Picture(660, round(window.height) + 50)
    draw_mesh(picture, window, points, triangles, COLOURS[0])
    picture.circle(*window(points[node]), 4.5, COLOURS[1])

    # The wall's nodes come first, from left to right, as many as there are layers of nodes.
    columns = math.isqrt(len(points))
    wall = points[:columns]
    turn, before, after = wall[columns // 2], wall[columns // 2 - 1], wall[columns // 2 + 1]
    ahead = (2 * turn[0] - before[0], 2 * turn[1] - before[1])
    picture.line(*window(turn), *window(ahead), INK, 1, "4 3")
    x, y = window(((turn[0] + ahead[0] + after[0]) / 3, (turn[1] + ahead[1] + after[1]) / 3))
    picture.text(x + 20, y + 4, "\u03b1", "middle", bold=True)
    x, y = window(((wall[0][0] + wall[1][0]) / 2, (wall[0][1] + wall[1][1]) / 2))
    picture.text(x + 6, y + 20, "h max", "middle")
    foot, top = window(wall[-1]), window(points[2 * columns - 1])
    picture.text(max(foot[0], top[0]) + 8, (foot[1] + top[1]) / 2 + 4, "h min")
    return str(picture)


def interface(mesh, panels, window_low, window_high, balls):
    """Figures 4 and 5: unit balls of half the size at some nodes, on what a window shows.

    panels: (two lines of title, metric file); balls: (node, letter or "") from back to front.
    """
    points, triangles = read_plane_mesh(mesh)
    inside = [
        all(window_low[d] - 1e-9 <= p[d] <= window_high[d] + 1e-9 for d in (0, 1)) for p in points
    ]
    shown = [t for t in triangles if all(inside[v] for v in t)]
    width, gap, top = 240, 16, 56
    picture = Picture(gap + len(panels) * (width + gap), 0)
    for k, (title, metric) in enumerate(panels):
        window = Window(window_low, window_high, gap + k * (width + gap), top, width)
        for row, line in enumerate(title):
            picture.text(window.left + width / 2, 20 + 18 * row, line, "middle", bold=row == 0)
        draw_mesh(picture, window, points, shown, "#bbbbbb")
        tensors = read_plane_metric(metric)
        for node, letter in balls:
            colour = COLOURS[1] if letter else COLOURS[0]
            outline = [window(p) for p in unit_ball(points[node], tensors[node], 0.5)]
            picture.path(outline, colour, 1.6, colour, closed=True, opacity=0.15)
        for node, letter in balls:
            x, y = window(points[node])
            picture.text(x, y + 4, letter, "middle", bold=True)
        picture.height = round(top + window.height) + 30
    return str(picture)


def bars(title, labels, series, unit):
    """Bars beside each other. labels: of the classes; series: (name, values) of each colour."""
    left, top, width, height = 60, 44, 800, 280
    picture = Picture(left + width + 20, top + height + 84)
    picture.text(left, 22, title)
    highest = max(max(values) for _, values in series)
    step = step_near(highest, 5)
    highest = step * math.ceil(highest / step)
    for k in range(round(highest / step) + 1):
        y = top + height * (1 - k * step / highest)
        picture.line(left, y, left + width, y, GRID)
        picture.text(left - 6, y + 4, f"{k * step:g}", "end")
    picture.text(left - 6, top - 12, unit, "end")
    place = width / len(labels)
    thick = 0.8 * place / len(series)
    for k, label in enumerate(labels):
        for j, (_, values) in enumerate(series):
            tall = height * values[k] / highest
            x = left + (k + 0.1) * place + j * thick
            picture.rectangle(x, top + height - tall, thick, tall, COLOURS[j])
        picture.text(left + (k + 0.5) * place, top + height + 18, label, "middle")
    picture.text(left + width / 2, top + height + 38, "class of aspect ratios", "middle")
    picture.legend(left, top + height + 66, [name for name, _ in series], 200)
    return str(picture)


def cost(rows):
    """Time per node and memory over the number of nodes. rows: (nodes, us per node, bytes)."""
    picture = Picture(880, 370)
    sizes = [row[0] for row in rows]
    low, high = min(sizes) / 1.4, max(sizes) * 1.4
    panels = [
        ("Processor time per coarsened node [µs]", [row[1] for row in rows], "{:.0f}"),
        ("Peak memory per node of the finest mesh [bytes]",
         [row[2] / row[0] for row in rows], "{:.0f}"),
    ]
    for k, (title, values, form) in enumerate(panels):
        left, top, width, height = 60 + k * 430, 50, 360, 240
        across = LogAxis(low, high, left, left + width)
        step = step_near(max(values), 5)
        top_value = step * math.ceil(max(values) * 1.05 / step)
        picture.text(left - 30, 24, title)
        for j in range(round(top_value / step) + 1):
            y = top + height * (1 - j * step / top_value)
            picture.line(left, y, left + width, y, GRID)
            picture.text(left - 6, y + 4, f"{j * step:g}", "end")
        dots = [
            (across(n), top + height * (1 - v / top_value)) for n, v in zip(sizes, values)
        ]
        picture.path(dots, COLOURS[k], 2)
        for (x, y), nodes, value in zip(dots, sizes, values):
            picture.circle(x, y, 4, COLOURS[k])
            picture.text(x, y - 10, form.format(value), "middle")
            picture.line(x, top + height, x, top + height + 5)
            picture.text(x, top + height + 20, short_count(nodes), "middle")
        picture.text(left + width / 2, top + height + 44, "nodes of the finest mesh (logarithmic)",
                     "middle")
    return str(picture)


def short_count(count):
    """67455 is 67k, 2008320 is 2.0M."""
    return f"{count / 1e6:.1f}M" if count >= 999500 else f"{count / 1e3:.0f}k"
