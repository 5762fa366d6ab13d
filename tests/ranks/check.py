#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""tests/ranks/check.py MPIRUN PROGRAM CHECK [ARGUMENT...]: checks of processes that share a world.

hashes STEPS RANKS... [--cuts pencils]   rank_program has the same hashes alone and on so many ranks, also where cuts
                        move every step
contents STEPS RANKS... [--cuts pencils] emitters, sinks, probes and bodies do and say the same, bit for bit; with slabs
                        also the pressure grid
gpu_hashes STEPS        the hashes are the same on as many GPUs as there are, one a rank
faults RANKS            a rank that throws, has no memory or is killed ends all: soon, with a message and exit code
hang RANKS [LIMIT]      so does a rank that stops, within 30 s, or here soon after a limit in s
memory BYTES WIDTH LENGTH RANKS... [OPTION...]   no rank needs more bytes for each of its particles, in a dam of that size
particles STEPS RANKS   each particle is still there, and once
momentum RANKS [--bodies]   free drops that meet keep it, also where they meet on a body
scene FILE RANKS [OPTION...]   meniscus run has the same hash alone and on so many ranks
restart FILE            so it has if it goes on from snapshots, on other numbers of ranks; a damaged one is refused"""

import glob
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import time

UNSEEN_BY_TSAN = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../sanitizers/unseen.txt")
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_mpi_yield_when_idle="1",
                   # Of sanitizers: Open MPI 4.1 leaks, and takes two of its own locks in either order.
                   LSAN_OPTIONS="detect_leaks=0",
                   TSAN_OPTIONS=f"detect_deadlocks=0:suppressions={UNSEEN_BY_TSAN}")
MOST_SECONDS = 30  # from a fault to the end of all processes
MOST_MOMENTUM = 1e-6  # of what both drops would have in one direction


def command(mpirun, ranks, words):
    return words if ranks == 1 else [mpirun, "--oversubscribe", "--bind-to", "none", "-n", str(ranks), *words]


def run(mpirun, ranks, words, environment=ENVIRONMENT, **options):
    return subprocess.run(command(mpirun, ranks, words), env=environment, capture_output=True, text=True, **options)


def output_of(mpirun, ranks, words):
    done = run(mpirun, ranks, words)
    if done.returncode != 0:
        sys.exit(f"{words} on {ranks} ranks ended with {done.returncode}:\n{done.stdout}{done.stderr}")
    return done.stdout


def ranks_and_options(arguments):
    """Numbers of ranks, and behind them words for the program."""
    first = next((k for k, word in enumerate(arguments) if word.startswith("--")), len(arguments))
    return list(map(int, arguments[:first])), list(arguments[first:])


def expect_the_same(mpirun, words, alone, ranks, options):
    for count in ranks:
        for moves in [], ["--move-cuts"]:
            shared = output_of(mpirun, count, [*words, *options, *moves])
            assert shared == alone, f"{count} ranks {options} {moves}:\n{shared}\nalone:\n{alone}"


def check_hashes(mpirun, program, steps, *arguments):
    ranks, options = ranks_and_options(arguments)
    words = [program, steps, "--size", "0.15", "1.3"]
    alone = output_of(mpirun, 1, [*words, *options])
    assert alone.count("\n") == int(steps) // 10 + 1, alone
    expect_the_same(mpirun, words, alone, ranks, options)


def check_contents(mpirun, program, steps, *arguments):
    ranks, options = ranks_and_options(arguments)
    words = [program, steps, "--size", "0.15", "1.3", "--flow", "--bodies"]
    words += [] if "pencils" in options else ["--grid"]
    alone = output_of(mpirun, 1, words)
    emitted, taken = re.findall(r"emitted (\d+)", alone)[-2:], re.findall(r"taken (\d+)", alone)[-2:]
    assert min(map(int, emitted + taken)) > 0, alone
    expect_the_same(mpirun, words, alone, ranks, options)


def check_gpu_hashes(mpirun, program, steps):
    gpus = len(glob.glob("/dev/nvidia[0-9]*"))
    if gpus < 2:
        sys.exit(77)
    check_hashes(mpirun, program, steps, *map(str, range(2, gpus + 1)), "--cuda")


def expect_end(mpirun, ranks, words, message, environment=ENVIRONMENT):
    """All processes end soon, with this message and an exit code. Returns the seconds that it took."""
    start = time.monotonic()
    done = run(mpirun, int(ranks), words, environment, timeout=MOST_SECONDS)
    seconds = time.monotonic() - start
    case = f"{words}: {done.returncode} after {seconds:.1f} s\n{done.stderr}"
    assert done.returncode != 0, case
    assert re.search(message.format(ranks), done.stderr, re.S), case
    return seconds


def check_faults(mpirun, program, ranks):
    messages = {"throw": "rank 1 of {0} failed: the test has cut the line",
                "exhaust": "rank 1 of {0} failed: .*memory", "kill": "rank 1 .*exited on signal 9"}
    for kind, message in messages.items():
        for call in 1, 2, 3, 7, 20, 45:
            expect_end(mpirun, ranks, [program, "100", "--at", "1", str(call), kind], message)
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "world.menisnap")
            expect_end(mpirun, ranks, [program, "1", "--save", file, "--at", "1", "write", kind], message)
            assert not os.path.exists(file), f"{kind} while a file is written leaves half of it"


def check_hang(mpirun, program, ranks, limit=None):
    environment = dict(ENVIRONMENT, MENISCUS_RANK_LIMIT=limit) if limit else ENVIRONMENT
    for rank in "1", "0":
        words = [program, "100000", "--at", rank, "60", "stop"]
        expect_end(mpirun, ranks, words, f"failed: rank {rank} did not arrive", environment)


def check_memory(mpirun, program, most, width, length, *arguments):
    ranks, options = ranks_and_options(arguments)
    for count in ranks:
        output = output_of(mpirun, count, [program, "1", "--size", width, length, "--plain", "--memory", *options])
        found = re.findall(r"memory ([\d.]+) bytes of each of (\d+) particles", output)
        print(f"{count} ranks:", ", ".join(f"{bytes} B of each of {particles}" for bytes, particles in found))
        assert len(found) == count and sum(int(particles) for _, particles in found) > 0, output
        assert max(float(bytes) for bytes, _ in found) <= float(most), output


def chunks_of(file):
    """The chunks of a snapshot by name, each with its offset."""
    with open(file, "rb") as stream:
        magic, _, header_bytes, _ = struct.unpack("<8sIIQ", stream.read(24))
        assert magic == b"MENISNAP", magic
        header = json.loads(stream.read(header_bytes))
    chunks, offset = {}, 24 + header_bytes
    for chunk in header["chunks"]:
        chunks[chunk["name"]] = dict(chunk, offset=offset)
        offset += chunk["count"] * chunk["element_bytes"]
    return chunks


def check_particles(mpirun, program, steps, ranks):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "world.menisnap")
        output = output_of(mpirun, int(ranks), [program, steps, "--size", "0.15", "1.3", "--save", file])
        count = int(re.search(r"particles (\d+)", output)[1])
        chunk = chunks_of(file)["engine/solver/particles/number"]
        assert len(chunk["parts"]) == int(ranks), chunk
        with open(file, "rb") as stream:
            stream.seek(chunk["offset"])
            numbers = struct.unpack(f"<{chunk['count']}I", stream.read(4 * chunk["count"]))
        assert sorted(numbers) == list(range(count)), f"{len(numbers)} of {count} particles, or some twice"


def check_momentum(mpirun, program, ranks, *bodies):
    outputs = [output_of(mpirun, count, [program, "200", "--drop", *bodies]) for count in (1, int(ranks))]
    assert outputs[0] == outputs[1], outputs
    error = float(re.search(r"momentum (\S+)", outputs[1])[1])
    print("relative error of momentum:", error)
    assert error <= MOST_MOMENTUM, outputs[1]


def hash_of_scene(mpirun, program, count, scene, folder, *options):
    words = [program, "run", scene, "--threads", "1", "--json", "--out", folder, *options]
    results = json.loads(output_of(mpirun, count, words))
    assert os.path.exists(os.path.join(folder, "summary.json"))
    return results["state_hash"]


def check_scene(mpirun, program, scene, ranks, *options):
    hashes, sets = [], []
    for count in 1, int(ranks):
        with tempfile.TemporaryDirectory() as folder:
            hashes.append(hash_of_scene(mpirun, program, count, scene, folder, "--export", "vtp", *options))
            frames = os.path.join(folder, "frames")
            end = "vtp" if count == 1 else "pvtp"
            foam = particles_of(frames, f"diffuse_00012.{end}", (b"Points", b"velocity", b"life", b"kind"))
            assert foam, "no spray, foam or bubbles"
            sets.append([particles_of(frames, f"frame_00012.{end}"), foam])
    assert hashes[0] == hashes[1], hashes
    assert sets[0] == sets[1], "the pieces of the ranks are not the particles of one"


def particles_of(folder, file, names=(b"id", b"Points", b"velocity", b"fluid", b"density_error", b"pressure")):
    """The particles of a .vtp file, or of all that a .pvtp file lists: these arrays of each."""
    path = os.path.join(folder, file)
    if file.endswith(".pvtp"):
        with open(path) as stream:
            pieces = re.findall(r'<Piece Source="([^"]+)"/>', stream.read())
        assert len(pieces) > 1, file
        return sorted(particle for piece in pieces for particle in particles_of(folder, piece, names))
    with open(path, "rb") as stream:
        xml, data = stream.read().split(b"<AppendedData encoding=\"raw\">\n_", 1)
    count = int(re.search(rb'NumberOfPoints="(\d+)"', xml)[1])
    columns = {}
    for name, offset in re.findall(rb'Name="(\w+)" NumberOfComponents="\d" format="appended" offset="(\d+)"', xml):
        start = int(offset) + 8
        length, = struct.unpack_from("<Q", data, start - 8)
        columns[name] = [data[start + k * length // count:start + (k + 1) * length // count] for k in range(count)]
    return sorted(zip(*(columns[name] for name in names)))


def check_restart(mpirun, program, scene):
    with tempfile.TemporaryDirectory() as folder:
        def out(name):
            return os.path.join(folder, name)

        def snapshot(name):
            return os.path.join(out(name), "snapshot_00006.menisnap")

        expected = hash_of_scene(mpirun, program, 1, scene, out("alone"), "--save-every", "6")
        assert hash_of_scene(mpirun, program, 3, scene, out("three"), "--save-every", "6") == expected
        for saved, count in ("three", 2), ("three", 1), ("alone", 2):
            found = hash_of_scene(mpirun, program, count, scene, out("again"), "--from", snapshot(saved))
            assert found == expected, f"from {saved} on {count} ranks: {found}, not {expected}"
        check_damaged(mpirun, program, scene, snapshot("three"), out("again"))


def check_damaged(mpirun, program, scene, file, folder):
    chunk = chunks_of(file)["engine/solver/particles/velocity"]
    with open(file, "r+b") as stream:
        stream.seek(chunk["offset"] + chunk["parts"][0]["count"] * chunk["element_bytes"] + 5)
        byte = stream.read(1)[0]
        stream.seek(-1, os.SEEK_CUR)
        stream.write(bytes([byte ^ 16]))
    done = run(mpirun, 1, [program, "run", scene, "--from", file, "--out", folder])
    assert done.returncode != 0 and "velocity\" is damaged" in done.stderr, done.stderr


if __name__ == "__main__":
    mpirun, program, check, *arguments = sys.argv[1:]
    checks = {"hashes": check_hashes, "contents": check_contents, "gpu_hashes": check_gpu_hashes, "faults": check_faults, "hang": check_hang,
              "memory": check_memory, "particles": check_particles, "momentum": check_momentum, "scene": check_scene,
              "restart": check_restart}
    checks[check](mpirun, program, *arguments)
