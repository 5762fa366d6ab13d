#!/bin/sh
# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
#
# Tutorial: scene files and checks. Run it in a folder of your own; results go to out/.
set -eu
scene=$(dirname "$0")/tank.json
meniscus=${MENISCUS_PROGRAM:-meniscus}

# Read the scene, without running it. A mistyped key is named, with its nearest neighbour.
"$meniscus" check "$scene"
"$meniscus" check "$scene" --set fluids[0].rest_densty=998 2>mistake.txt && exit 1
grep 'did you mean "rest_density"' mistake.txt

# Run it: 2 s, in which all checks must hold.
"$meniscus" run "$scene" --out out/tank --size 480x270 --quiet
cp out/tank/preview.png scene_files.png

# The same scene with a heavy ball, which sinks. The check that it floats breaks, and the exit code is 3.
status=0
"$meniscus" run "$scene" --set bodies[0].density=2000 --frames 100 --out out/heavy --quiet 2>broken.txt || status=$?
[ $status = 3 ]
grep 'the ball floats' broken.txt

# Results for other programs: one JSON value on stdout.
"$meniscus" check "$scene" --json >contents.json
