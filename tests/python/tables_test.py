#!/usr/bin/env python3
"""The tables of docs/verification.md: what is there, and how they come about."""

import json
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs"))
import tables  # noqa: E402


def page_of(name, body):
    """The page with one table, and all the others as they have to be."""
    good = "| a | b |\n| --- | --- |\n| 1 | 2 |\n\n*fretval 0.1.0 at commit abc1234, 1 May 2026.*\n"
    return "".join(f"<!--table {n}-->\n{body if n == name else good}<!--end {n}-->\n" for n in tables.TABLES)


def comparison(difference, bar, verdict, asked=True):
    return {"difference": difference, "error_bar": bar, "mdr_error": 0, "verdict": verdict, "asked": asked}


class PageTest(unittest.TestCase):
    def test_the_page_has_every_table_in_order(self):
        self.assertEqual(tables.faults_of(tables.PAGE.read_text(encoding="utf-8")), [])

    def test_a_ragged_row_a_missing_origin_and_a_missing_table_are_told(self):
        origin = "\n*fretval 0.1.0 at commit abc1234, 1 May 2026.*\n"
        self.assertIn("one width", tables.faults_of(page_of("forces", "| a | b |\n| --- | --- |\n| 1 |\n" + origin))[0])
        self.assertIn("which program", tables.faults_of(page_of("forces", "| a |\n| --- |\n| 1 |\n"))[0])
        self.assertIn("forces: 0 marks", tables.faults_of(page_of("", "").replace("<!--table forces-->", ""))[0])

    def test_a_mark_that_does_not_close_is_told(self):
        self.assertIn("not closed", tables.faults_of(page_of("", "").replace("<!--end forces-->", ""))[-1])


class TableTest(unittest.TestCase):
    def folder_with(self, comparisons):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        case = pathlib.Path(scratch.name) / "one"
        case.mkdir()
        (case / "result.json").write_text(json.dumps({"name": "one", "scene": {"file": "cases/forces/one.prm"}, "comparison": comparisons}), encoding="utf-8")
        (case / "run.json").write_text(json.dumps({"versions": {"fretval": "9.9"}}), encoding="utf-8")
        return tables.Folder(scratch.name)

    def test_differences_above_both_bars_are_counted_whatever_the_verdict(self):
        folder = self.folder_with({"normal_force_max": comparison(-3e-4, 1e-4, "agree"), "bulk_work": comparison(1e-3, 4e-3, "not resolved", asked=False)})
        rows = tables.filled(folder, "forces").splitlines()
        self.assertEqual(rows[2], "| largest normal force | 1 | 1 | 0 | 0 | 1 | 3.0e-4 | 3.0e-4 | 1.0e-4 | 0.33 |")
        self.assertEqual(rows[3], "| energy lost in the body * | 1 | 0 | 1 | 0 | 0 | 1.0e-3 | 1.0e-3 | 4.0e-3 | 4 |")
        self.assertIn("fretval 9.9 at commit", rows[-1])

    def test_a_quantity_without_a_bar_has_no_number_for_it(self):
        folder = self.folder_with({"normal_force_max": comparison(None, None, None)})
        self.assertIn("| largest normal force | 1 | 0 | 0 | 0 | 0 | – | – | – | – |", tables.filled(folder, "forces"))

    def test_what_the_folder_has_no_results_of_is_left_alone(self):
        self.assertIsNone(tables.filled(self.folder_with({}), "wear"))


if __name__ == "__main__":
    unittest.main()
