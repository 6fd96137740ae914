"""Results of long runs that are kept in build/, each with a key of what it depends on: a second call goes on where the
first one was interrupted, and what has changed is done anew."""
import hashlib
import json
import os
import subprocess


def files_of(root):
    """What git knows or would add, and is there."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=root, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    return sorted(name for name in set(listed) if name and (root / name).is_file())


def key_of(root, wanted):
    """Of the names and contents of the files for which wanted(name) holds."""
    hashed = hashlib.sha256()
    for name in files_of(root):
        if wanted(name):
            content = (root / name).read_bytes()
            hashed.update(f"{name}\0{len(content)}\0".encode() + content)
    return hashed.hexdigest()[:16]


class Kept:
    """A JSON file of results by their names. What is put there is on disk at once."""

    def __init__(self, file):
        self.file = file
        try:
            self.all = json.loads(file.read_text(encoding="utf-8"))
        except (FileNotFoundError, json.JSONDecodeError):
            self.all = {}

    def get(self, name, key):
        """The result, or None if there is none under this key."""
        found = self.all.get(name)
        return found if found and found["key"] == key else None

    def put(self, name, key, **values):
        self.all[name] = {"key": key, **values}
        self.file.parent.mkdir(parents=True, exist_ok=True)
        partial = self.file.with_suffix(".partial")
        partial.write_text(json.dumps(self.all, indent=1), encoding="utf-8")
        os.replace(partial, self.file)
        return self.all[name]
