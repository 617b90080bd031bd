"""Two runs side by side."""
import html
import math
import os

from sylph_report.page import STYLE, short
from sylph_report.run_data import waiting_by_cause

# Figures of a result that say how good a run was: True, more is better; False, less is.
BETTER_MORE = {
    "success": True,
    "arrived": True,
    "min_separation_m": True,
    "true smallest gap [m]": True,
    "plan_steps": False,
    "sum_of_costs": False,
    "planning_s": False,
    "execution_s": False,
    "critical_path_cells": False,
    "ideal_execution_s": False,
    "execution_ratio": False,
    "max_tracking_error_m": False,
    "replans": False,
    "stops": False,
    "collisions": False,
    "true collisions": False,
    "waited [s]": False,
}
# Those that only mean something of a mission that has been done: one that fails at once is no quick one.
OF_A_SUCCESS = ("plan_steps", "sum_of_costs", "critical_path_cells", "ideal_execution_s", "execution_s", "execution_ratio",
                "waited [s]")  # fmt: skip


def figures_of(run):
    """Name -> value: the result, the truth of a simulation, and the waits of all robots by cause."""
    figures = {**run.result, **run.truth}
    waits = {}
    for robot in run.robots.values():
        for (_, reason), seconds in waiting_by_cause(robot).items():
            waits[reason] = waits.get(reason, 0.0) + seconds
    if any(robot.waiting for robot in run.robots.values()):
        figures["waited [s]"] = sum(waits.values())
        figures.update({f"waited [s]: {reason}": seconds for reason, seconds in sorted(waits.items())})
    return figures


def rows(first, second):
    """(figure, value of the first, of the second, difference or None, index of the better or None) of two runs."""
    values = figures_of(first), figures_of(second)
    have_succeeded = all(of_run.get("success") is True for of_run in values)
    for name in {**values[0], **values[1]}:
        waited = 0.0 if name.startswith("waited [s]: ") else None
        one, other = (of_run.get(name, waited) for of_run in values)
        are_numbers = _is_number(one) and _is_number(other)
        difference = other - one if are_numbers and not isinstance(one, bool) else None
        better = None
        is_comparable = have_succeeded or name not in OF_A_SUCCESS
        if name in BETTER_MORE and are_numbers and one != other and is_comparable:
            better = int((other > one) == BETTER_MORE[name])
        yield name, one, other, difference, better


def _is_number(value):
    return isinstance(value, (bool, int, float)) and math.isfinite(value)


def write(first, second, pages, path):
    """Writes the page; `pages` are the runs' own folders with their figures, as seen from it."""
    head = "".join(f'<th class="number"><a href="{html.escape(page)}/report.html">{html.escape(run.name)}</a></th>'
                   for run, page in zip((first, second), pages))  # fmt: skip
    mark = " \u2713"
    lines = []
    for name, one, other, difference, better in rows(first, second):
        cells = [f'<td class="number{" better" if better == index else ""}">'
                 f'{html.escape("" if value is None else short(value))}{mark if better == index else ""}</td>'
                 for index, value in enumerate((one, other))]  # fmt: skip
        change = "" if not difference else f"{difference:+.4g}"
        lines.append(f'<tr><td>{html.escape(name)}</td>{"".join(cells)}<td class="number">{change}</td></tr>\n')
    pictures = []
    for name in ("time_space", "waiting", "separation"):
        images = [os.path.join(page, f"{name}.png") for page in pages]
        if all(os.path.isfile(os.path.join(os.path.dirname(path), image)) for image in images):
            pictures.append("<tr>" + "".join(f'<td><img src="{html.escape(i)}" alt="{name}"></td>' for i in images) + "</tr>\n")
    title = f"{html.escape(first.name)} and {html.escape(second.name)}"
    with open(path, "w", encoding="utf-8") as file:
        file.write(
            f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
            f"<style>{STYLE}.better {{ font-weight: bold; }}\nbody {{ max-width: 100rem; }}</style></head><body>\n<h1>{title}</h1>\n"
            "<p>\u2713 marks the better one, where more or less of a figure is better.</p>\n"
            f'<table><tr><th>figure</th>{head}<th class="number">difference</th></tr>\n{"".join(lines)}</table>\n'
            f'<table class="pictures">{"".join(pictures)}</table></body></html>\n'
        )
    return path
