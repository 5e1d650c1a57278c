# SPDX-License-Identifier: AGPL-3.0-or-later
"""Sections 5.2 and 5.3 of the page: the wing with 67 thousand nodes and with two million."""

from . import figures, paper
from .markdown import count, exact, per_cent, range_of, ratio, short, table


def nodes(hierarchy):
    return [level["nodes"] for level in hierarchy["levels"]]


def ratios(hierarchy):
    return [level["ratio"] for level in hierarchy["levels"][1:]]


def of_predicted(hierarchy):
    """Nodes of the coarser levels over those that their metric asks for."""
    return [level["nodes"] / level["predicted_nodes"] for level in hierarchy["levels"][1:]]


def asked_for(hierarchy):
    return count(round(hierarchy["levels"][1]["predicted_nodes"]))


def ratio_list(numbers):
    return " ".join(map(ratio, numbers))


def overview(found):
    """What the page comes to, before the details."""
    m6, falcon = found["m6"], found["falcon"]
    boxes = found["box"]["rows"]
    as_paper = sum(row["nodes"][0] * 2 == row["nodes"][1] * 3 for row in boxes)
    m6_last, last = m6["levels"][-1]["aspect_ratio"], falcon["levels"][-1]["aspect_ratio"]
    rows = [
        ["5.1: the box loses its middle layer", "for all heights",
         f"{as_paper} of {len(boxes)} variants", ""],
        ["5.2, M6: ratios of four levels", ratio_list(paper.TABLE_1_RATIOS["interp"]),
         ratio_list(ratios(m6)), ratio_list(ratios(found["m6-means"]["interp"]))],
        ["5.2: 5 % of the fourth level's nodes are above", paper.M6_TOP_5_PERCENT_LEVEL_4,
         short(m6_last["top_5_percent_above"]),
         short(found["m6-means"]["interp"]["levels"][-1]["aspect_ratio"]["top_5_percent_above"])],
        ["5.3, 2 million nodes: ratios of four levels", ratio_list(paper.TABLE_4_RATIOS),
         ratio_list(ratios(falcon)), ratio_list(ratios(found["falcon-paper"]))],
        ["5.3: largest aspect ratio of the fourth level",
         exact(paper.FALCON_LEVEL_4_MAX_ASPECT_RATIO), exact(last["max"]),
         exact(found["falcon-paper"]["levels"][-1]["aspect_ratio"]["max"])],
        ["5.3: isotropic nodes of the fourth level",
         f"{paper.FALCON_LEVEL_4_SHARE_ISOTROPIC} %", per_cent(last["share_below_5"]),
         per_cent(found["falcon-paper"]["levels"][-1]["aspect_ratio"]["share_below_5"])],
    ]
    return [table(["", "paper", "default", "paper's settings"], rows)]


def nodes_table(paper_nodes, paper_ratios, default, other):
    """Tables 2 and 4 beside ours."""
    rows = []
    for k, level in enumerate(default["levels"]):
        row = [k, count(paper_nodes[k]), ratio(paper_ratios[k - 1]) if k else ""]
        for ours in (level, other["levels"][k]):
            row += [count(ours["nodes"]), ratio(ours["ratio"]) if k else ""]
        rows.append(row)
    return table(["level", "paper: nodes", "ratio", "default: nodes", "ratio",
                  "paper's settings: nodes", "ratio"], rows)


def levels_table(default, other):
    """What else there is to say about the levels."""
    rows = []
    for k, level in enumerate(default["levels"]):
        row = [k]
        for ours in (level, other["levels"][k]):
            aspect = ours["aspect_ratio"]
            row += [per_cent(ours["nodes"] / ours["predicted_nodes"]) if k else "",
                    exact(aspect["max"]), exact(aspect["top_5_percent_above"]),
                    per_cent(aspect["share_below_5"])]
        rows.append(row)
    columns = ["of predicted", "max AR", "5 % above", "AR < 5"]
    return table(["level", *(f"{settings}: {column}" if column == columns[0] else column
                             for settings in ("default", "paper's settings")
                             for column in columns)], rows)


