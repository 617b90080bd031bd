"""The report as one HTML page beside its figures."""
import html
import os

from matplotlib import pyplot

from sylph_report import animation
from sylph_report.figures import all_figures
from sylph_report.run_data import waiting_by_cause

STYLE = """
body { font-family: "Liberation Sans", Arial, sans-serif; max-width: 66rem; margin: 2rem auto; color: #222; }
img { max-width: 100%; }
table { border-collapse: collapse; }
td, th { text-align: left; padding: 0.15rem 1.5rem 0.15rem 0; border-bottom: 1px solid #ddd; }
td.number, th.number { text-align: right; }
.missing { color: #a04000; }
"""


def write(run, folder, is_animated=True, rehearsal=""):
    """Writes report.html and its figures into `folder`, which is made. `rehearsal` is HTML. Returns the page's path."""
    os.makedirs(folder, exist_ok=True)
    parts = [_head(run), _result_table(run), rehearsal]
    if is_animated:
        parts.append(_animation(run, folder))
    for name, title, text, figure in all_figures(run):
        file_name = f"{name}.png"
        figure.savefig(os.path.join(folder, file_name), dpi=110, bbox_inches="tight")
        pyplot.close(figure)
        parts.append(
            f"<h2>{title}</h2>\n<p>{html.escape(text)}</p>\n"
            f'<img src="{file_name}" alt="{html.escape(title)}">\n'
        )
    parts.append(_cause_table(run))
    parts.append(_event_table(run))
    path = os.path.join(folder, "report.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "</body></html>\n")
    return path


def _animation(run, folder):
    factor = animation.write(run, os.path.join(folder, "run.gif"))
    if factor is None:
        return ""
    return f'<h2>The run</h2>\n<p>{factor:.1f} times as fast.</p>\n<img src="run.gif" alt="The run, animated">\n'


def _head(run):
    name = html.escape(run.name)
    missing = "".join(f'<p class="missing">{html.escape(line)}</p>\n' for line in run.missing)
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{name}</title>'
        f"<style>{STYLE}</style></head><body>\n<h1>{name}</h1>\n{missing}"
    )


def _result_table(run):
    values = {**run.result, **run.truth}
    if not values:
        return ""
    rows = "".join(
        f'<tr><td>{html.escape(str(key))}</td><td class="number">{html.escape(short(value))}</td></tr>\n'
        for key, value in values.items()
    )
    return f"<h2>Result</h2>\n<table>\n{rows}</table>"


def short(value):
    """A value of a result as a reader wants it."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _cause_table(run):
    rows = []
    for name, robot in run.robots.items():
        for (cause, reason), seconds in waiting_by_cause(robot).items():
            rows.append((seconds, name, cause, reason))
    if not rows:
        return ""
    cells = "".join(
        f'<tr><td>{html.escape(name)}</td><td>{html.escape(cause)}</td>'
        f'<td>{html.escape(reason)}</td><td class="number">{seconds:.1f}</td></tr>\n'
        for seconds, name, cause, reason in sorted(rows, reverse=True)
    )
    return (
        "<h2>Who waited for whom</h2>\n<table><tr><th>robot</th><th>root cause</th><th>reason</th>"
        f'<th class="number">waited [s]</th></tr>\n{cells}</table>'
    )


# Events of each single task are in the figures.
TOLD_EVENTS = ("plan", "refused", "abandoned", "condition", "lost", "mode")


def _event_table(run):
    told = [event for event in run.events if event["event"] in TOLD_EVENTS]
    if not told:
        return ""
    first_s = run.events[0]["stamp"]
    rows = "".join(
        f'<tr><td class="number">{event["stamp"] - first_s:.1f}</td>'
        f"<td>{html.escape(_event_words(event))}</td>"
        f'<td>{html.escape(str(event.get("reason", "")))}</td></tr>\n'
        for event in told
    )
    return f'<h2>Events</h2>\n<table><tr><th class="number">[s]</th></tr>\n{rows}</table>'


def _event_words(event):
    kind = event["event"]
    if kind == "plan":
        return f'plan {event.get("plan_id")}'
    if kind == "mode":
        return f'mode {event.get("mode")}'
    if kind == "condition":
        return f'{event.get("robot")} {event.get("condition")}'
    return f'{kind} {event.get("robot", "")}'
