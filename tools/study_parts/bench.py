"""Runs the roomseg command line: maps are changed, simulated, segmented and scored by it."""
import concurrent.futures
import itertools
import json
import os
import subprocess
import sys

FIRST_SEED = 5000  # homes below are for development


class Failure(Exception):
    """Has a message for the user."""


def call(*command):
    run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if run.returncode != 0:
        causes = [line for line in run.stderr.splitlines() if line.startswith("roomseg: ")]
        raise Failure("%s: exit code %d: %s" % (" ".join(command), run.returncode,
                                                "; ".join(causes) or "no message"))
    return run.stdout


class Bench:
    """One data set, and what is made of it in a folder of its own."""

    def __init__(self, roomseg, dataset, folder, jobs, seed_count):
        self.roomseg = roomseg
        self.dataset = dataset
        self.folder = folder
        self.jobs = jobs
        self.seed_count = seed_count
        first = json.loads(call(roomseg, "bench", dataset, "--reps", "1", "--json"))
        self.config = first["config"]
        self.sets = [s["name"] for s in first["sets"] if any("scores" in m for m in s["maps"])]
        if not self.sets:
            raise Failure("%s: no map has a truth" % dataset)

    def in_parallel(self, title, function, tasks):
        """[function(*task) for task in tasks]; shows how far it is."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            futures = [pool.submit(function, *task) for task in tasks]
            try:
                for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
                    future.result()
                    self.show(title, done, len(tasks))
            except BaseException:
                for future in futures:
                    future.cancel()
                raise
        return [future.result() for future in futures]

    @staticmethod
    def show(title, done, total):
        """Overwrites its line on a terminal, else writes a line for each tenth."""
        terminal = sys.stderr.isatty()
        if terminal or done == total or done * 10 // total > (done - 1) * 10 // total:
            end = "\n" if done == total or not terminal else ""
            print("%s%s: %d of %d" % ("\r" if terminal else "", title, done, total), end=end,
                  file=sys.stderr, flush=True)

    def scores(self, folder, config=None):
        """Scores of the maps of a folder with one set: a list of dictionaries as `roomseg
        bench --json` prints them, with the map's name among them."""
        fields = [("--config", "%s=%d" % item) for item in (config or {}).items()]
        text = call(self.roomseg, "bench", folder, "--reps", "1", "--json",
                    *itertools.chain(*fields))
        maps = json.loads(text)["sets"][0]["maps"]
        return [dict(m["scores"], name=m["name"]) for m in maps if "scores" in m]

    def changed(self, set_name, options=()):
        """A copy of a set, changed by `roomseg vary`. Without options it is only cut to what
        is known, which changes no score, but is read faster."""
        folder = os.path.join(self.folder, "-".join((set_name, *options)))
        if not os.path.isdir(folder):
            call(self.roomseg, "vary", self.dataset, "--set", set_name, *options, "-o", folder)
        return folder

    def simulated(self, size, furniture):
        """Homes of one size, a folder a seed; furniture: --furnished or --empty."""
        folder = os.path.join(self.folder, size + furniture)
        if not os.path.isdir(folder):
            tasks = [("simulate", "--seed", str(seed), "--size", size, furniture, "-o",
                      os.path.join(folder, str(seed)))
                     for seed in range(FIRST_SEED, FIRST_SEED + self.seed_count)]
            self.in_parallel("simulating: %s, %s" % (size, furniture[2:]),
                             lambda *words: call(self.roomseg, *words), tasks)
        return folder

    def seed_range(self):
        return "%d to %d" % (FIRST_SEED, FIRST_SEED + self.seed_count - 1)