def m6(found, figure, docs):
    default, means = found["m6"], found["m6-means"]
    interp, log = means["interp"], means["log"]
    as_paper = interp["levels"][0]["aspect_ratio"]
    first, last = (default["levels"][k]["aspect_ratio"] for k in (0, -1))
    return [
        "## Section 5.2: the ONERA M6 wing",
        "Tables 1 and 2, by `ameco case onera-m6 --preset m6-67k`:",
        means_table(means),
        nodes_table(paper.TABLE_1["interp"], paper.TABLE_1_RATIOS["interp"], default, interp),
        levels_table(default, interp),
        """"Of predicted": nodes over those that the level's metric asks for. AR: aspect ratio of
        the nodes; "5 % above": the one that 5 % of them exceed.""",
        f"""As in the paper: ratios near 2, from one mesh alone. Different: the paper's fall from
        {paper.TABLE_1_RATIOS['interp'][0]} to {paper.TABLE_1_RATIOS['interp'][-1]}, ours with its
        settings are {range_of(ratios(interp), ratio)}: our levels have
        {range_of(of_predicted(interp), per_cent)} of the nodes that the metric asks for, since
        nodes leave layer by layer and the geometry stops few of them, which the paper names as its
        cause.""",
        f"""Our default has higher ratios, {range_of(ratios(default), ratio)}, because it coarsens
        isotropic regions in all directions, where the ratio can be 8
        ([coarsening]({docs}theory/coarsening.md#isotropic-regions)), and they are
        {per_cent(first['share_below_5'])} of the finest nodes.""",
        f"""Different as well: in the paper *log* coarsens far less than *interp*
        ({paper.TABLE_1_RATIOS['log'][0]} against {paper.TABLE_1_RATIOS['interp'][0]}); here its
        first ratio is {ratio(ratios(log)[0])} against {ratio(ratios(interp)[0])}. The two metrics
        ask for {asked_for(log)} and {asked_for(interp)} nodes on the first level, too near to each
        other for the paper's difference to come from them alone: how well its remesher followed
        either must have a part in it
        ([means]({docs}theory/results.md#means)).""",
        figure("figure_8.png", "the wing and the symmetry plane, finest mesh"),
        f"""Figure 8: the finest mesh, {count(nodes(default)[0])} nodes (paper:
        {count(paper.TABLE_1['interp'][0])}), {per_cent(as_paper['share_above_150'])} of them above
        an aspect ratio of 150 (paper: more than {paper.M6_SHARE_ABOVE_150} %).""",
        figure("figures_9_10.png", "layers at the leading edge on levels 0 and 1"),
        """Figures 9 and 10: the layers at the leading edge in the symmetry plane, finest mesh and
        first coarser one. The layers stay layers; every other one has gone.""",
        figure("figure_11.svg", "histogram of aspect ratios on all levels"),
        f"""Figure 11, with all levels. On the fourth, 5 % of the nodes are above
        {short(last['top_5_percent_above'])}; the paper has
        {paper.M6_TOP_5_PERCENT_LEVEL_4}. Four halvings of the finest mesh's
        {short(first['top_5_percent_above'])} would leave
        {short(first['top_5_percent_above'] / 16)}: ours stays near that, since its ratios do not
        fall.""",
    ]


def means_table(means):
    rows = []
    for k in range(len(nodes(means["interp"]))):
        row = [k]
        for name in ("interp", "log"):
            level = means[name]["levels"][k]
            row += [count(paper.TABLE_1[name][k]),
                    ratio(paper.TABLE_1_RATIOS[name][k - 1]) if k else "",
                    count(level["nodes"]), ratio(level["ratio"]) if k else ""]
        rows.append(row)
    return table(["level", "interp, paper: nodes", "ratio", "ours: nodes", "ratio",
                  "log, paper: nodes", "ratio", "ours: nodes", "ratio"], rows)


