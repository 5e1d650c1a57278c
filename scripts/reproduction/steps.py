# SPDX-License-Identifier: AGPL-3.0-or-later
"""The steps: what is run for which figures and tables, on meshes of full or small size."""

from . import figures

PAPER_SETTINGS = ["--mean", "corrected", "--isotropic-below", "1"]
LOG_SETTINGS = ["--mean", "log-euclidean", "--isotropic-below", "1"]

MIDDLE_NODE = 12  # of the model layer
TURNS = [(0, 100), (0, 1000), (20, 100), (20, 1000)]  # figures 2 and 3: angle, stretching

M6 = ["onera-m6", "--preset"]
M6_250K = ["onera-m6", "--preset", "m6-500k", "--chord-cells", "40", "--span-cells", "28",
           "--cap-cells", "7", "--layers", "94", "--growth-layers", "47",
           "--first-height", "4e-5", "--growth", "1.13"]
M6_1M = ["onera-m6", "--preset", "m6-500k", "--chord-cells", "56", "--span-cells", "44",
         "--cap-cells", "9", "--layers", "184", "--growth-layers", "115",
         "--first-height", "3e-6", "--growth", "1.062"]
# For --quick: a small wing; and one as stretched as the falcon's mesh, with as few nodes.
SMALL = ["onera-m6", "--preset", "m6-8k", "--chord-cells", "10", "--span-cells", "6",
         "--cap-cells", "3"]
SMALL_THIN = [*SMALL, "--layers", "24", "--growth-layers", "16", "--first-height", "1e-6",
              "--growth", "2"]

BY_ASPECT_RATIO = ["--colour-by", "aspect-ratio"]
HIDE_SYMMETRY = ["--hide", "symmetry"]

RATIOS = ["1e-3", "1e-4", "1e-5", "1e-6"]

FULL = {
    "means": {},
    "interface": {},
    "box": {"ratios": RATIOS},
    "m6": {"case": [*M6, "m6-67k"]},
    "m6-means": {"case": [*M6, "m6-67k"]},
    "falcon": {"case": [*M6, "m6-2m"]},
    "falcon-paper": {"case": [*M6, "m6-2m"]},
    "cost": {"cases": [M6_250K, [*M6, "m6-500k"], M6_1M]},
}
QUICK = FULL | {
    "box": {"ratios": ["1e-3", "1e-6"]},
    "m6": {"case": SMALL},
    "m6-means": {"case": SMALL},
    "falcon": {"case": SMALL_THIN},
    "falcon-paper": {"case": SMALL_THIN},
    "cost": {"cases": [[*SMALL, "--every", "2"]]},
}


def means(run, _):
    """Figures 1 to 3."""
    run.ameco("case", "model-layer", "--angle", 20, "--stretching", 5, "-o", "sketch.mesh")
    sketch = figures.model_layer(run.scratch / "sketch.mesh", MIDDLE_NODE)
    (run.pictures / "figure_1.svg").write_text(sketch)
    pictures, compared = ["figure_1.svg"], []
    for angle, stretching in TURNS:
        run.ameco("case", "model-layer", "--angle", angle, "--stretching", stretching,
                  "-o", "strip.mesh")
        picture = f"figure_{2 if angle == 0 else 3}_{stretching}.svg"
        result = run.ameco("metric", "strip.mesh", "--compare", MIDDLE_NODE, "-o", picture)
        compared.append({"angle": angle, "stretching": stretching, "means": result["means"]})
        pictures.append(run.keep(run.scratch / picture))
    return {"compared": compared}, pictures


