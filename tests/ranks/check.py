#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""tests/ranks/check.py MPIRUN PROGRAM CHECK [ARGUMENT...]: checks of processes that share a world.

hashes STEPS RANKS...   rank_program has the same hashes alone and on so many ranks, also where cuts move every step
gpu_hashes STEPS        the same on as many GPUs as there are, one a rank
faults RANKS            a rank that throws, has no memory or is killed ends all: soon, with a message and exit code
scene FILE RANKS        meniscus run has the same hash alone and on so many ranks"""

import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time

ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_mpi_yield_when_idle="1")
MOST_SECONDS = 30  # from a fault to the end of all processes


def command(mpirun, ranks, words):
    return words if ranks == 1 else [mpirun, "--oversubscribe", "--bind-to", "none", "-n", str(ranks), *words]


def run(mpirun, ranks, words, **options):
    return subprocess.run(command(mpirun, ranks, words), env=ENVIRONMENT, capture_output=True, text=True, **options)


def output_of(mpirun, ranks, words):
    done = run(mpirun, ranks, words)
    if done.returncode != 0:
        sys.exit(f"{words} on {ranks} ranks ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def check_hashes(mpirun, program, steps, *ranks, on=()):
    alone = output_of(mpirun, 1, [program, steps, *on])
    assert alone.count("\n") == int(steps) // 10 + 1, alone
    for count in map(int, ranks):
        for options in [], ["--move-cuts"]:
            shared = output_of(mpirun, count, [program, steps, *on, *options])
            assert shared == alone, f"{count} ranks {options}:\n{shared}\nalone:\n{alone}"


def check_gpu_hashes(mpirun, program, steps):
    gpus = len(glob.glob("/dev/nvidia[0-9]*"))
    if gpus < 2:
        sys.exit(77)
    check_hashes(mpirun, program, steps, *range(2, gpus + 1), on=["--cuda"])


def check_faults(mpirun, program, ranks):
    # Where memory ends before the ranks share a world, none of them can say more than that it ended.
    messages = {"throw": "rank 1 of {0} failed: the test has cut the line",
                "exhaust": "rank 1 of {0} failed: (.*memory|it ended early)", "kill": "rank 1 .*exited on signal 9"}
    for kind, message in messages.items():
        for call in 1, 2, 3, 7, 20, 45:
            start = time.monotonic()
            done = run(mpirun, int(ranks), [program, "100", "--at", "1", str(call), kind], timeout=MOST_SECONDS)
            case = f"{kind} at call {call}: {done.returncode} after {time.monotonic() - start:.1f} s\n{done.stderr}"
            assert done.returncode != 0, case
            assert re.search(message.format(ranks), done.stderr, re.S), case


def check_scene(mpirun, program, scene, ranks):
    hashes = []
    for count in 1, int(ranks):
        with tempfile.TemporaryDirectory() as folder:
            words = [program, "run", scene, "--threads", "1", "--json", "--export", "vtp", "--out", folder]
            hashes.append(json.loads(output_of(mpirun, count, words))["state_hash"])
            assert os.path.exists(os.path.join(folder, "summary.json"))
    assert hashes[0] == hashes[1], hashes


if __name__ == "__main__":
    mpirun, program, check, *arguments = sys.argv[1:]
    {"hashes": check_hashes, "gpu_hashes": check_gpu_hashes, "faults": check_faults, "scene": check_scene}[check](mpirun, program, *arguments)
