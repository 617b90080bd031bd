"""Figures of a run, each a matplotlib figure from a Run, or None where there is nothing to draw."""
import math
import os

import matplotlib
import numpy as np

matplotlib.use("Agg")  # works without a display
from matplotlib import pyplot  # noqa: E402  after the choice of the backend
from matplotlib.colors import ListedColormap, to_rgb  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

from sylph_report.run_data import waiting_by_cause  # noqa: E402

# Okabe and Ito's colours, in the order of the robots in RViz; black for what is grey there.
ROBOT_COLORS = [
    "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#d55e00", "#000000",
]  # fmt: skip
# How far apart the lines of robots in one cell are at most, in cells.
LANES = 0.5
WAIT_COLOR = "#e69f00"
LIMIT_COLOR = "#d55e00"
# The second code for robots beyond the eighth, whose colours come again.
LINE_STYLES = ["-", (0, (4, 1.5)), (0, (1, 1)), (0, (4, 1, 1, 1))]
OBSTACLE_COLOR = "#8c8c8c"
MOST_PANELS = 16
MOST_CAUSES = 7


def all_figures(run):
    """(file name, title, what it shows, figure) of every figure that the run has data for."""
    makers = [
        ("time_space", "Time and space", TIME_SPACE_TEXT, time_space),
        ("progress", "Progress against the plan", PROGRESS_TEXT, progress),
        ("waiting", "Waiting time by cause", WAITING_TEXT, waiting),
        ("separation", "Clearance", SEPARATION_TEXT, separation),
        ("social", "SVO and partners", SOCIAL_TEXT, social),
        ("tracking", "Tracking error", TRACKING_TEXT, tracking),
    ]
    drawn = [(name, title, text, maker(run)) for name, title, text, maker in makers]
    return [entry for entry in drawn if entry[3] is not None]


TIME_SPACE_TEXT = (
    "Where each robot drove: a dot with its number is its start, a square its end. Beside the map the same drive over time by "
    "row, below it by column: a line that runs along is a robot that stands, shaded where it waited for another one."
)
PROGRESS_TEXT = (
    "Cells that each robot has reached (line) and those of the plan if no robot ever had to slow "
    "down (dashes). Shaded: its next task waits for another robot."
)
WAITING_TEXT = (
    "How long each robot waited, by the robot at the root of the wait, in its colour, and the reason; "
    "hatched where it did not just drive."
)
SEPARATION_TEXT = "Smallest gap between any two footprints. Below the limit all robots stop."
SOCIAL_TEXT = (
    "Above: SVO of the step that each robot carried out; grey where the planner gave none. "
    "Below: its partner, in the partner's colour."
)
TRACKING_TEXT = "Distance of each robot from its planned segment."


def _robots_with(run, attribute):
    return [(name, robot) for name, robot in run.robots.items() if getattr(robot, attribute)]


def color_of(run, name):
    """A robot's colour, grey for what is none of the run's."""
    names = list(run.robots)
    return ROBOT_COLORS[names.index(name) % len(ROBOT_COLORS)] if name in names else "#999999"


def _drives(reason):
    """Whether the root cause is only that a robot is still on its way."""
    return reason == "moves" or reason.startswith("is on its way")


def short_names(names):
    """The part in which names differ: of robot_0, robot_1 the number."""
    prefix = os.path.commonprefix(list(names)).rstrip("0123456789") if len(names) > 1 else ""
    return {name: name[len(prefix):] or name for name in names}