def falcon(found, figure, docs):
    default, other = found["falcon"], found["falcon-paper"]
    first, last = (default["levels"][k]["aspect_ratio"] for k in (0, -1))
    as_paper = other["levels"][0]["aspect_ratio"]
    top_classes = first["classes"]["nodes"][:3]
    return [
        "## Section 5.3: two million nodes",
        """The paper's mesh is that of a Falcon business jet. Ours, `ameco case onera-m6 --preset
        m6-2m`, is the M6 wing again, so the pictures show another shape; the number of nodes and
        the distribution of aspect ratios are the jet's.""",
        figure("figure_12.png", "the wing of the finest mesh, coloured by aspect ratio"),
        "Figure 12: the finest mesh's walls, coloured by aspect ratio.",
        classes_table(as_paper["classes"]["nodes"]),
        figure("figure_13.svg", "histogram of the finest mesh, the paper's and ours"),
        f"""Table 3 and figure 13, both by the paper's mean. The largest aspect ratio is
        {exact(as_paper['max'])} (paper: {exact(paper.FALCON_MAX_ASPECT_RATIO)}), 5 % of the nodes
        are above {exact(as_paper['top_5_percent_above'])} (paper: more than 5 % above
        {exact(paper.FALCON_TOP_5_PERCENT)}), {per_cent(as_paper['share_below_5'])} are isotropic,
        below 5 (paper: {paper.FALCON_SHARE_ISOTROPIC} %). Different: tets cut from prisms hardly
        have nodes of aspect ratios below 2, so class 19 is nearly empty and class 17 has twice
        the paper's nodes.""",
        nodes_table(paper.TABLE_4, paper.TABLE_4_RATIOS, default, other),
        levels_table(default, other),
        f"""Table 4. The paper's ratios fall from {paper.TABLE_4_RATIOS[0]} to
        {min(paper.TABLE_4_RATIOS)}; it says that later levels have difficulties to remove the nodes
        as the metric asks, and gives no reason why the first lose more than every other node. Ours
        are {range_of(ratios(default), ratio)}, and {range_of(ratios(other), ratio)} with the
        paper's settings, with {range_of(of_predicted(default), per_cent)} and
        {range_of(of_predicted(other), per_cent)} of the nodes asked for: where columns lose every
        other node on each level alike, the ratio has no reason to fall before the layers end.""",
        figure("figures_14_to_17.png", "the leading edge on levels 1 to 4"),
        """Figures 14 to 17: the leading edge in the symmetry plane on levels 1 to 4. The layers
        next to the wall are too thin to be seen here.""",
        figure("figures_12_to_17_layers.svg", "the layers on levels 0 to 4"),
        """The same levels where the mesh is stretched most: layers go, columns stay; so the walls
        keep their triangles until the layers over them have become as high as those are long.""",
        figure("figure_18.svg", "histogram of aspect ratios on all levels"),
        f"""Figure 18. On the fourth level {per_cent(last['share_below_5'])} of the nodes are
        isotropic, below 5; the paper has {paper.FALCON_LEVEL_4_SHARE_ISOTROPIC} %, below 6. The
        aspect ratio that 5 % of the nodes exceed falls by a factor of
        {short(first['top_5_percent_above'] / last['top_5_percent_above'])}, where four halvings
        make 16. The largest of all falls further, to {exact(last['max'])}, and the
        paper's less, to {exact(paper.FALCON_LEVEL_4_MAX_ASPECT_RATIO)}, where four halvings would
        leave {exact(paper.FALCON_MAX_ASPECT_RATIO / 16)}: in our finest mesh the first three
        classes are {count(sum(top_classes))} nodes on columns much thinner than their neighbours.
        Their metrics, means over the elements of both, ask for more than twice their own
        height.""",
    ]


def classes_table(counts):
    """Table 3; the last classes may be missing in either."""
    rows = []
    for k in range(max(len(counts), len(paper.TABLE_3))):
        high = paper.FALCON_MAX_ASPECT_RATIO / 2**k
        low = high / 2
        theirs = count(paper.TABLE_3[k]) if k < len(paper.TABLE_3) else ""
        ours = count(counts[k]) if k < len(counts) else ""
        rows.append([k + 1, f"{exact(high)} - {exact(low)}", theirs, ours])
    return table(["class", "aspect ratio (paper)", "paper: nodes", "ours: nodes"], rows)


def histogram_13(found):
    counts = found["levels"][0]["aspect_ratio"]["classes"]["nodes"]
    classes = max(len(counts), len(paper.TABLE_3))

    def shares(numbers):
        return [100 * n / sum(numbers) for n in numbers] + [0] * (classes - len(numbers))

    return figures.bars(
        "Per cent of the nodes of the finest mesh in each class of table 3",
        [str(k + 1) for k in range(classes)],
        [("paper", shares(paper.TABLE_3)), ("ours", shares(counts))], "%")
