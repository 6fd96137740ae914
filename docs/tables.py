#!/usr/bin/env python3
"""The tables of docs/verification.md, from what `./run verification` leaves in a folder.

    docs/tables.py write report       each table that the folder has the results of; the others stay as they are
    docs/tables.py show report NAME   one table on the standard output
    docs/tables.py check              whether the page has every table, between marks that close, with rows as long as their heads

In the page a table stands between two comments, which no reader sees: <!--table NAME--> and <!--end NAME-->. Its last line says of
which program and day the results are.
"""

import datetime
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/verification.md"
BLOCK = re.compile(r"(<!--table ([a-z-]+)-->\n)(.*?)(<!--end \2-->)", re.DOTALL)
RADII = ("stick_radius_first_slip", "stick_radius_shakedown")
# What stands first in a table; the others follow as they come.
FIRST = (*RADII, "contact_radius_max", "normal_force_max", "indentation_max", "tangential_amplitude")
# A difference of what is prescribed is roundoff, and so is its bar.
ROUNDOFF = 1e-10
# As the program calls them: of {"normal_force_max", "largest normal force", ...
TITLES = dict(re.findall(r'\{"([a-z_]+)",\s*"([^"]+)"', (ROOT / "comparison/quantities/quantity.cc").read_text(encoding="utf-8")))


class Absent(Exception):
    """The folder has no results for a table."""


# Numbers and lines.

def short(value):
    """Two digits: 8.7e-5; – where there is none."""
    if value is None or not math.isfinite(value):
        return "–"
    if value == 0:
        return "0"
    digits, power = f"{value:.1e}".split("e")
    return f"{float(digits) * 10 ** int(power):.3g}" if -2 <= int(power) <= 1 else f"{digits}e{int(power)}"


def plain(tolerance):
    digits, power = f"{tolerance:.1e}".split("e")
    return f"{float(digits):g}e{int(power)}"


def percent(value):
    if value is None:
        return "–"
    return "0.0 %" if abs(value) < 5e-4 else f"{100 * value:+.1f} %"


def table(heads, rows):
    if not rows:
        raise Absent
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in (heads, ["---"] * len(heads), *rows))


def words(quantity):
    return TITLES.get(quantity, quantity.replace("_", " "))


def median(values):
    values = [v for v in values if v is not None and math.isfinite(v)]
    return statistics.median(values) if values else None


# What lies in the folder.

class Folder:
    def __init__(self, path):
        self.path = pathlib.Path(path)
        if not self.path.is_dir():
            sys.exit(f"{path}: no such folder; expected what ./run verification has written")
        self.results = {}
        self.read = []
        for file in sorted(self.path.rglob("result.json")):
            result = json.loads(file.read_text(encoding="utf-8"))
            parts = pathlib.PurePath(result["scene"].get("file", "")).parts
            self.results.setdefault(parts[-2] if len(parts) > 1 else "", []).append((file, result))

    def suite(self, name):
        file = self.path / f"{name}.json"
        if not file.exists():
            raise Absent
        self.read.append(file)
        return json.loads(file.read_text(encoding="utf-8"))

    def cases(self, name):
        """The results of the case files of cases/NAME."""
        found = self.results.get(name, [])
        if not found:
            raise Absent
        self.read += [file for file, _ in found]
        return [result for _, result in found]

    def origin(self):
        """Of which program and day the files are that were read since the last time."""
        versions = {json.loads(f.with_name("run.json").read_text(encoding="utf-8"))["versions"]["fretval"] for f in self.read if f.name == "result.json"}
        days = sorted({datetime.date.fromtimestamp(file.stat().st_mtime) for file in self.read})
        self.read = []
        when = " to ".join(f"{day.day} {day:%B %Y}" for day in ([days[0], days[-1]] if len(days) > 1 else days))
        return f"*fretval {', '.join(sorted(versions)) or version()} at commit {commit()}, {when}.*"


def version():
    return re.search(r"VERSION\s+([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8").split("project(")[1])[1]