def _style(run, name):
    names = list(run.robots)
    return LINE_STYLES[names.index(name) // len(ROBOT_COLORS) % len(LINE_STYLES)]


def text_color(color):
    """Black or white, whichever can be read on this colour."""
    red, green, blue = to_rgb(color)
    return "white" if 0.299 * red + 0.587 * green + 0.114 * blue < 0.55 else "black"


def _label(axis, point, text, color, offset=(0, 0), size=8):
    """A robot's number on a disk of its colour."""
    axis.annotate(text, point, xytext=offset, textcoords="offset points", ha="center", va="center", fontsize=size,
                  color=text_color(color), zorder=6, annotation_clip=False,
                  bbox={"boxstyle": "circle,pad=0.2", "facecolor": color, "edgecolor": "white", "linewidth": 0.6})  # fmt: skip


def draw_map(axis, obstacles):
    """Cells of the map; the axes count rows and columns."""
    rows, columns = len(obstacles), len(obstacles[0])
    axis.imshow(obstacles, cmap=ListedColormap(["white", OBSTACLE_COLOR]), vmin=0, vmax=1, zorder=0)
    axis.set_xticks(np.arange(columns + 1) - 0.5, minor=True)
    axis.set_yticks(np.arange(rows + 1) - 0.5, minor=True)
    axis.grid(which="minor", color="#dddddd", linewidth=0.5)
    axis.tick_params(which="minor", length=0)


def cells_of(run, robot):
    """Arrays of time [s], row, column, yaw [rad] of a robot, rows and columns counted from the centre of cell (0, 0)."""
    poses = np.array(robot.pose)
    times = np.array(robot.error_time_s)
    known = np.isfinite(poses[:, 0])
    x, y, yaw = poses[known].T
    columns, rows_up = ((at - corner) / run.cell_size_m for at, corner in zip((x, y), run.corner_m))
    path = np.array([times[known], len(run.obstacles) - 0.5 - rows_up, columns - 0.5, yaw])
    if robot.start_cell and path.size:  # a recorder can be late for the first reports
        path = np.hstack([[[0.0], [robot.start_cell[0]], [robot.start_cell[1]], [path[3, 0]]], path])
    return path


def _waits(robot, times):
    """Which of these times lie within a wait."""
    if not robot.time_s:
        return np.zeros(len(times), bool)
    at = np.clip(np.searchsorted(robot.time_s, times, side="right") - 1, 0, None)
    return np.array(robot.waiting)[at]


def time_space(run):
    """The map with the paths driven and, sharing its axes, rows and columns over time: a drawing in three views."""
    robots = _robots_with(run, "pose") if run.obstacles else []
    if not robots:
        return None
    rows, columns = len(run.obstacles), len(run.obstacles[0])
    size = 5.0 / max(rows, columns)
    figure, axes = pyplot.subplots(
        2, 2, figsize=(11.0, 9.5), width_ratios=(columns * size, 5.6), height_ratios=(rows * size, 4.2)
    )
    (plan_axis, row_axis), (column_axis, key_axis) = axes
    draw_map(plan_axis, run.obstacles)
    names = short_names(run.robots)
    ends = {"row": {}, "column": {}}
    for index, (name, robot) in enumerate(robots):
        times, row, column, _ = cells_of(run, robot)
        if not len(times):
            continue
        color, style = color_of(run, name), _style(run, name)
        shift = LANES * ((index + 0.5) / len(robots) - 0.5)  # so that robots with the same way lie beside each other
        line = {"color": color, "linestyle": style, "linewidth": 1.6}
        plan_axis.plot(column + shift, row + shift, alpha=0.9, zorder=3, **line)
        plan_axis.plot(column[-1] + shift, row[-1] + shift, "s", color=color, markersize=8, markeredgecolor="black", zorder=4)
        _label(plan_axis, (column[0] + shift, row[0] + shift), names[name], color)
        waits = _waits(robot, times)
        row_axis.plot(times, row + shift, zorder=3, **line)
        column_axis.plot(column + shift, times, zorder=3, **line)
        shade = {"color": WAIT_COLOR, "alpha": 0.35, "linewidth": 6, "solid_capstyle": "butt", "zorder": 1}
        row_axis.plot(times, np.where(waits, row + shift, math.nan), **shade)
        column_axis.plot(np.where(waits, column + shift, math.nan), times, **shade)
        for kind, value in (("row", row[-1]), ("column", column[-1])):
            ends[kind].setdefault(round(value), []).append((name, shift))
    last_s = max(robot.error_time_s[-1] for _, robot in robots)
    for kind, axis in (("row", row_axis), ("column", column_axis)):
        for cell, members in ends[kind].items():
            for place, (name, _) in enumerate(members):
                beside = 10 + 15 * place
                point, offset = ((last_s, cell), (beside, 0)) if kind == "row" else ((cell, last_s), (0, -beside))
                _label(axis, point, names[name], color_of(run, name), offset)
    row_axis.set(xlim=(0, last_s), ylim=plan_axis.get_ylim(), xlabel="time [s]")
    column_axis.set(ylim=(last_s, 0), xlim=plan_axis.get_xlim(), ylabel="time [s]")
    column_axis.tick_params(labelbottom=False)
    plan_axis.set(xlabel="column", ylabel="row")
    key_axis.axis("off")
    sign = {"linestyle": "", "color": "white", "markeredgecolor": "black", "markersize": 9}
    key_axis.legend(
        [Line2D([], [], marker="o", **sign), Line2D([], [], marker="s", **sign),
         Line2D([], [], color=WAIT_COLOR, alpha=0.35, linewidth=6),
         *(Line2D([], [], color=color_of(run, name), linestyle=_style(run, name), linewidth=2) for name, _ in robots)],
        ["start", "end", "waits for another robot", *(name for name, _ in robots)],
        loc="center", ncols=math.ceil(len(robots) / 13), frameon=False, fontsize=9, handlelength=3,
    )  # fmt: skip
    row_axis.grid(axis="y", color="#eeeeee")
    column_axis.grid(axis="x", color="#eeeeee")
    figure.tight_layout()
    plan_axis.apply_aspect()
    plan, below, beside = (axis.get_position() for axis in (plan_axis, column_axis, row_axis))
    column_axis.set_position([plan.x0, below.y0, plan.width, below.height])
    row_axis.set_position([beside.x0, plan.y0, beside.width, plan.height])
    return figure


def progress(run):
    """Space over time, one panel a robot; of many robots those that waited longest."""
    robots = _robots_with(run, "time_s")
    if not robots:
        return None
    by_wait = sorted(robots, key=lambda entry: -sum(waiting_by_cause(entry[1]).values()))
    kept = {name for name, _ in by_wait[:MOST_PANELS]}
    robots = [entry for entry in robots if entry[0] in kept]
    columns = min(4, len(robots))
    rows = math.ceil(len(robots) / columns)
    figure, axes = pyplot.subplots(
        rows, columns, sharex=True, squeeze=False, figsize=(3.0 * columns, 2.1 * rows + 0.4)
    )
    for axis, (name, robot) in zip(axes.flat, robots):
        axis.fill_between(
            robot.time_s, 0, 1, where=robot.waiting, step="post", color=WAIT_COLOR, alpha=0.3,
            transform=axis.get_xaxis_transform(), linewidth=0,
        )  # fmt: skip
        axis.plot(robot.planned_time_s, robot.planned_cells, "--", color="#777777", linewidth=1)
        axis.step(robot.time_s, robot.cells_done, where="post", color=color_of(run, name))
        axis.set_title(name, fontsize=9)
    for axis in list(axes.flat)[len(robots) :]:
        axis.set_visible(False)
    figure.supxlabel("time [s]", fontsize=9)
    figure.supylabel("cells", fontsize=9)
    figure.tight_layout()
    return figure


def waiting(run):
    """Stacked bars: robots, and in each bar the causes."""
    robots = _robots_with(run, "time_s")
    if not robots:
        return None
    seconds = {name: waiting_by_cause(robot) for name, robot in robots}
    totals = {}
    for causes in seconds.values():
        for cause, duration in causes.items():
            totals[cause] = totals.get(cause, 0.0) + duration
    largest = sorted(totals, key=lambda cause: (-totals[cause], cause))[:MOST_CAUSES]
    figure, axis = pyplot.subplots(figsize=(10, 0.35 * len(robots) + 1.6))
    names = [name for name, _ in robots]
    left = [0.0] * len(names)
    for cause in largest + [None]:
        widths = [
            sum(s for c, s in seconds[name].items() if (c == cause or (not cause and c not in largest)))
            for name in names
        ]
        if sum(widths) == 0.0:
            continue
        label = "other causes" if cause is None else " ".join(part for part in cause if part)
        axis.barh(names, widths, left=left, label=label, height=0.7, edgecolor="white",
                  color=color_of(run, cause[0]) if cause else "#999999",
                  hatch="" if cause and _drives(cause[1]) else "///")  # fmt: skip
        left = [a + b for a, b in zip(left, widths)]
    axis.invert_yaxis()
    axis.set_xlabel("waited [s]")
    if totals:
        axis.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5), frameon=False)
    else:
        axis.text(0.5, 0.5, "nobody waited", transform=axis.transAxes, ha="center")
    figure.tight_layout()
    return figure


