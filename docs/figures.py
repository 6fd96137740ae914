#!/usr/bin/env python3
"""The figures that README.md and the pages of docs/ quote of `./run`: counts, largest differences, times.

    docs/figures.py write report      from the results of ./run into docs/figures.json and into the pages
    docs/figures.py check             whether pages and docs/figures.json agree, and the case files are as many
    docs/figures.py check report      also whether a run has found the same since; exit code 1 where one is stale

In a page a figure stands between comments that name it, which no reader sees: <!--=cases-->523<!--=-->.
"""

import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
FIGURES = ROOT / "docs/figures.json"
MARK = re.compile(r"<!--=([a-z0-9_]+)-->(.*?)<!--=-->", re.DOTALL)
RADII = ("stick_radius_first_slip", "stick_radius_shakedown")
# Processors differ: a time is stale beyond this factor.
TIMES = 3


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def results_in(folder):
    """Those of ./run, and how many seconds lie between the first and the last; the folder may have others."""
    families = [file.stem for file in case_files()]
    found, written = [], []
    for file in sorted(pathlib.Path(folder).rglob("result.json")):
        result = json.loads(file.read_text(encoding="utf-8"))
        if result["name"].split("/")[0] in families:
            found.append(result)
            written.append(file.stat().st_mtime)
    if not found:
        sys.exit(f"{folder}: no results of the cases of ./run; expected the folder that ./run has written")
    return found, max(written) - min(written)


def case_files():
    return [*sorted((ROOT / "cases/figure3").glob("*.prm")), *sorted((ROOT / "cases/figure4").glob("*.prm")), ROOT / "cases/wear/wear-to-the-limit.prm"]


def cases_of(file):
    """How many cases a file is: the values of its sweep."""
    values = re.search(r"^\s*set Values\s*=\s*([^#\n]*)", file.read_text(encoding="utf-8"), re.MULTILINE)
    if not values:
        return 1
    if ":" not in values[1]:
        return len(values[1].split(","))
    first, step, last = (float(re.match(r"\s*([-+.\deE]+)", part)[1]) for part in values[1].split(":"))
    return int((last - first) / step + 1e-9) + 1


def short(value):
    """Two digits: 8.7e-5."""
    digits, power = f"{value:.1e}".split("e")
    return f"{digits}e{int(power)}"


def largest(results, quantity, chosen):
    sizes = [abs(r["comparison"][quantity]["difference"]) for r in results if chosen(r["name"]) and r["comparison"].get(quantity, {}).get("difference") is not None]
    return short(max(sizes))


def computed(results, seconds):
    papers = [r for r in results if r["name"].startswith("figure")]
    compared = [c for r in papers for c in r["comparison"].values()]
    asked = [c for c in compared if c["asked"]]
    others = [c for c in compared if not c["asked"]]
    solid = lambda name: name.startswith("figure3") and "kelvin" not in name
    kelvin = lambda name: name.startswith("figure3") and "kelvin" in name
    limits = lambda name: name.startswith("figure4")
    figures = {
        "cases": len(results),
        "paper_cases": len(papers),
        "asked": len(asked),
        "asked_agree": sum(c["verdict"] == "agree" for c in asked),
        "others": len(others),
        "others_open": sum(c["verdict"] == "not resolved" for c in others),
        "disagree": sum(c["verdict"] == "disagree" for c in compared),
        "compared": len(compared),
        "above_bar": sum(c["error_bar"] is not None and c["difference"] is not None and abs(c["difference"]) > c["error_bar"] + c["mdr_error"] for c in compared),
        "parabola_largest": short(max(float(largest(papers, radius, lambda name: name.startswith("figure3-parabola"))) for radius in RADII)),
        "minutes": max(2, round(seconds / 60)),
    }
    for quantity in (*RADII, "contact_radius_max", "normal_force_max"):
        figures["figure3_" + quantity] = largest(papers, quantity, solid)
        figures["figure3_" + quantity + "_kelvin"] = largest(papers, quantity, kelvin)
    for quantity in ("slip_inside_stick_zone", "force_outside_stick_zone"):
        figures["figure4_" + quantity] = largest(papers, quantity, limits)
    figures["figure4_stick_radius"] = short(max(float(largest(papers, radius, limits)) for radius in RADII))
    return figures


def shown(value):
    return f"{value:,}" if isinstance(value, int) else str(value)


def stale_pages(figures):
    stale = []
    for page in pages():
        for name, text in MARK.findall(page.read_text(encoding="utf-8")):
            if name not in figures:
                stale.append(f"{page.relative_to(ROOT)}: there is no figure {name}")
            elif text != shown(figures[name]):
                stale.append(f"{page.relative_to(ROOT)}: {name} is {shown(figures[name])}, the page says {text}")
    return stale


def write(folder):
    figures = computed(*results_in(folder))
    FIGURES.write_text(json.dumps(figures, indent=2) + "\n", encoding="utf-8")
    for page in pages():
        text = page.read_text(encoding="utf-8")
        filled = MARK.sub(lambda m: f"<!--={m[1]}-->{shown(figures.get(m[1], m[2]))}<!--=-->", text)
        if filled != text:
            page.write_text(filled, encoding="utf-8")


def has_changed(name, before, now):
    if name == "minutes":
        return not 1 / TIMES <= now / before <= TIMES
    return before != now


def check(folder=None):
    figures = json.loads(FIGURES.read_text(encoding="utf-8"))
    stale = stale_pages(figures)
    n_cases = sum(cases_of(file) for file in case_files())
    if n_cases != figures["cases"]:
        stale.append(f"docs/figures.json: {figures['cases']} cases, ./run has {n_cases}")
    if folder:
        now = computed(*results_in(folder))
        stale += [f"docs/figures.json: {name} was {figures.get(name)}, {folder} has {value}" for name, value in now.items() if name not in figures or has_changed(name, figures[name], value)]
    if stale:
        sys.exit("\n".join([*stale, "stale: docs/figures.py write report, after ./run"]))


if __name__ == "__main__":
    verbs = {"write": write, "check": check}
    if len(sys.argv) < 2 or sys.argv[1] not in verbs or (sys.argv[1] == "write" and len(sys.argv) != 3) or len(sys.argv) > 3:
        sys.exit(__doc__.strip())
    verbs[sys.argv[1]](*sys.argv[2:])
