"""What ./test all and tests/mutants/run keep, and what they read off outputs: python3 tests/python/all_test.py."""

import collections
import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tests/all"))
from kept import Kept, key_of  # noqa: E402


def module_of(file):
    """A script without an ending."""
    loader = importlib.machinery.SourceFileLoader(file.parent.name, str(file))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    sys.modules[loader.name] = module  # where dataclasses look for their own
    loader.exec_module(module)
    return module


stages = module_of(ROOT / "tests/all/run")
mutants = module_of(ROOT / "tests/mutants/run")


class Results(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_are_kept_by_their_key(self):
        Kept(self.folder / "a/results.json").put("clang", "1", result="passed")
        again = Kept(self.folder / "a/results.json")
        self.assertEqual(again.get("clang", "1")["result"], "passed")
        self.assertIsNone(again.get("clang", "2"))
        self.assertIsNone(again.get("gcc", "1"))

    def test_of_a_damaged_file_are_none(self):
        (self.folder / "results.json").write_text('{"clang": {"ke')
        self.assertEqual(Kept(self.folder / "results.json").all, {})

    def test_depend_on_the_sources_that_are_wanted(self):
        subprocess.run(["git", "init", "-q", self.folder], check=True)
        key = lambda: key_of(self.folder, lambda name: not name.endswith(".md"))  # noqa: E731
        (self.folder / "a.cc").write_text("1")
        first = key()
        (self.folder / "b.md").write_text("words")
        self.assertEqual(key(), first)
        (self.folder / "a.cc").write_text("2")
        self.assertNotEqual(key(), first)
        (self.folder / "a.cc").write_text("1")
        self.assertEqual(key(), first)
        (self.folder / "a.cc").rename(self.folder / "c.cc")
        self.assertNotEqual(key(), first)


class Stages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        stages.folder = pathlib.Path(folder.name)
        self.kept = Kept(stages.folder / "results.json")

    def run_of(self, *commands, **others):
        return stages.run_stage(stages.Stage("one", [list(command) for command in commands], **others), self.kept, "k", "c")

    def test_end_at_the_first_command_that_fails(self):
        result = self.run_of(["true"], ["false"], ["touch", str(stages.folder / "made")])
        self.assertEqual(result["result"], "FAILED")
        self.assertFalse((stages.folder / "made").exists())
        self.assertEqual(self.run_of(["true"], ["true"])["result"], "passed")

    def test_need_their_program(self):
        self.assertEqual(self.run_of(["true"], needs="no-such-program")["result"], "not run: no no-such-program")

    def test_have_the_figures_of_their_output(self):
        result = self.run_of(["echo", "100% tests passed, 0 tests failed out of 9"])
        self.assertEqual(result["figures"], "9 of 9 test programs pass")

    def test_say_what_is_of_other_sources(self):
        self.run_of(["true"])
        stage = stages.Stage("one", [])
        self.assertNotIn("other sources", stages.table([stage], self.kept, "k"))
        self.assertIn("other sources", stages.table([stage], self.kept, "l"))
        self.assertIn("not run", stages.table([stages.Stage("two", [])], self.kept, "k"))


class Samples(unittest.TestCase):
    def setUp(self):
        sizes = {"comparison": 60, "fem": 25, "mdr": 10, "meshes": 5}
        self.all = [mutants.Mutant(f"{folder}-{k}", f"{folder}/a.cc", "x", "y") for folder, n in sizes.items()
                    for k in range(n)]

    def names(self, n, seed, of=None):
        return [mutant.name for mutant in mutants.sample_of(of or self.all, n, seed)]

    def test_give_each_folder_its_share(self):
        folders = lambda n: dict(collections.Counter(name.split("-")[0] for name in self.names(n, 1)))  # noqa: E731
        self.assertEqual(folders(20), {"comparison": 12, "fem": 5, "mdr": 2, "meshes": 1})
        self.assertEqual(folders(11), {"comparison": 7, "fem": 3, "mdr": 1})  # of 6.6, 2.75, 1.1 and 0.55

    def test_have_no_mutant_twice_and_no_more_than_there_are(self):
        for n in (40, 1000):
            names = self.names(n, 1)
            self.assertEqual(len(names), min(n, 100))
            self.assertEqual(len(set(names)), len(names))

    def test_depend_on_the_seed_and_not_on_the_order_of_the_list(self):
        self.assertEqual(self.names(20, 1), self.names(20, 1, of=self.all[::-1]))
        self.assertNotEqual(self.names(20, 1), self.names(20, 2))

    def test_have_the_interval_of_their_share(self):
        """Its ends p are where the score test rejects, |k/n - p| = z sqrt(p (1 - p) / n); z of 95 % is 1.96."""
        for k, n in ((8, 10), (0, 7), (7, 7), (97, 100)):
            low, high = mutants.wilson(k, n)
            for p in (low, high):
                self.assertAlmostEqual(abs(k / n - p), 1.959964 * (p * (1 - p) / n)**0.5, places=12)
            self.assertLessEqual(low, k / n + 1e-12)
            self.assertGreaterEqual(high, k / n - 1e-12)
            self.assertGreater(high - low, 0.05)


class Figures(unittest.TestCase):
    def test_of_ctest(self):
        self.assertEqual(stages.test_figures("90% tests passed, 1 tests failed out of 10\n"), "9 of 10 test programs pass")
        self.assertEqual(stages.test_figures("killed"), "")

    def test_of_a_fuzz_target(self):
        text = "#8192 pulse  cov: 2501 ft: 9\nstat::number_of_executed_units: 1234567\ncsv: 600 s of processor time\n"
        self.assertEqual(stages.fuzz_figures(text), "1,234,567 inputs in 600 s of processor time, 2501 edges")

    def test_of_coverage(self):
        text = "folder\nmdr            2900 of   2950   98.3 %    1500 of   1600   93.8 %\n"
        self.assertEqual(stages.coverage_figures(text), "mdr 98.3 / 93.8 %")

    def test_of_mutants(self):
        text = ("folder       mutants  noticed   share  survivors\nfem              119      110     92%  a, b\n"
                "mdr               50       50    100%  \n")
        self.assertEqual(stages.mutant_figures(text), "fem 110 of 119, mdr 50 of 50")


if __name__ == "__main__":
    unittest.main()
