# SPDX-License-Identifier: AGPL-3.0-or-later
"""Times and memory: the last section of the page."""

from .markdown import count, mebibytes, table
from .wings import nodes


def coarsening_runs(results):
    """(hierarchy, its run of `ameco coarsen`) of all sizes with default settings, ascending."""
    pairs = [(results[step]["found"], run) for step in ("m6", "falcon")
             for run in results[step]["runs"] if run["name"] == "coarsen"]
    cost = results["cost"]
    runs = [run for run in cost["runs"] if run["name"] == "coarsen"]
    pairs += zip(cost["found"]["hierarchies"], runs)
    return sorted(pairs, key=lambda pair: nodes(pair[0])[0])


def microseconds(hierarchy, run):
    """Processor time per node of the levels that were coarsened."""
    return 1e6 * run["cpu_seconds"] / sum(nodes(hierarchy)[:-1])


def growth(results):
    """Rows of figures.cost."""
    return [(nodes(h)[0], microseconds(h, run), run["peak_bytes"])
            for h, run in coarsening_runs(results)]


def size_rows(results):
    rows = []
    for hierarchy, run in coarsening_runs(results):
        finest = hierarchy["levels"][0]
        rows.append([
            count(finest["nodes"]), count(finest["elements"]),
            f"{run['cpu_seconds']:,.1f}", f"{run['wall_seconds']:,.1f}",
            f"{microseconds(hierarchy, run):.0f}", mebibytes(run["peak_bytes"]),
            f"{run['peak_bytes'] / finest['nodes']:,.0f}",
        ])
    return rows


PHASES = ["metric", "order", "remove", "swap", "check", "statistics", "write"]


def phase_rows(hierarchy):
    rows = []
    for level, timing in zip(hierarchy["levels"], hierarchy["timing"]["levels"]):
        seconds = timing["seconds"]
        rows.append([level["level"], count(level["nodes"]),
                     *(f"{seconds[phase]:.2f}" for phase in PHASES), f"{seconds['total']:.2f}"])
    return rows


def step_rows(results):
    rows = []
    for step, result in results.items():
        runs = result["runs"]
        rows.append([
            f"`{step}`", len(runs), f"{sum(r['cpu_seconds'] for r in runs):,.1f}",
            f"{sum(r['wall_seconds'] for r in runs):,.1f}",
            mebibytes(max(r["peak_bytes"] for r in runs)),
        ])
    runs = [run for result in results.values() for run in result["runs"]]
    rows.append(["all", len(runs), f"{sum(r['cpu_seconds'] for r in runs):,.0f}",
                 f"{sum(r['wall_seconds'] for r in runs):,.0f}",
                 mebibytes(max(r["peak_bytes"] for r in runs))])
    return rows


def commands(results):
    """What makes the meshes and hierarchies of the wings, by step."""
    lines = []
    for step in ("m6", "m6-means", "falcon", "falcon-paper", "cost"):
        lines.append(f"# {step}")
        lines += [run["command"] for run in results[step]["runs"]
                  if run["name"] in ("case", "coarsen")]
    return lines


def about_machine(results):
    """Which machine, and how busy others kept it."""
    machines = sorted({result["machine"] for result in results.values()})
    runs = [run for result in results.values() for run in result["runs"]]
    others = sum(run["others_cpu_seconds"] for run in runs)
    wall = sum(run["wall_seconds"] for run in runs)
    text = f"Machine: {'; '.join(machines)}. "
    if others < 0.05 * wall:
        return text + "Other programs took less than 5 % of one core."
    return text + f"""It was shared: while ours ran, for {wall:,.0f} seconds by the clock, other
        programs took {others:,.0f} seconds of processor time. So look at processor time and at
        ratios; on a quiet machine wall-clock times are shorter."""


def section(results, figure):
    rows = growth(results)
    smallest, largest = rows[0], rows[-1]
    threads = results["falcon"]["found"]["timing"]["threads"]
    on_threads = f"{threads} threads" if threads > 1 else "one thread"
    return [
        "## Times and memory",
        about_machine(results),
        "Four coarser levels by `ameco coarsen` with its defaults, reading and writing included:",
        table(["nodes", "tets", "processor [s]", "wall clock [s]", "µs per coarsened node",
               "peak memory [MiB]", "bytes per node"], size_rows(results)),
        figure("cost.svg", "time per node and memory per node over the size of the mesh"),
        f"""From {count(smallest[0])} to {count(largest[0])} nodes, {largest[0] / smallest[0]:.0f}
        times as many, the time per node goes from {smallest[1]:.0f} to {largest[1]:.0f} µs, memory
        per node from {smallest[2] / smallest[0]:,.0f} to {largest[2] / largest[0]:,.0f} bytes.
        "Coarsened nodes" are those of all levels but the last. Between the presets `m6-67k`,
        `m6-500k` and `m6-2m` are two more wings. The paper gives no times.""",
        f"Where the time goes with two million nodes, on {on_threads}, seconds by the clock:",
        table(["level", "nodes", *PHASES, "total"], phase_rows(results["falcon"]["found"])),
        "The commands that made these wings and their levels:",
        "```sh\n" + "\n".join(commands(results)) + "\n```",
        "The steps of `scripts/reproduce`, pictures included:",
        table(["step", "runs", "processor [s]", "wall clock [s]", "peak memory [MiB]"],
              step_rows(results)),
    ]