def separation(run):
    """Smallest gap over time, and how often which gap occurred."""
    if not run.separation:
        return None
    times, gaps = zip(*run.separation)
    gaps_mm = [1e3 * gap for gap in gaps]
    figure, (over_time, histogram) = pyplot.subplots(
        1, 2, figsize=(11, 3.0), sharey=True, width_ratios=(3, 1)
    )
    over_time.plot(times, gaps_mm, linewidth=0.8, color="#0072b2")
    over_time.set_xlabel("time [s]")
    over_time.set_ylabel("smallest gap [mm]")
    histogram.hist(gaps_mm, bins=40, orientation="horizontal", color="#56b4e9")
    histogram.set_xlabel("samples")
    for axis in (over_time, histogram):
        axis.axhline(1e3 * run.separation_limit_m, color=LIMIT_COLOR, linestyle="--")
    over_time.annotate("limit", (times[0], 1e3 * run.separation_limit_m), color=LIMIT_COLOR,
                       xytext=(2, 3), textcoords="offset points", fontsize=8)  # fmt: skip
    figure.tight_layout()
    return figure


def social(run):
    """Two strips for each robot over time: SVO and partner."""
    robots = _robots_with(run, "time_s")
    if not robots:
        return None
    names = [name for name, _ in robots]
    all_names = list(run.robots)
    figure, (svo_axis, partner_axis) = pyplot.subplots(
        2, 1, sharex=True, figsize=(11, 0.5 * len(names) + 2.0)
    )
    partner_colors = ListedColormap([color_of(run, name) for name in all_names])
    for row, (_, robot) in enumerate(robots):
        edges = robot.time_s + [robot.time_s[-1]]
        svo = svo_axis.pcolormesh(edges, [row - 0.4, row + 0.4], [robot.svo_deg], cmap="cividis",
                                  vmin=0.0, vmax=45.0)  # fmt: skip
        partners = [all_names.index(p) if p in all_names else math.nan for p in robot.partner]
        partner_axis.pcolormesh(edges, [row - 0.4, row + 0.4], [partners], cmap=partner_colors,
                                vmin=-0.5, vmax=len(all_names) - 0.5)  # fmt: skip
        partner_axis.text(-0.012, row, "\u25a0", color=color_of(run, names[row]), ha="right",
                          va="center", transform=partner_axis.get_yaxis_transform())  # fmt: skip
    if all(math.isnan(value) for _, robot in robots for value in robot.svo_deg):
        svo_axis.text(0.5, 0.5, "this planner gives no SVO", transform=svo_axis.transAxes, ha="center",
                      va="center")  # fmt: skip
    for axis in (svo_axis, partner_axis):
        axis.set_facecolor("#cccccc")
        axis.set_yticks(range(len(names)), names)
        axis.tick_params(axis="y", length=0, pad=14 if axis is partner_axis else 4)
        axis.set_ylim(len(names) - 0.5, -0.5)
    figure.colorbar(svo, ax=[svo_axis, partner_axis], label="SVO [deg]", shrink=0.5, pad=0.02)
    partner_axis.set_xlabel("time [s]")
    return figure


def tracking(run):
    """Tracking error over time, and its spread for each robot."""
    robots = _robots_with(run, "tracking_error_m")
    if not robots:
        return None
    figure, (over_time, spread) = pyplot.subplots(
        1, 2, figsize=(11, 3.0), sharey=True, width_ratios=(2, 1)
    )
    for name, robot in robots:
        errors_mm = [1e3 * error for error in robot.tracking_error_m]
        over_time.plot(robot.error_time_s, errors_mm, linewidth=0.7, color=color_of(run, name))
    spread.boxplot([[1e3 * e for e in robot.tracking_error_m] for _, robot in robots], sym="",
                   whis=(0, 100), medianprops={"color": LIMIT_COLOR})  # fmt: skip
    spread.set_xticks(range(1, len(robots) + 1), [name for name, _ in robots], rotation=90)
    over_time.set_xlabel("time [s]")
    over_time.set_ylabel("tracking error [mm]")
    for axis in (over_time, spread):
        axis.axhline(1e3 * run.tracking_limit_m, color=LIMIT_COLOR, linestyle="--")
    figure.tight_layout()
    return figure
