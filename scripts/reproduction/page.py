# SPDX-License-Identifier: AGPL-3.0-or-later
"""reproduction.md: the results of all steps as one page, the paper's numbers beside ours."""

import shutil
from pathlib import Path

from . import costs, figures, paper, wings
from .markdown import page, picture, range_of, short, table
from .run import ReproduceError
from .steps import PAPER_SETTINGS, TURNS

QUICK_WARNING = """**Small meshes (`--quick`)**: this page shows that the script works. Its numbers
are not those that the remarks are about."""

SOURCE = Path(__file__).resolve().parents[2]


def write(output, results, version, quick):
    """Draws the plots and writes the page into OUTPUT; returns what was done, in a line."""
    plots(output / "pictures", results)
    text = compose(results, version, quick, docs=f"{SOURCE}/docs/")
    (output / "reproduction.md").write_text(text)
    return f"{output / 'reproduction.md'}: {text.count('](pictures/')} figures"


def install(output, results, version, docs):
    """Puts the page and its figures into the manual."""
    text = compose(results, version, quick=False, docs="")
    if NOT_DRAWN in text:
        raise ReproduceError("docs/ is left as it is: figures are missing, which need OpenGL")
    shutil.copytree(output / "pictures", docs / "pictures", dirs_exist_ok=True)
    (docs / "reproduction.md").write_text(text)
    return f"{docs / 'reproduction.md'}: {len(text.splitlines())} lines"


def plots(folder, results):
    """The figures that need the results of several steps, or of the paper."""
    (folder / "figure_13.svg").write_text(wings.histogram_13(results["falcon-paper"]["found"]))
    (folder / "cost.svg").write_text(figures.cost(costs.growth(results)))


NOT_DRAWN = "*(This figure needs OpenGL, which was not there.)*"


def compose(results, version, quick, docs):
    drawn = {name for result in results.values() for name in result["pictures"]}
    drawn |= {"figure_13.svg", "cost.svg"}

    def figure(name, words):
        return picture(name, words) if name in drawn else NOT_DRAWN

    found = {name: result["found"] for name, result in results.items()}
    return page([
        "# The paper reproduced",
        QUICK_WARNING if quick else "",
        *introduction(version, docs),
        *wings.overview(found),
        *means(found["means"], figure, docs),
        *interface(figure, docs),
        *box(found["box"], figure),
        *wings.m6(found, figure, docs),
        *wings.falcon(found, figure, docs),
        *costs.section(results, figure),
        "## What is left out",
        f"""Figures 6 and 19 to 22 are drawings without results. The two remarks of the paper's
        conclusion, larger factors and a constant ratio, are options of `ameco coarsen`:
        [control]({docs}theory/results.md#control).""",
    ])


def introduction(version, docs):
    return [
        f"""Figures 1 to 5 of the paper and everything in its section 5, the paper's numbers beside
        ours. `scripts/reproduce --update-docs` made this page from runs of {version}; nothing on
        it is written by hand but the remarks. `scripts/reproduce --help` says how to make parts
        of it.""",
        f"""The paper's meshes are not public. Ours are [made by formula]({docs}user/cases.md): the
        same model meshes, the same wing with as many nodes and as stretched, and, for the business
        jet of section 5.3, that wing with the jet's number of nodes and aspect ratios. So node
        counts can be compared in their ratios and tendencies, not one by one.""",
        f""""Default" is `ameco coarsen` as it is; "paper's settings" is
        `ameco coarsen {' '.join(PAPER_SETTINGS)}`: the mean that the paper calls *interp*,
        equations (9) and (10), and Algorithm 1 as printed. The remesher is ours in both
        ([remeshing]({docs}theory/remeshing.md)); the paper's, MTC, is not public.""",
    ]


