#!/usr/bin/env python3
"""Reading and judging the cases of a fault campaign."""
import os
import tempfile
import unittest

import rosunit
from sylph_faults.cases import judge, load_cases

SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "config", "fault_campaign.yaml")
GOOD_REPORT = {"outcome": "arrived", "collisions": 0, "obstacle_entries": 0}


class FaultCasesTest(unittest.TestCase):

    def assert_refused(self, text, expected):
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write(text)
            file.flush()
            with self.assertRaises(ValueError) as caught:
                load_cases(file.name)
        self.assertIn(expected, str(caught.exception))

    def test_the_shipped_campaign_has_cases_of_every_kind_of_fault(self):
        cases = load_cases(SHIPPED)
        kinds = {fault["kind"] for case in cases for fault in case.get("faults", [])}
        self.assertEqual(kinds, {
            "stuck", "slow", "dead", "deaf", "drift", "lost", "nan", "frozen", "yaw_flip", "jump", "swap", "silent"
        })
        self.assertTrue(any(case.get("kills") for case in cases))
        self.assertTrue(any(case.get("pauses") for case in cases))
        self.assertEqual(len(cases), len({case["name"] for case in cases}))

    def test_picks_cases_by_name(self):
        self.assertEqual(["dead"], [case["name"] for case in load_cases(SHIPPED, ["dead"])])
        with self.assertRaisesRegex(ValueError, "no case 'daed'.*dead"):
            load_cases(SHIPPED, ["daed"])

    def test_bad_cases_are_named(self):
        self.assert_refused("name: a", "must be a list")
        self.assert_refused("- {expect: arrives}", "must have a name")
        self.assert_refused("- {name: a, expect: wins}", "case a: expect wins")
        self.assert_refused("- {name: a, expect: safe, fault: []}", "case a: fault: unknown")
        self.assert_refused("- {name: a, expect: safe, faults: [{kind: lost}]}", "must have kind and at_s")
        self.assert_refused("- {name: a, expect: safe, faults: [{kind: lost, at_s: 1, till: 2}]}", "till: unknown")
        self.assert_refused("- {name: a, expect: safe, kills: [{at_s: 1}]}", "must have node and at_s")
        self.assert_refused("- {name: a, expect: safe, pauses: [{node: b, at_s: 1}]}",
                            "must have node and at_s and duration_s")

    def test_arriving_without_contact_passes(self):
        self.assertEqual("", judge({"expect": "arrives"}, GOOD_REPORT))
        self.assertEqual("", judge({"expect": "safe"}, GOOD_REPORT))

    def test_holding_passes_only_where_nobody_needs_to_arrive(self):
        report = dict(GOOD_REPORT, outcome="held")
        self.assertEqual("robots did not arrive", judge({"expect": "arrives"}, report))
        self.assertEqual("", judge({"expect": "safe"}, report))

    def test_contact_never_passes(self):
        self.assertEqual("robots touched", judge({"expect": "safe"}, dict(GOOD_REPORT, collisions=1)))
        self.assertEqual("a robot entered an obstacle",
                         judge({"expect": "safe"}, dict(GOOD_REPORT, obstacle_entries=1)))

    def test_a_run_that_says_nothing_does_not_pass(self):
        self.assertEqual("no robot moved", judge({"expect": "safe"}, {"outcome": "no robot moved"}))


if __name__ == "__main__":
    rosunit.unitrun("sylph_sim", "fault_cases", FaultCasesTest)
