"""Prints what gcovr's JSON says: lines and branches per folder, then the lines and branches of each file that no test takes."""
import json
import sys
from collections import defaultdict


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


folders = defaultdict(lambda: [0, 0, 0, 0])
missed = []
for file in json.load(open(sys.argv[1]))["files"]:
    lines = [line for line in file["lines"] if not line.get("gcovr/noncode")]
    branches = [(line["line_number"], b["count"] > 0) for line in lines for b in line["branches"]]
    ran = {line["line_number"]: line["count"] > 0 for line in lines}
    counts = folders[file["file"].split("/")[0]]
    for i, n in enumerate([sum(ran.values()), len(ran), sum(taken for _, taken in branches), len(branches)]):
        counts[i] += n
    not_run = [n for n, count in ran.items() if not count]
    # Branches of lines that never ran are missing with their line.
    half = defaultdict(int)
    for number, taken in branches:
        if not taken and ran[number]:
            half[number] += 1
    if not_run or half:
        missed.append((file["file"], not_run, half))

print(f"{'folder':12s} {'lines':>24s} {'branches':>25s}")
for name, (a, b, c, d) in sorted(folders.items()):
    print(f"{name:12s} {share(a, b)}  {share(c, d)}")
print("\nlines that did not run; branches of other lines that were not taken")
for name, not_run, half in sorted(missed):
    print(f"{name}: {'lines ' + spans(not_run) + '; ' if not_run else ''}{'branches at ' + spans(half) if half else ''}".rstrip("; "))