def interface(run, _):
    """Figures 4 and 5: a layer of aspect ratio 8 beside an isotropic zone."""
    mesh = "interface.mesh"
    run.ameco("case", "layer", "--dim", 2, "--nx", 6, "--nz", 5, "--aspect-ratio", 8,
              "--growth", 3, "--displace", 0, "--diagonals", "alternating", "-o", mesh)
    common = ["--mean", "interpolation", "--isotropic-below", 1]
    run.ameco("metric", mesh, *common, "-o", "natural.sol")
    panels = [(("natural metric", "of the fine mesh"), "natural.sol")]
    for algorithm, title in (("basic", "Algorithm 1"), ("maca", "Algorithm 2"),
                             ("graded", "graded, 1.2")):
        metric = f"{algorithm}.sol"
        run.ameco("metric", mesh, *common, "--coarsen", 2, "--algorithm", algorithm,
                  "--gradation", 1.2, "-o", metric)
        panels.append(((title, "coarse metric"), metric))
    columns, cell = 7, 1 / 6
    middle = [layer * columns + columns // 2 for layer in range(5)]
    sketch = figures.interface(
        run.scratch / mesh, [(title, run.scratch / metric) for title, metric in panels],
        (cell, 0), (5 * cell, 3.5 * cell),
        list(zip(middle, ["", "j", "", "i", ""])))
    (run.pictures / "figures_4_5.svg").write_text(sketch)
    return {}, ["figures_4_5.svg"]


def box(run, sizes):
    """Section 5.1: table of node counts, figure 7."""
    rows = []
    for ratio in sizes["ratios"]:
        for diagonals in ("uniform", "alternating"):
            for dimension in (3, 2):
                for settings in ([], PAPER_SETTINGS):
                    run.ameco("case", "box", "--ratio", ratio, "--diagonals", diagonals,
                              "--dim", dimension, "-o", "box.meshb")
                    result = run.ameco("coarsen", "box.meshb", "-o", "box", "--levels", 1,
                                       "--force", *settings)
                    levels = result["hierarchy"]["levels"]
                    rows.append({"ratio": ratio, "diagonals": diagonals, "dimension": dimension,
                                 "paper_settings": bool(settings),
                                 "nodes": [level["nodes"] for level in levels],
                                 "aspect_ratios": [level["aspect_ratio"]["max"]
                                                   for level in levels]})
    run.ameco("case", "box", "-o", "box.meshb")
    run.ameco("coarsen", "box.meshb", "-o", "box", "--levels", 1, "--force")
    drawn = run.render("figure_7.png", "box", "--levels", "0,1", "--scale", "1,1,1000",
                       "--size", "800x420")
    return {"rows": rows}, ["figure_7.png"] if drawn else []


def hierarchy_of(run, sizes, *settings):
    """Makes the case's mesh and four coarser levels; their numbers."""
    run.ameco("case", *sizes["case"], "-o", "mesh.meshb", name="case")
    result = run.ameco("coarsen", "mesh.meshb", "-o", "levels", "--levels", 4, "--force",
                       *settings, name="coarsen")
    return {"levels": result["hierarchy"]["levels"], "timing": result["timing"]}


def keep_pictures(run, names):
    """Pictures that `ameco coarsen --pictures` left in the folder; NAMES: new name of each."""
    folder = run.scratch / "levels"
    return [run.keep(folder / name, new) for name, new in names.items()
            if (folder / name).exists()]


def draw(run, views):
    """Pictures of the levels; VIEWS: file name and options of each. Those there are."""
    return [name for name, view in views.items() if run.render(name, "levels", *view)]


def m6(run, sizes):
    """Table 2, figures 8 to 11, with our defaults."""
    found = hierarchy_of(run, sizes, "--pictures")
    pictures = keep_pictures(run, {"histogram.svg": "figure_11.svg"})
    pictures += draw(run, {
        "figure_8.png": ["--size", "760x420"],
        "figures_9_10.png": ["--levels", "0,1", "--size", "1000x440", "--view", "y+",
                             "--focus", "0.012,0,0", "--height", "0.06", *BY_ASPECT_RATIO],
    })
    return found, pictures


def m6_means(run, sizes):
    """Table 1: the paper's settings with two means."""
    return {"interp": hierarchy_of(run, sizes, *PAPER_SETTINGS),
            "log": hierarchy_of(run, sizes, *LOG_SETTINGS)}, []


def falcon(run, sizes):
    """Table 4, figures 12 to 18, with our defaults."""
    found = hierarchy_of(run, sizes, "--pictures")
    pictures = keep_pictures(run, {"histogram.svg": "figure_18.svg",
                                   "layers.svg": "figures_12_to_17_layers.svg"})
    pictures += draw(run, {
        "figure_12.png": ["--size", "760x420", "--as", "surface", *HIDE_SYMMETRY,
                          *BY_ASPECT_RATIO],
        "figures_14_to_17.png": ["--levels", "1,2,3,4", "--size", "1200x420", "--view", "y+",
                                 "--focus", "0.012,0,0", "--height", "0.05", *BY_ASPECT_RATIO],
    })
    return found, pictures


def falcon_paper(run, sizes):
    """Tables 3 and 4, figure 13, with the paper's settings."""
    return hierarchy_of(run, sizes, *PAPER_SETTINGS), []


def cost(run, sizes):
    """Hierarchies of sizes between those of m6 and falcon, for their times and memory."""
    found = []
    for case in sizes["cases"]:
        found.append(hierarchy_of(run, {"case": case}))
    return {"hierarchies": found}, []


STEPS = {
    "means": means,
    "interface": interface,
    "box": box,
    "m6": m6,
    "m6-means": m6_means,
    "falcon": falcon,
    "falcon-paper": falcon_paper,
    "cost": cost,
}
