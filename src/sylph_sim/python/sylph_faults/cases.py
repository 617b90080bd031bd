"""Cases of a fault campaign: what goes wrong in a run, and what is expected of it."""
import yaml

CASE_KEYS = {"name", "expect", "faults", "kills", "pauses"}
FAULT_KEYS = {"kind", "robots", "at_s", "duration_s", "value"}
KILL_KEYS = {"node", "at_s"}
PAUSE_KEYS = {"node", "at_s", "duration_s"}
EXPECTATIONS = ("arrives", "safe")


def check_case(case):
    """Raises ValueError with one line if a case is not as config/fault_campaign.yaml describes it."""
    if not isinstance(case, dict) or not isinstance(case.get("name"), str):
        raise ValueError(f"case {case}: must have a name")
    name = f"case {case['name']}"
    for keys, allowed in [(case, CASE_KEYS)] + [(fault, FAULT_KEYS) for fault in case.get("faults", [])] + \
            [(kill, KILL_KEYS) for kill in case.get("kills", [])] + \
            [(pause, PAUSE_KEYS) for pause in case.get("pauses", [])]:
        unknown = sorted(set(keys) - allowed)
        if unknown:
            raise ValueError(f"{name}: {unknown[0]}: unknown; allowed are {', '.join(sorted(allowed))}")
    if case.get("expect") not in EXPECTATIONS:
        raise ValueError(f"{name}: expect {case.get('expect')}: must be one of {', '.join(EXPECTATIONS)}")
    for key, required, times in (("faults", "kind", ["at_s"]), ("kills", "node", ["at_s"]),
                                 ("pauses", "node", ["at_s", "duration_s"])):
        for event in case.get(key, []):
            if required not in event or not all(isinstance(event.get(time), (int, float)) for time in times):
                raise ValueError(f"{name}: {key}: {event}: must have {' and '.join([required, *times])}")


def load_cases(path, names=()):
    """Cases of a campaign file, those that are named or all.

    Raises OSError, yaml.YAMLError or ValueError with one line.
    """
    with open(path, encoding="utf-8") as file:
        cases = yaml.safe_load(file)
    if not isinstance(cases, list):
        raise ValueError(f"{path}: must be a list of cases")
    for case in cases:
        try:
            check_case(case)
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from None
    known = [case["name"] for case in cases]
    for name in names:
        if name not in known:
            raise ValueError(f"no case '{name}' in {path}: it has {', '.join(known)}")
    return [case for case in cases if not names or case["name"] in names]


def judge(case, report):
    """Why a run failed, or an empty text. `report` is Watcher.watch()'s."""
    if report["outcome"] not in ("arrived", "held"):
        return report["outcome"]
    if report["collisions"] != 0:
        return "robots touched"
    if report["obstacle_entries"] != 0:
        return "a robot entered an obstacle"
    if case["expect"] == "arrives" and report["outcome"] != "arrived":
        return "robots did not arrive"
    return ""