def means(found, figure, docs):
    by_turn = {(c["angle"], c["stretching"]): c["means"] for c in found["compared"]}
    names = [m["mean"] for m in by_turn[TURNS[0]]]
    rows = []
    for k, name in enumerate(names):
        cells = []
        for turn in TURNS:
            mean = by_turn[turn][k]
            if "failure" in mean:
                cells.append(mean["failure"])
            else:
                h1, h2 = mean["sizes"]
                cells.append(f"{short(h1 * turn[1])}, {short(h2)}")
        rows.append([name, *cells])
    failed = [t for t in TURNS if "failure" in by_turn[t][names.index("geodesic-fixed-step")]]
    geodesic = by_turn[(20, 1000)][names.index("geodesic")]
    return [
        "## Figures 1 to 3: means of metrics",
        figure("figure_1.svg", "a strip of stretched triangles over a wall that turns"),
        """Figure 1, with a stretching h max / h min of 5 so that it can be seen. `ameco case
        model-layer` makes it; the paper shows its mesh but not its construction. The means are
        those of the six triangles at the marked node.""",
        table(["h 1 x stretching, h 2", *(f"{a} deg, {s}" for a, s in TURNS)], rows),
        figure("figure_2_100.svg", "unit balls without a turn at a stretching of 100")
        + " "
        + figure("figure_2_1000.svg", "unit balls without a turn at a stretching of 1000"),
        "Figure 2: no turn, stretching 100 and 1000.",
        figure("figure_3_100.svg", "unit balls at a turn of 20 degrees, stretching 100")
        + " "
        + figure("figure_3_1000.svg", "unit balls at a turn of 20 degrees, stretching 1000"),
        "Figure 3: a turn of 20 degrees, stretching 100 and 1000.",
        f"""As in the paper: without a turn all means agree, the two stretchings differ by a scale
        of the short axis only, and with the turn the published iteration for the geodesic mean
        (`geodesic-fixed-step`) fails in {len(failed)} of {len(TURNS)} cases; *interp*
        (`corrected`) stays stretched along the wall, and *log* (`log-euclidean`) is upright in the
        scaled view.""",
        f"""Different: without a turn the paper's *interp* is a little rounder than the others, ours
        is the same, since all triangles of our strip are congruent. With the turn the geodesic
        mean, which the paper could not compute, has an aspect ratio of
        {short(geodesic['aspect_ratio'])} only: as the middle between slabs in two directions it
        loses the layer ([why]({docs}theory/means.md#means-beside-each-other)).""",
    ]


def interface(figure, docs):
    return [
        "## Figures 4 and 5: two zones beside each other",
        figure("figures_4_5.svg", "unit balls at a column of nodes, fine and asked for"),
        """Left figure 4: unit balls, at half their size, of a column of nodes whose cells are 1/8,
        3/8, 1, 1 times as high as long; the orange nodes are the paper's i and j, with equal
        widths. Then figure 5, what Algorithm 1 asks for: i doubles in both directions, j upwards
        only. Then two answers to that: Algorithm 2 keeps i as it is, and `--algorithm graded
        --gradation 1.2` lets sizes grow by 1.2 over an edge of the fine mesh, or as they do in
        it.""",
        f"""The paper's figures are sketches without numbers. The conflict is there, but the node
        between i and j already softens it, since nodal metrics are means over elements; so
        Algorithm 1 without either answer measures best
        ([figures]({docs}theory/results.md#algorithms)). Algorithm 2 is printed ambiguously; how
        we read it stands in [gradation]({docs}theory/gradation.md).""",
    ]


def arrow(counts):
    return " -> ".join(map(str, counts))


def box(found, figure):
    variants = [(3, "uniform"), (3, "alternating"), (2, "uniform"), (2, "alternating")]
    ratios = list(dict.fromkeys(row["ratio"] for row in found["rows"]))
    rows = []
    for ratio in ratios:
        for settings in (False, True):
            here = {(r["dimension"], r["diagonals"]): arrow(r["nodes"]) for r in found["rows"]
                    if r["ratio"] == ratio and r["paper_settings"] == settings}
            rows.append([
                ratio, "paper's" if settings else "default",
                arrow(paper.BOX) if ratio in ("1e-3", "1e-6") else "unchanged",
                *(here[variant] for variant in variants),
            ])
    halved = [r["aspect_ratios"][0] / r["aspect_ratios"][1] for r in found["rows"]]
    return [
        "## Section 5.1: the synthetic box",
        table(["height over length", "settings", "paper, 3-D",
               *(f"{d}-D, {name}" for d, name in variants)], rows),
        f"""Two by two by two cells (2-D: two by two), cut with uniform or alternating diagonals.
        All {len(found['rows'])} variants lose the middle layer and nothing else: the aspect ratio
        falls by a factor of {range_of(halved, short)}. The paper names no diagonals, shows 1e-3
        and says that nothing changes down to 1e-6; a 2-D box it has not.""",
        figure("figure_7.png", "the box before and after, scaled 1000 times in z"),
        "Figure 7: before and after, at a ratio of 1e-3.",
    ]
