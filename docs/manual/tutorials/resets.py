# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: resets and Gymnasium. An environment that carries a tank of water to a target without sloshing. It is reset
by a snapshot, bit for bit."""

from __future__ import annotations

import time
from typing import Any

import gymnasium
import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STEP, STEPS = 1 / 30, 60  # s, and steps in an episode
TARGET, TOP_SPEED = 0.6, 1.0  # m, m/s


class CarryEnv(gymnasium.Env[np.ndarray, np.ndarray]):
    """Action: the acceleration of the tank, from −1 to 1, in 4 m/s². Observation: place (m) and speed (m/s) of the tank,
    and how far the centre of the water is from the middle of the tank (m) and how fast it moves there (m/s)."""

    def __init__(self) -> None:
        self.action_space = gymnasium.spaces.Box(-1, 1, (1,), np.float32)
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (4,), np.float32)
        world = m.World(particle_spacing=0.05, substeps=4, iterations=6)
        self.tank = world.add_body(name="tank", motion="kinematic", geometry=m.ContainerGeometry(
            half_extents=(0.3, 0.3, 0.15)))
        water = world.add_fluid(name="water", xsph=5)
        world.add_volume(fluid=water, region=m.BoxRegion(lower=(-0.3, -0.3, -0.15), upper=(0.3, 0, 0.15)))
        for _ in range(30):
            world.step(STEP)  # comes to rest, once
        self.world = world
        self.start = world.snapshot()  # stays on the device

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        super().reset(seed=seed)
        self.world.restore(self.start)
        self.x = self.speed = 0.0
        self.steps = 0
        return self._observe(), {}

    def step(self, action: np.ndarray) -> tuple[np.ndarray, float, bool, bool, dict]:
        self.speed = float(np.clip(self.speed + 4 * float(np.clip(action[0], -1, 1)) * STEP, -TOP_SPEED, TOP_SPEED))
        self.x += self.speed * STEP
        self.tank.move_to((self.x, 0, 0), STEP)
        self.world.step(STEP)
        self.steps += 1
        seen = self._observe()
        reward = -abs(TARGET - self.x) - 10 * abs(float(seen[2]))
        return seen, reward, False, self.steps >= STEPS, {}

    def _observe(self) -> np.ndarray:
        offset = self.world.positions[:, 0].mean(dtype=np.float64) - self.x
        drift = self.world.velocities[:, 0].mean(dtype=np.float64) - self.speed
        return np.array([self.x, self.speed, offset, drift], np.float32)


def careful(seen: np.ndarray) -> np.ndarray:
    """Drives to the target as a damped spring would, and gives way to the water."""
    x, speed, offset, _ = seen
    return np.array([2 * (TARGET - x) - 1.6 * speed + 4 * offset], np.float32)


def hasty(seen: np.ndarray) -> np.ndarray:
    """Full speed ahead, then brakes."""
    x, speed, *_ = seen
    return np.array([np.sign(TARGET - x - speed * abs(speed) / 8)], np.float32)


def episode(env: CarryEnv, policy: Any) -> tuple[float, list[float], int]:
    """The return, the path of the water's offset, and the hash of the last state."""
    seen, _ = env.reset()
    total, offsets, over = 0.0, [], False
    while not over:
        seen, reward, _, over, _ = env.step(policy(seen))
        total += reward
        offsets.append(float(seen[2]))
    return total, offsets, env.world.state_hash()


env = CarryEnv()
first, second, other = episode(env, careful), episode(env, careful), episode(env, hasty)
began = time.perf_counter()
env.reset()
print(f"{env.world.particle_count} particles; a reset takes {1000 * (time.perf_counter() - began):.2f} ms")
print(f"careful {first[0]:.2f} and again {second[0]:.2f}, hasty {other[0]:.2f}")
plt.figure(figsize=(6.4, 3.6), layout="constrained")
for name, (_, offsets, _) in (("careful", first), ("hasty", other)):
    plt.plot(np.arange(1, STEPS + 1) * STEP, offsets, label=name)
plt.xlabel("time (s)"), plt.ylabel("offset of the water (m)"), plt.legend()
plt.savefig("resets.png", dpi=100)

assert first == second, "an episode after a reset must be the same, bit for bit"
assert first[2] != other[2] and first[0] > other[0], "another policy must do otherwise, and worse"
