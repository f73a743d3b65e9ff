# SPDX-License-Identifier: GPL-3.0-or-later
"""Many files: each is a task of one of several pvpython processes, and one that fails, or ends its process, costs itself only.

Needs no ParaView in this process.
"""
import json
import os
import queue
import signal
import subprocess
import sys
import threading

import contouroptions
from contoursummary import count, table, write_files

HERE = os.path.dirname(os.path.abspath(__file__))
STOPPED = 130  # what a shell says of a program that Ctrl-C has ended


def pvpython():
    # Neither a display nor a server of ranks, whose daemon takes longer to start than a small surface.
    return [os.environ.get("CONTOUR_PVPYTHON", "pvpython"), "--force-offscreen-rendering", "--no-mpi"]


def worker_command():
    return pvpython() + [os.path.join(HERE, "contourworker.py"), "--tasks"]


def failed(task, sentence):
    return {"File": task["Input"], "Status": "failed", "Error": sentence, "Regions": [], "Notes": []}


def _ending(code):
    """How a process ended, in words."""
    if code >= 0:
        return f"with exit code {code}"
    try:
        return f"by the signal {signal.Signals(-code).name}"
    except ValueError:
        return f"by signal {-code}"


class Worker(threading.Thread):
    """Gives tasks to a process, one after the other; where it ends in the middle of one, the next has a new process."""

    def __init__(self, tasks, outcomes, command):
        super().__init__(daemon=True)
        self.tasks = tasks
        self.outcomes = outcomes
        self.command = command
        self.process = None
        self.stopping = False

    def run(self):
        while not self.stopping:
            try:
                task = self.tasks.get_nowait()
            except queue.Empty:
                break
            self.outcomes.put((task["Number"], self._done(task)))
        self.stop()

    def _done(self, task):
        try:
            if self.process is None or self.process.poll() is not None:
                # A session of its own: Ctrl-C is for the process that the user sees, which ends the others.
                self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
                                                encoding="utf-8", start_new_session=True)
            self.process.stdin.write(json.dumps(task) + "\n")
            self.process.stdin.flush()
            answer = self.process.stdout.readline()
        except OSError as error:
            answer, why = "", f"the process for it cannot be used: {error.strerror or error}"
        else:
            why = None
        if answer.endswith("\n"):
            return json.loads(answer)
        if why is None:
            why = f"the process that worked on it ended {_ending(self.process.wait())}, without a word of its own"
        return failed(task, f"{task['Input']}: {why}.")

    def stop(self):
        self.stopping = True
        if self.process is None:
            return
        if self.process.poll() is None and self.is_alive() and threading.current_thread() is not self:
            self.process.terminate()
        elif self.process.stdin:
            self.process.stdin.close()


class Cohort:
    """The tasks of a call, and what became of them, in the order of the files."""

    def __init__(self, options, arguments, command=None):
        # A setting for pvpython comes first, so that one of the user's, behind it, counts.
        self.jobs = min(len(options.inputs), options.jobs or os.cpu_count() or 1)
        self.options = options
        threads = [] if self.jobs == 1 else ["--set", f"Threads={max(1, (os.cpu_count() or 1) // self.jobs)}"]
        self.tasks = [{"Number": number, "Input": path, "Output": output, "Arguments": threads + arguments}
                      for number, (path, output) in enumerate(zip(options.inputs, contouroptions.outputs(options)))]
        self.outcomes = [{"File": path, "Status": "not tried", "Error": None, "Regions": [], "Notes": []}
                         for path in options.inputs]
        self.command = command or worker_command()
        self.interrupted = False
        self.written = {}

    def run(self):
        tasks, outcomes = queue.Queue(), queue.Queue()
        for task in self.tasks:
            tasks.put(task)
        workers = [Worker(tasks, outcomes, self.command) for _ in range(self.jobs)]
        for worker in workers:
            worker.start()
        try:
            for finished in range(1, len(self.tasks) + 1):
                number, outcome = outcomes.get()
                self._take(number, outcome, finished)
                if outcome.get("SettingIsWrong"):
                    raise contouroptions.UsageError(outcome["Error"])  # as wrong for all others
        except KeyboardInterrupt:
            self.interrupted = True
        finally:
            for worker in workers:
                worker.stop()
        return self.outcomes

    def _take(self, number, outcome, finished):
        for region in outcome["Regions"]:
            first = self.written.setdefault(region.get("Output"), outcome["File"])
            if region.get("Output") and first != outcome["File"]:
                outcome["Status"] = "failed"
                outcome["Error"] = (f"{outcome['File']}: {region['Output']} is what {first} is written to as well; "
                                    "write one of them to another folder.")
        self.outcomes[number] = outcome
        regions = sum(region["Status"] == "done" for region in outcome["Regions"])
        seconds = sum(region.get("Seconds", 0) for region in outcome["Regions"])
        what = "FAILED" if outcome["Status"] == "failed" else f"{regions} region{'' if regions == 1 else 's'}, {seconds:.2f} s"
        print(f"[{finished}/{len(self.tasks)}] {outcome['File']}: {what}", file=sys.stderr, flush=True)

    def tell(self):
        """The table, the files that are asked for, and at the end what failed. Returns the exit code."""
        outcomes = self.outcomes
        print(table(outcomes))
        notes = sum(len(outcome["Notes"]) for outcome in outcomes)
        if notes:
            print(f"\n{notes} notes on files" + (", in the summary." if self.options.summary else ":"))
            if not self.options.summary:
                for outcome in outcomes:
                    print("".join(f"  {outcome['File']}: {line}\n" for line in outcome["Notes"]), end="")
        print(f"\n{count(outcomes, 'done')} of {len(outcomes)} files done, {count(outcomes, 'nothing')} with nothing to do, "
              f"{count(outcomes, 'failed')} failed, {count(outcomes, 'not tried')} not tried.")
        write_files(self.options, outcomes, by_file=True)
        sys.stdout.flush()
        for outcome in outcomes:
            if outcome["Status"] == "failed":
                print(f"contour-reconstruct: {outcome['Error']}", file=sys.stderr)
        if self.interrupted:
            print("contour-reconstruct: stopped.", file=sys.stderr)
            return STOPPED
        return 1 if count(outcomes, "failed") else 0