def commit():
    """The last commit that changed more than the pages: that of the program."""
    try:
        asked = subprocess.run(["git", "log", "-1", "--format=%h", "--", ".", ":!docs", ":!*.md", ":!tests", ":!run"], cwd=ROOT, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return "unknown"
    return asked.stdout.strip() or "unknown"


# Suites of `fretval check`.

def exact(folder):
    by_solution = {}
    for row in folder.suite("exact"):
        by_solution.setdefault((row["solution"], row["refined"], row["resolutions"][0], row["resolutions"][-1]), []).append(row)
    rows = []
    for (solution, refined, first, last), group in by_solution.items():
        worst = max(abs(r["errors"][-1]) / r["tolerance"] for r in group)
        passed = sum(r["verdict"] == "pass" for r in group)
        rows.append([solution, f"{first} to {last} {refined}", errors_of(group), f"{worst:.2f}", f"{passed} of {len(group)}"])
    return table(["solution", "refined", "error at the finest (order: observed, expected)", "largest error over tolerance", "pass"], rows)


def errors_of(rows):
    """Of each quantity, or of many of them the largest error and the lowest order."""
    if len(rows) <= 3:
        return "; ".join(f"{row['quantity']} {short(abs(row['errors'][-1]))} ({order(row)})" for row in rows)
    worst = max(rows, key=lambda row: abs(row["errors"][-1]))
    lowest = min((row for row in rows if row["observed_order"] is not None), key=lambda row: row["observed_order"])
    return f"{len(rows)} quantities, at most {short(abs(worst['errors'][-1]))} ({worst['quantity']}); lowest order {order(lowest)}"


def order(row):
    expected = f"{row['expected_order']:g}" if row["expected_order"] else "exact"
    return f"{row['observed_order']:.1f}, {expected}" if row["observed_order"] is not None else f"floor, {expected}"


def quantities(suite):
    return table(
        ["quantity", "tolerance", "errors", "above bar", "bars above tolerance", "error: median, 90 %", "bar: median, 90 %", "bar over error, median"],
        [[words(q["quantity"]), plain(q["tolerance"]), q["errors"], q["above_bar"], q["wide"], f"{short(q['error']['median'])}, {short(q['error']['high'])}", f"{short(q['bar']['median'])}, {short(q['bar']['high'])}", short(q["effectivity"]["median"])] for q in suite["quantities"]])


def counted(suite):
    s = suite["summary"]
    return f"{s['cases']} cases: {s['agree']} agree, {s['refused']} refused as expected, {s['inconclusive']} inconclusive, {s['fail']} fail; {s['errors'] - s['above_bar']} of {s['errors']} errors are within their bars.\n\n"


def tolerance(folder):
    suite = folder.suite("tolerance")
    return counted(suite) + quantities(suite)


def extremes(folder):
    suite = folder.suite("extremes")
    return counted(suite) + quantities(suite)


def extreme_families(folder):
    families = {}
    for row in folder.suite("extremes")["rows"]:
        families.setdefault(row["family"], []).append(row)
    count = lambda rows, verdict: sum(row["verdict"] == verdict for row in rows)
    return table(
        ["family", "from … to", "cases", "agree", "refused", "inconclusive", "fail"],
        [[family, f"{rows[0]['name']} … {rows[-1]['name']}", len(rows), *(count(rows, v) for v in ("agrees", "refused", "inconclusive", "FAIL"))] for family, rows in families.items()])


def random(folder):
    suite = folder.suite("random")
    return counted(suite) + quantities(suite)


# Results of `fretval run`.

def bars(c):
    """Both bars together; None where there is none."""
    return None if c["error_bar"] is None else c["error_bar"] + (c["mdr_error"] or 0)


def size(c):
    return None if c["difference"] is None else abs(c["difference"])


def is_above(c):
    return bars(c) is not None and size(c) is not None and size(c) > bars(c) + ROUNDOFF


def compared(results):
    return [(quantity, c) for result in results for quantity, c in result["comparison"].items()]


def tally(comparisons):
    verdicts = [c["verdict"] for c in comparisons]
    return [len(verdicts), *(verdicts.count(v) for v in ("agree", "not resolved", "disagree")), sum(map(is_above, comparisons))]


def by_quantity(results):
    groups = {}
    for quantity, c in compared(results):
        groups.setdefault((not c["asked"], quantity), []).append(c)
    rows = []
    place = lambda key: (key[0], FIRST.index(key[1]) if key[1] in FIRST else len(FIRST))
    for (other, quantity), group in sorted(groups.items(), key=lambda item: place(item[0])):
        sizes = [size(c) for c in group if size(c) is not None]
        ratios = [bars(c) / size(c) for c in group if bars(c) and size(c)]
        rows.append([words(quantity) + (" *" if other else ""), *tally(group), short(median(sizes)), short(max(sizes, default=None)), short(median([bars(c) for c in group])), short(median(ratios))])
    return table(["quantity", "values", "agree", "not resolved", "disagree", "above both bars", "difference: median", "largest", "bar: median", "bar over difference, median"], rows)


def of_cases(name):
    return lambda folder: by_quantity(folder.cases(name))


def overview(folder):
    """Of all suites, or none: a part of them would take the rows of the others away."""
    rows = []
    for name, title in (("exact", "exact solutions"), ("tolerance", "tolerances"), ("extremes", "extremes"), ("random", "random cases")):
        suite = folder.suite(name)
        if name == "exact":
            passed = sum(row["verdict"] == "pass" for row in suite)
            rows.append([title, len(suite), len(suite), passed, 0, len(suite) - passed, "–"])
        else:
            s = suite["summary"]
            wide = sum(q["wide"] for q in suite["quantities"])
            rows.append([title, s["cases"], s["errors"], s["errors"] - wide - s["above_bar"], wide, s["above_bar"], s["above_bar"]])
    for name, title in (("motions", "motions"), ("paths", "paths"), ("forces", "prescribed forces"), ("layers", "layers"), ("wear", "wear")):
        results = folder.cases(name)
        for asked, what in ((True, "asked for"), (False, "others")):
            chosen = [c for _, c in compared(results) if c["asked"] == asked]
            if chosen:
                rows.append([f"{title}: {what}", len(results), *tally(chosen)])
    return table(["suite", "cases", "comparisons", "agree", "not resolved", "disagree", "above both bars"], rows)


# Layers: by how much the half-space is off.

def layers_half_space(folder):
    found = {}
    for result in folder.cases("layers"):
        values = {i["name"]: i["value"] for i in result["scene"]["inputs"]}
        half, layer = result.get("mdr_half_space"), result["mdr"]
        if not half or "Thickness" not in values or not result["name"].startswith("bonded"):
            continue
        found.setdefault(values.get("Poisson ratio", 0.5), {})[values["Thickness"]] = (layer["contact_radius_max"] / values["Thickness"], *(half[q] / layer[q] - 1 for q in (RADII[1], "normal_force_max")))
    if not found:
        raise Absent
    thicknesses = sorted({t for group in found.values() for t in group}, reverse=True)
    rows = []
    for poisson, group in sorted(found.items()):
        rows.append([f"{poisson:g}", *(f"{group[t][0]:.2f}: {percent(group[t][1])}, {percent(group[t][2])}" if t in group else "–" for t in thicknesses)])
    return table(["ν", *(f"H = {1e3 * t:g} mm" for t in thicknesses)], rows)


# Wear: one row a family.

def has_two_radii(result):
    first_slip, shakedown = (result["mdr"].get(radius) or 0 for radius in RADII)
    return abs(first_slip - shakedown) > 1e-6 * result["scene"]["contact_radius_unworn"]


def wear_courses(folder):
    families = {}
    for result in folder.cases("wear"):
        families.setdefault(result["name"].split("/")[0], []).append(result)
    rows = []
    for family, results in families.items():
        wears = [r["fe"]["wear"] for r in results if r["fe"].get("wear")]
        near = [(r["comparison"]["distance_to_limit"], r["fe"]["wear"]["distance_to_limit"]["first_slip"] if has_two_radii(r) else None) for r in results if "distance_to_limit" in r["comparison"]]
        volumes = [r["comparison"]["worn_volume"] for r in results if "worn_volume" in r["comparison"]]
        largest = lambda group: short(max((size(c) for c in group if size(c) is not None), default=None))
        rows.append([family, len(results), ", ".join(sorted({w["end"] for w in wears})), largest([c for c, _ in near]), short(max((bars(c) for c, _ in near if bars(c) is not None), default=None)),
                     short(min((first for _, first in near if first is not None), default=None)), largest(volumes), ", ".join(sorted({r["verdict"] for r in results}))])
    return table(["family", "cases", "end", "largest distance from the limit", "its bar", "smallest from that of first slip, where it is another", "volume: largest difference", "verdict"], rows)


# Profiles that MDR does not hold for: what its springs would say at rest.

def damaged(folder):
    rows = []
    for result in folder.cases("damaged"):
        rest = result["not_compared"]["at_rest"]
        zones = {name: len(result["fe"]["zones"].get(name) or []) for name in ("contact", "first_slip", "shakedown")}
        estimate = result["fe"]["error_estimate"]
        rows.append([result["name"], percent(rest["normal_force_difference"]), percent(rest["contact_radius_difference"]), *zones.values(),
                     *(short(estimate[q]["total"]) if q in estimate else "–" for q in ("contact_radius_max", "normal_force_max"))])
    return table(["case", "springs off at rest: normal force", "contact radius", "annuli in contact", "never slipped", "shaken down", "bar: contact radius", "normal force"], rows)


# Friction as a vector: by how much MDR is off.

def vector(folder):
    asked = (*RADII, "contact_radius_max", "normal_force_max")

    def off(result, quantity):
        truth, said, c = result["fe"].get(quantity), result["mdr"].get(quantity), result["comparison"].get(quantity)
        if not truth or said is None:
            return "–"
        scale = result["scene"]["contact_radius_unworn"] if "radius" in quantity else truth
        bar = None if c is None or bars(c) is None else 100 * bars(c) * scale * said / truth**2
        return f"{percent(said / truth - 1)} ± {short(bar)}"

    return table(["case", *map(words, RADII), "contact radius", "normal force"], [[r["name"], *(off(r, q) for q in asked)] for r in folder.cases("vector")])


# What a case costs in either way.

def trade(folder):
    files = sorted(folder.path.rglob("trade.json"))
    if not files:
        raise Absent
    folder.read.append(files[0])
    found = json.loads(files[0].read_text(encoding="utf-8"))
    rows = []
    for r in found["recommendations"]:
        best, chosen = (found["levels"][r[k]] if isinstance(r[k], int) else None for k in ("cheapest", "chosen"))
        rows.append([plain(r["tolerance"]), *(f"{short(level['error'])}, {short(level['seconds'])} s" if level else "–" for level in (best, chosen))])
    return table(["tolerance", "cheapest setting: error, time", "chosen by the tool: error, time"], rows)


TABLES = {
    "overview": overview, "exact": exact, "tolerance": tolerance, "extremes": extremes, "extreme-families": extreme_families, "layers": of_cases("layers"), "layers-half-space": layers_half_space,
    "vector": vector, "motions": of_cases("motions"), "paths": of_cases("paths"), "wear": of_cases("wear"), "wear-courses": wear_courses, "forces": of_cases("forces"), "damaged": damaged, "random": random, "trade": trade,
}


def filled(folder, name):
    """A table with its origin; None where the folder has no results for it."""
    folder.read = []
    try:
        return f"{TABLES[name](folder)}\n{folder.origin()}\n"
    except Absent:
        return None


def write(path):
    folder = Folder(path)
    before = PAGE.read_text(encoding="utf-8")

    def block(match):
        text = filled(folder, match[2])
        if text is None:
            print(f"{match[2]}: {path} has no results for it; the table stays as it is")
        return match[1] + (text or match[3]) + match[4]

    PAGE.write_text(BLOCK.sub(block, before), encoding="utf-8")


def show(path, name):
    if name not in TABLES:
        sys.exit(f"{name}: expected one of {', '.join(TABLES)}")
    print(filled(Folder(path), name) or f"{path} has no results for {name}")


def faults_of(page):
    """What is wrong with the marks and tables of a page."""
    faults = [f"{name}: {count} marks, expected one" for name in TABLES if (count := page.count(f"<!--table {name}-->")) != 1]
    blocks = list(BLOCK.finditer(page))
    faults += [f"{match[2]}: there is no such table" for match in blocks if match[2] not in TABLES]
    if len(blocks) != page.count("<!--table ") or len(blocks) != page.count("<!--end "):
        faults.append("a mark is not closed by the end of the same name")
    for match in blocks:
        lines = match[3].strip().splitlines()
        widths = {line.count("|") for line in lines if line.startswith("|")}
        if len(widths) != 1:
            faults.append(f"{match[2]}: rows with {sorted(widths)} bars, expected a table of one width")
        if not lines or not re.fullmatch(r"\*fretval .* at commit \w+, .*\.\*", lines[-1]):
            faults.append(f"{match[2]}: the last line does not say of which program and day it is")
    return faults


def check():
    faults = faults_of(PAGE.read_text(encoding="utf-8"))
    if faults:
        sys.exit("\n".join(f"docs/verification.md: {fault}" for fault in faults))


if __name__ == "__main__":
    verbs = {"write": (write, 1), "show": (show, 2), "check": (check, 0)}
    if len(sys.argv) < 2 or sys.argv[1] not in verbs or len(sys.argv) - 2 != verbs[sys.argv[1]][1]:
        sys.exit(__doc__.strip())
    verbs[sys.argv[1]][0](*sys.argv[2:])
