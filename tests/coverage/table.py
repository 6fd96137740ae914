"""Prints what the counters of a build say, read by gcov: lines and branches per folder, then the lines and branches of
each file that no test takes. Arguments: the build folder, then the source folders that count.

A branch is one outcome of a decision in the source. What the compiler adds is left out: both ways out of a call, of
which one is an exception; the code that clears up after an exception, where it never ran; lines of mere brackets.
(gcovr counts some of that, because it looks at lines, not at their blocks.)"""
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

line_start = re.compile(r"^ *([0-9]+|#####|=====|-)\*?: *([0-9]+):")
block_start = re.compile(r"^ *([0-9]+|%%%%%|\$\$\$\$\$)\*?: *([0-9]+)-block")


def count_of(text):
    return int(text) if text.isdigit() else 0


def read_text(text):
    """Lines of gcov --all-blocks --branch-counts: (file, line number, count, counts of the branches of its decisions)
    for each line of each function or instance of a template."""
    file, line, blocks = None, None, []

    def decisions():
        return [count for block in blocks if not block["call"] and not block["clears up"] and len(block["branches"]) > 1
                for count in block["branches"]]

    for row in text.splitlines():
        start, block = line_start.match(row), block_start.match(row)
        if start or row.startswith("-----"):
            if line:
                yield (file, *line, decisions())
            line, blocks = None, []
        if start and start[2] == "0":
            if ":Source:" in row:
                file = row.split(":Source:")[1]
        elif start and start[1] != "-":
            line = (int(start[2]), count_of(start[1]))
        elif block:
            blocks.append({"clears up": block[1] == "$$$$$", "call": False, "branches": []})
        elif blocks and row.startswith("call"):
            blocks[-1]["call"] = True
        elif blocks and row.startswith("branch"):
            taken = re.search(r"taken ([0-9]+)", row)
            blocks[-1]["branches"].append(int(taken[1]) if taken else 0)
    if line:
        yield (file, *line, decisions())


def read_counters(build, folders):
    """{file: {line: [count, {number of branches: counts}]}}, summed over all objects and instances of templates."""
    files = defaultdict(lambda: defaultdict(lambda: [0, {}]))
    objects = sorted(str(path) for folder in [*folders, "tests"] for path in (build / folder).rglob("*.gcno"))
    for i in range(0, len(objects), 20):
        run = subprocess.run(["gcov", "--all-blocks", "--branch-probabilities", "--branch-counts", "--stdout",
                              "--relative-only", "--source-prefix", str(Path.cwd()), *objects[i:i + 20]],
                             capture_output=True, text=True)
        if run.returncode:
            sys.exit("gcov failed; run tests/coverage/run once more from the start:\n" + run.stderr)
        for file, number, count, branches in read_text(run.stdout):
            if file.split("/")[0] not in folders:
                continue
            entry = files[file][number]
            entry[0] = max(entry[0], count)
            if branches:
                old = entry[1].get(len(branches), [0] * len(branches))
                entry[1][len(branches)] = [a + b for a, b in zip(old, branches)]
    return files


def spans(numbers):
    """1, 2, 3, 7 as "1-3, 7"."""
    parts = []
    for n in sorted(numbers):
        if parts and n == parts[-1][1] + 1:
            parts[-1][1] = n
        else:
            parts.append([n, n])
    return ", ".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


def share(taken, of):
    return f"{taken:6d} of {of:6d} {100 * taken / of if of else 100:6.1f} %"


build, folders = Path(sys.argv[1]), sys.argv[2:]
total = {folder: [0, 0, 0, 0] for folder in folders}
missed = []
for name, lines in sorted(read_counters(build, folders).items()):
    source = Path(name).read_text().splitlines()
    not_run, half = [], []
    counts = total[name.split("/")[0]]
    for number, (count, branches) in sorted(lines.items()):
        if not re.search(r"\w", source[number - 1]):
            continue
        counts[0] += count > 0
        counts[1] += 1
        if not count:
            not_run.append(number)
        for outcomes in branches.values():
            taken = sum(outcome > 0 for outcome in outcomes)
            counts[2] += taken
            counts[3] += len(outcomes)
            if count and taken < len(outcomes):
                half.append(number)
    if not_run or half:
        missed.append(f"{name}: " + "; ".join([f"lines {spans(not_run)}"] * bool(not_run) +
                                              [f"branches at {spans(set(half))}"] * bool(half)))

print(f"{'folder':12s} {'lines':>24s} {'branches':>25s}")
for name, (a, b, c, d) in total.items():
    print(f"{name:12s} {share(a, b)}  {share(c, d)}")
print("\nlines that did not run; branches of other lines that were not taken")
print("\n".join(missed))
