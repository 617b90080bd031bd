"""Figures of a run, each a matplotlib figure from a Run, or None where there is nothing to draw."""
import math

import matplotlib

matplotlib.use("Agg")  # works without a display
from matplotlib import pyplot  # noqa: E402  after the choice of the backend
from matplotlib.colors import ListedColormap  # noqa: E402

from sylph_report.run_data import waiting_by_cause  # noqa: E402

# Okabe and Ito's colours, in the order of the robots in RViz; black for what is grey there.
ROBOT_COLORS = [
    "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#0072b2", "#d55e00", "#000000",
]  # fmt: skip
WAIT_COLOR = "#e69f00"
LIMIT_COLOR = "#d55e00"
MOST_PANELS = 16
MOST_CAUSES = 7


def all_figures(run):
    """(file name, title, what it shows, figure) of every figure that the run has data for."""
    makers = [
        ("progress", "Progress against the plan", PROGRESS_TEXT, progress),
        ("waiting", "Waiting time by cause", WAITING_TEXT, waiting),
        ("separation", "Clearance", SEPARATION_TEXT, separation),
        ("social", "SVO and partners", SOCIAL_TEXT, social),
        ("tracking", "Tracking error", TRACKING_TEXT, tracking),
    ]
    drawn = [(name, title, text, maker(run)) for name, title, text, maker in makers]
    return [entry for entry in drawn if entry[3] is not None]


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


def _color(run, name):
    names = list(run.robots)
    return ROBOT_COLORS[names.index(name) % len(ROBOT_COLORS)] if name in names else "#999999"


def _drives(reason):
    """Whether the root cause is only that a robot is still on its way."""
    return reason == "moves" or reason.startswith("is on its way")


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
        axis.step(robot.time_s, robot.cells_done, where="post", color=_color(run, name))
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
                  color=_color(run, cause[0]) if cause else "#999999",
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
    partner_colors = ListedColormap([_color(run, name) for name in all_names])
    for row, (_, robot) in enumerate(robots):
        edges = robot.time_s + [robot.time_s[-1]]
        svo = svo_axis.pcolormesh(edges, [row - 0.4, row + 0.4], [robot.svo_deg], cmap="cividis",
                                  vmin=0.0, vmax=45.0)  # fmt: skip
        partners = [all_names.index(p) if p in all_names else math.nan for p in robot.partner]
        partner_axis.pcolormesh(edges, [row - 0.4, row + 0.4], [partners], cmap=partner_colors,
                                vmin=-0.5, vmax=len(all_names) - 0.5)  # fmt: skip
        partner_axis.text(-0.012, row, "\u25a0", color=_color(run, names[row]), ha="right",
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
        over_time.plot(robot.error_time_s, errors_mm, linewidth=0.7, color=_color(run, name))
    spread.boxplot([[1e3 * e for e in robot.tracking_error_m] for _, robot in robots], sym="",
                   whis=(0, 100), medianprops={"color": LIMIT_COLOR})  # fmt: skip
    spread.set_xticks(range(1, len(robots) + 1), [name for name, _ in robots], rotation=90)
    over_time.set_xlabel("time [s]")
    over_time.set_ylabel("tracking error [mm]")
    for axis in (over_time, spread):
        axis.axhline(1e3 * run.tracking_limit_m, color=LIMIT_COLOR, linestyle="--")
    figure.tight_layout()
    return figure
