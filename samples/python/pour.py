# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""A Gymnasium environment: pour water from a cup into a bowl.

The cup is a kinematic body. Its frame's origin is the middle of the rim towards the bowl, about which it tilts. A
control step takes 1/30 s, and an episode 75 of them.

Action, two numbers from -1 to 1: the speed of the cup towards the bowl, in 0.5 m/s, and its rate of tilt, in 1.5 rad/s.
Observation, six numbers: the distance of the rim from the bowl's middle (m), the tilt (rad), the shares of the water
that are in the cup, in the bowl and lost, and the share of the episode that is left.
Reward: the share that came into the bowl in this step, less the share that was lost.

A reset restores a snapshot, in which the cup is full to the mark. A seed chooses how far the cup is moved then, within
5 cm, and how much water is taken out. Equal seeds and actions give equal returns, bit for bit.

Run it: python samples/python/pour.py"""

from __future__ import annotations

import math
from typing import Any, Literal

import gymnasium
import meniscus
import numpy as np
from numpy.typing import NDArray

SPACING = 0.04  # m; walls are as thick
STEP = 1 / 30  # s
STEPS = 75
CUP = 0.28  # m, inner width and depth of the cup
BOWL, BOWL_DEPTH = 0.56, 0.24  # m, inner width and depth of the bowl
RIM = 0.62  # m, height of the cup's rim above the bowl's floor
START = -0.3  # m, from the bowl's middle to the rim
TOP_SPEED, TOP_RATE = 0.5, 1.5  # m/s, rad/s

Array = NDArray[np.float32]


def vessel(width: float, depth: float, x: float, top: float) -> meniscus.CompoundGeometry:
    """An open box of five plates. Its inside is `width` wide about x, and `depth` deep below `top`."""
    half, wall = width / 2, SPACING / 2

    def plate(size: tuple[float, float, float], place: tuple[float, float, float]) -> dict[str, Any]:
        return {"geometry": meniscus.BoxGeometry(half_extents=size), "pose": (x + place[0], place[1], place[2])}

    side, middle = half + wall, top - depth / 2
    return meniscus.CompoundGeometry(parts=[
        plate((half + 2 * wall, wall, half + 2 * wall), (0, top - depth - wall, 0)),
        plate((wall, depth / 2, half + 2 * wall), (-side, middle, 0)),
        plate((wall, depth / 2, half + 2 * wall), (side, middle, 0)),
        plate((half, depth / 2, wall), (0, middle, -side)),
        plate((half, depth / 2, wall), (0, middle, side))])


class PourEnv(gymnasium.Env[Array, Array]):
    """See the top of this file."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 30}

    def __init__(self, render_mode: str | None = None, device: Literal["auto", "cpu", "cuda"] = "cpu") -> None:
        self.render_mode = render_mode
        self.action_space = gymnasium.spaces.Box(-1, 1, (2,), np.float32)
        low = np.array([-2, -math.pi, 0, 0, 0, 0], np.float32)
        high = np.array([2, math.pi, 1, 1, 1, 1], np.float32)
        self.observation_space = gymnasium.spaces.Box(low, high, (6,), np.float32)
        self.x, self.tilt, self.steps = START, 0.0, 0
        world = meniscus.World(particle_spacing=SPACING, substeps=4, iterations=6, device=device)
        world.add_shape(name="bowl", geometry=vessel(BOWL, BOWL_DEPTH, 0, BOWL_DEPTH))
        world.add_sink(region=meniscus.HalfSpaceRegion(offset=-0.3))
        self.cup = world.add_body(name="cup", motion="kinematic", pose=self._pose(),
                                  geometry=vessel(CUP, CUP, -CUP / 2 - SPACING, 0))
        water = world.add_fluid(name="water", xsph=20)
        middle, floor = START - CUP / 2 - SPACING, RIM - CUP
        world.add_volume(fluid=water, region=meniscus.BoxRegion(
            lower=(middle - CUP / 2, floor, -CUP / 2), upper=(middle + CUP / 2, floor + 0.8 * CUP, CUP / 2)))
        self.world = world
        self.start = world.snapshot()

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        super().reset(seed=seed)
        shift = float(self.np_random.uniform(-0.05, 0.05))
        fill = float(self.np_random.uniform(0.6, 0.8)) * CUP
        self.world.restore(self.start)
        self.x, self.tilt, self.steps = START + shift, 0.0, 0
        self.cup.pose = self._pose()
        self.world.remove_particles(self.world.ids[self.world.positions[:, 1] > RIM - CUP + fill])
        self.world.positions = self.world.positions + np.array([shift, 0, 0], np.float32)
        self.total = self.world.particle_count
        self.shares = self._measure()
        return self._observation(), {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        speed, rate = (float(a) for a in np.clip(action, -1, 1))
        self.x = min(max(self.x + speed * TOP_SPEED * STEP, -1.0), 1.0)
        self.tilt = min(max(self.tilt + rate * TOP_RATE * STEP, 0.0), 2.0)
        self.cup.move_to(self._pose(), STEP)
        self.world.step(STEP)
        self.steps += 1
        before, self.shares = self.shares, self._measure()
        reward = (self.shares[1] - before[1]) - (self.shares[2] - before[2])
        return self._observation(), reward, False, self.steps >= STEPS, {}

    def render(self) -> Any:
        return self.world.draw(480, 360, position=(0.3, 0.9, 2.0), target=(-0.1, 0.25, 0))

    def _pose(self) -> meniscus.Pose:
        turned = meniscus.axis_angle((0, 0, -1), math.degrees(self.tilt))
        return meniscus.Pose(position=(self.x, RIM, 0), rotation=turned)

    def _measure(self) -> tuple[float, float, float]:
        """The shares of the water in the cup, in the bowl and lost: below the bowl, or removed."""
        p = self.world.positions.astype(np.float64)
        c, s = math.cos(self.tilt), math.sin(self.tilt)
        dx, dy = p[:, 0] - self.x, p[:, 1] - RIM
        local_x, local_y = c * dx - s * dy, s * dx + c * dy
        in_cup = (local_x < 0) & (local_x > -CUP - 2 * SPACING) & (local_y < 0) & (local_y > -CUP - SPACING)
        in_bowl = ~in_cup & (np.abs(p[:, 0]) < BOWL / 2) & (np.abs(p[:, 2]) < BOWL / 2) & (p[:, 1] > 0) & (
            p[:, 1] < BOWL_DEPTH)
        lost = self.total - len(p) + int((~in_cup & (p[:, 1] < 0)).sum())
        return float(in_cup.sum()) / self.total, float(in_bowl.sum()) / self.total, lost / self.total

    def _observation(self) -> Array:
        return np.array([self.x, self.tilt, *self.shares, 1 - self.steps / STEPS], np.float32)


def scripted(observation: Array) -> Array:
    """Moves the rim over the near half of the bowl, then tilts."""
    x, tilt = observation[:2]
    return np.array([np.clip((-0.1 - x) * 8, -1, 1), 0.8 if abs(x + 0.1) < 0.02 and tilt < 1.9 else 0], np.float32)


def episode(env: PourEnv, seed: int, policy: Any) -> float:
    """The return of one episode."""
    observation, _ = env.reset(seed=seed)
    total, over = 0.0, False
    while not over:
        observation, reward, ended, truncated, _ = env.step(policy(observation))
        total, over = total + reward, ended or truncated
    return total


def main() -> None:
    env = PourEnv()
    for seed in range(3):
        env.action_space.seed(seed)
        print(f"seed {seed}: scripted {episode(env, seed, scripted):.2f}, "
              f"random {episode(env, seed, lambda _: env.action_space.sample()):.2f}")


if __name__ == "__main__":
    main()
