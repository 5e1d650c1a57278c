# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs ameco, measures what it takes, and keeps the results of each step in a folder."""

import hashlib
import json
import os
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

NO_OPENGL = 8  # exit code of ameco render


class ReproduceError(Exception):
    """Trouble that the user is told about in one line."""


def busy_seconds():
    """Processor time that all programs on the machine have taken so far (Linux)."""
    fields = [int(word) for word in Path("/proc/stat").read_text().split("\n")[0].split()[1:]]
    user, nice, system = fields[:3]
    return (user + nice + system) / os.sysconf("SC_CLK_TCK")


def machine():
    """What the times are of: "AMD EPYC, 2 cores, 24 GiB"."""
    about = Path("/proc/cpuinfo").read_text().split("\n")
    models = [line.split(":", 1)[1].strip() for line in about if line.startswith("model name")]
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 2**30
    return f"{(models or ['processor'])[0]}, {os.cpu_count()} cores, {memory:.0f} GiB"


class Runner:
    """One step's runs: they share a scratch folder, and all are measured."""

    def __init__(self, program: Path, scratch: Path, pictures: Path):
        self.program = program
        self.scratch = scratch
        self.pictures = pictures
        self.runs = []

    def ameco(self, *arguments, name=None):
        """Runs `ameco ARGUMENTS --json` in the scratch folder; returns what it printed."""
        code, out, error = self._measured([str(a) for a in arguments], name)
        if code != 0:
            raise ReproduceError(f"ameco {shlex.join(map(str, arguments))}: {error.strip()}")
        return json.loads(out)

    def render(self, picture, *arguments):
        """A picture by `ameco render`; False where there is no OpenGL."""
        words = ["render", *map(str, arguments), "-o", picture]
        code, _, error = self._measured(words, f"render {picture}")
        if code == NO_OPENGL:
            print(f"  {picture}: left out, no OpenGL here", file=sys.stderr)
            return False
        if code != 0:
            raise ReproduceError(f"ameco {shlex.join(words)}: {error.strip()}")
        if shutil.which("pngquant"):
            subprocess.run(
                ["pngquant", "--force", "--ext", ".png", "--speed", "1", "--nofs", "64",
                 self.scratch / picture], check=True)
        self.keep(self.scratch / picture)
        return True

    def keep(self, path, name=None):
        """Moves a picture out of the scratch folder; returns its name."""
        name = name or path.name
        shutil.move(path, self.pictures / name)
        return name

    def _measured(self, arguments, name):
        """Exit code, stdout, stderr; time and memory of the process go into `runs`."""
        out_path, error_path = self.scratch / "stdout", self.scratch / "stderr"
        busy, begin = busy_seconds(), time.monotonic()
        with open(out_path, "wb") as out, open(error_path, "wb") as error:
            process = subprocess.Popen(
                [self.program, *arguments, "--json", "--progress", "none"],
                cwd=self.scratch, stdin=subprocess.DEVNULL, stdout=out, stderr=error,
            )
            try:
                # Of this process alone; the resource module knows only the largest of all.
                _, status, usage = os.wait4(process.pid, 0)
            except KeyboardInterrupt:
                process.terminate()
                process.wait()
                raise
        process.returncode = os.waitstatus_to_exitcode(status)
        own = usage.ru_utime + usage.ru_stime
        self.runs.append({
            "name": name or arguments[0],
            "command": "ameco " + shlex.join(arguments),
            "wall_seconds": time.monotonic() - begin,
            "cpu_seconds": own,
            "others_cpu_seconds": max(0.0, busy_seconds() - busy - own),
            "peak_bytes": usage.ru_maxrss * 1024,
        })
        return process.returncode, out_path.read_text(), error_path.read_text()


def fingerprint(program: Path):
    """Changes when the program does."""
    return hashlib.sha256(program.read_bytes()).hexdigest()[:16]


class Results:
    """OUT/results/STEP.json: what each step found, made by which program with which sizes."""

    def __init__(self, folder: Path, program: Path, sizes: dict):
        self.folder = folder
        self.program = program
        self.sizes = sizes
        self.fingerprint = hashlib.sha256(program.read_bytes()).hexdigest()[:16]
        for name in ("results", "pictures"):
            (folder / name).mkdir(parents=True, exist_ok=True)

    def program_version(self):
        version = subprocess.run([self.program, "--version"], check=True, capture_output=True)
        return version.stdout.decode().strip()

    def load(self, step):
        """None where the step has not been made by this program with these sizes."""
        try:
            result = json.loads(self._path(step).read_text())
        except (FileNotFoundError, json.JSONDecodeError):
            return None
        pictures = [self.folder / "pictures" / name for name in result["pictures"]]
        is_there = result["key"] == self._key(step) and all(p.exists() for p in pictures)
        return result if is_there else None

    def make(self, step, function):
        """Makes a step: FUNCTION(runner, sizes) returns what it found and its pictures."""
        scratch = self.folder / "scratch" / step
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir(parents=True)
        runner = Runner(self.program, scratch.resolve(), (self.folder / "pictures").resolve())
        found, pictures = function(runner, self.sizes[step])
        result = {
            "key": self._key(step), "found": found, "pictures": pictures, "runs": runner.runs,
            "machine": machine(),
        }
        unfinished = self._path(step).with_suffix(".part")
        unfinished.write_text(json.dumps(result, indent=1) + "\n")
        unfinished.replace(self._path(step))
        shutil.rmtree(scratch)
        return result

    def _path(self, step):
        return self.folder / "results" / f"{step}.json"

    def _key(self, step):
        return {"program": self.fingerprint, "sizes": self.sizes[step]}
