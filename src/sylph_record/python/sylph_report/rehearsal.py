"""A run against rehearsals of the same mission."""
import html
import json
import os
import subprocess

import roslib.packages
import yaml

from sylph_report.page import short

TIME_LIMIT_S = 60
WITHOUT_WEIGHTS = ("lacam", "pibt")
# Figures that both have.
FIGURES = ("execution_ratio", "execution_s", "plan_steps", "sum_of_costs", "min_separation_m", "max_tracking_error_m", "replans",
           "stops")  # fmt: skip


class Unavailable(Exception):
    """Why there is nothing to compare with."""


def write_experiment(run, folder, into):
    """Writes the run's mission as an experiment of its own: map, starts and goals are those of the bag. Returns its path."""
    if not run.obstacles or not all(robot.start_cell and robot.goal_cell for robot in run.robots.values()):
        raise Unavailable("the bag has no map or no state of the robots")
    with open(os.path.join(folder, "experiment.yaml"), encoding="utf-8") as file:
        experiment = yaml.safe_load(file)
    rows = ["".join("@" if is_obstacle else "." for is_obstacle in row) for row in run.obstacles]
    with open(os.path.join(into, "rehearsal.map"), "w", encoding="utf-8") as file:
        file.write(f"type octile\nheight {len(rows)}\nwidth {len(rows[0])}\nmap\n" + "\n".join(rows) + "\n")
    robots = {robot["name"]: robot for robot in experiment["robots"]}
    experiment.update(map="rehearsal.map", cell_size_m=run.cell_size_m, starts="explicit", goals="explicit", robots=[
        dict(robots.get(name, {"name": name}), start=list(robot.start_cell), goal=list(robot.goal_cell))
        for name, robot in run.robots.items()
    ])  # fmt: skip
    planning = dict(experiment.get("planning") or {})
    planning["planner"] = run.result.get("planner", planning.get("planner"))
    weights = planning.pop("weights", None)
    if weights and planning["planner"] not in WITHOUT_WEIGHTS:
        planning["weights"] = _found(weights, folder)
    experiment["planning"] = planning
    path = os.path.join(into, "rehearsal.yaml")
    with open(path, "w", encoding="utf-8") as file:
        yaml.safe_dump(experiment, file, sort_keys=False)
    return path


def _found(weights, folder):
    """A path of the experiment: it counted from the experiment's own folder, which a run folder does not name."""
    places = [folder]
    try:
        places.append(os.path.join(roslib.packages.get_pkg_dir("sylph_bringup"), "maps"))
    except roslib.packages.InvalidROSPkgException:
        pass
    for place in places:
        path = os.path.abspath(os.path.join(place, weights))
        if os.path.isfile(path):
            return path
    raise Unavailable(f"the weights {weights} are neither beside the run nor the suite's own")


def rehearse(run, folder, into, count):
    """Runs sylph_rehearse with so many seeds; the runs as it tells them."""
    found = roslib.packages.find_node("sylph_rehearsal", "sylph_rehearse")
    if not found:
        raise Unavailable("sylph_rehearse is not installed")
    try:
        command = [found[0], write_experiment(run, folder, into), "--seeds", f"1-{count}", "--json"]
        result = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False)
        return json.loads(result.stdout)["runs"]
    except subprocess.TimeoutExpired as error:
        raise Unavailable(f"{count} rehearsals take longer than {TIME_LIMIT_S} s") from error
    except (KeyError, TypeError, ValueError, OSError, yaml.YAMLError) as error:
        raise Unavailable(f"sylph_rehearse: {error!r}: {' '.join(result.stderr.split()) if 'result' in locals() else ''}") from error


def table(run, rehearsals):
    """HTML: the run's figures, and the range of those of the rehearsals that finished."""
    finished = [
        dict(rehearsal, execution_ratio=rehearsal["execution_s"] / rehearsal["ideal_execution_s"])
        for rehearsal in rehearsals
        if rehearsal["ending"] == "finished" and rehearsal["ideal_execution_s"] > 0.0
    ]
    lines = []
    for name in FIGURES:
        values = sorted(value for value in (rehearsal.get(name) for rehearsal in finished) if value is not None)
        own = run.result.get(name)
        if not values or own is None:
            continue
        where = "below all" if own < values[0] else "above all" if own > values[-1] else "within"
        cells = "".join(f'<td class="number">{html.escape(short(value))}</td>'
                        for value in (own, values[0], values[len(values) // 2], values[-1]))  # fmt: skip
        lines.append(f"<tr><td>{name}</td>{cells}<td>{where}</td></tr>\n")
    return (
        f"<h2>Against its rehearsal</h2>\n<p>{len(finished)} of {len(rehearsals)} rehearsals finished. They have the run's map, starts, "
        "goals and planner, and noise of their own; they have none of the run's faults, and other plans, since they take the "
        "planner's first solution: execution_ratio, the time over that of the plan undisturbed, can be compared, times and costs "
        'only with that in mind.</p>\n<table><tr><th>figure</th><th class="number">run</th><th class="number">least</th>'
        '<th class="number">median</th><th class="number">most</th><th></th></tr>\n' + "".join(lines) + "</table>"
    )
