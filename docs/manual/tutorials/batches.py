# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""Tutorial: many worlds at once. The environment of resets.py as a vector of environments, which step in one batch. A
search by the cross-entropy method finds the gains of a policy."""

from __future__ import annotations

import time
from typing import Any

import gymnasium
import matplotlib
import meniscus as m
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STEP, STEPS = 1 / 30, 45  # s, and steps in an episode
TARGET, TOP_SPEED, RAIL = 0.6, 1.0, 0.9  # m, m/s, m: an episode ends early where the tank leaves the rail
WORLDS, GENERATIONS, BEST = 16, 5, 4


class CarryVectorEnv(gymnasium.vector.VectorEnv):
    """Action: the acceleration of each tank, from −1 to 1, in 4 m/s². Observation, by world: place (m) and speed (m/s) of
    the tank, and how far the centre of the water is from its middle (m)."""

    metadata = {"autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}

    def __init__(self, num_envs: int) -> None:
        self.num_envs = num_envs
        self.single_action_space = gymnasium.spaces.Box(-1, 1, (1,), np.float32)
        self.single_observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (3,), np.float32)
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, num_envs)
        world = m.World(particle_spacing=0.075, substeps=4, iterations=4, sums="fixed")
        self.tank = world.add_body(name="tank", motion="kinematic", geometry=m.ContainerGeometry(
            half_extents=(0.3, 0.3, 0.15)))
        water = world.add_fluid(name="water", xsph=5)
        world.add_volume(fluid=water, region=m.BoxRegion(lower=(-0.3, -0.3, -0.15), upper=(0.3, 0, 0.15)))
        for _ in range(30):
            world.step(STEP)  # comes to rest, once
        self.batch = m.WorldBatch(world, worlds=num_envs)
        self.x, self.speed = np.zeros(num_envs), np.zeros(num_envs)
        self.steps, self.over = np.zeros(num_envs, int), np.ones(num_envs, bool)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[np.ndarray, dict]:
        super().reset(seed=seed)
        self._start(np.ones(self.num_envs, bool))
        return self._observe(), {}

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict]:
        fresh = self.over.copy()
        self._start(fresh)  # and these ignore their actions, as Gymnasium has it
        push = np.clip(np.asarray(actions, float)[:, 0], -1, 1)
        self.speed = np.where(fresh, 0, np.clip(self.speed + 4 * push * STEP, -TOP_SPEED, TOP_SPEED))
        self.x = self.x + self.speed * STEP
        for world, x in enumerate(self.x):
            self.batch.move_body(world, self.tank, (x, 0, 0), STEP)
        self.batch.set_active(~fresh)
        self.batch.step(STEP)
        self.steps += ~fresh
        seen = self._observe()
        reward = np.where(fresh, 0, -np.abs(TARGET - self.x) - 10 * np.abs(seen[:, 2]))
        ended, truncated = np.abs(self.x) > RAIL, self.steps >= STEPS
        self.over = ended | truncated
        return seen, reward, ended, truncated, {}

    def _start(self, mask: np.ndarray) -> None:
        if mask.any():
            self.batch.reset(mask)
        self.x[mask] = self.speed[mask] = 0
        self.steps[mask] = 0
        self.over[mask] = False

    def _observe(self) -> np.ndarray:
        offset = self.batch.positions[:, :, 0].mean(axis=1, dtype=np.float64) - self.x
        return np.stack([self.x, self.speed, offset], axis=1).astype(np.float32)


def returns(env: CarryVectorEnv, gains: np.ndarray) -> np.ndarray:
    """The return of one episode by world, with gains of its own: to the target, against the speed, after the water."""
    seen, _ = env.reset()
    total, running = np.zeros(env.num_envs), np.ones(env.num_envs, bool)
    while running.any():
        push = gains[:, 0] * (TARGET - seen[:, 0]) - gains[:, 1] * seen[:, 1] + gains[:, 2] * seen[:, 2]
        seen, reward, ended, truncated, _ = env.step(push[:, None])
        total += np.where(running, reward, 0) - 100.0 * (running & ended)
        running &= ~(ended | truncated)
    return total


env = CarryVectorEnv(WORLDS)
random = np.random.default_rng(1)
mean, spread = np.array([1.0, 0.5, 0.0]), np.array([1.5, 1.0, 3.0])
history = []
began = time.perf_counter()
for generation in range(GENERATIONS):
    gains = mean + spread * random.standard_normal((WORLDS, 3))
    scores = returns(env, gains)
    best = gains[np.argsort(scores)[-BEST:]]
    mean, spread = best.mean(axis=0), best.std(axis=0) + 0.1
    history.append(scores)
    print(f"generation {generation}: returns {scores.mean():.1f} on average, {scores.max():.1f} at best")
seconds = time.perf_counter() - began
print(f"{WORLDS} worlds of {env.batch.particle_count} particles; gains {np.round(mean, 1)}; {seconds:.1f} s")
plt.figure(figsize=(6.4, 3.6), layout="constrained")
for generation, scores in enumerate(history):
    plt.plot(np.full(WORLDS, generation), np.maximum(scores, -80), "o", color="tab:blue", alpha=0.5)
plt.plot([np.median(scores) for scores in history], color="tab:red", label="median")
plt.xticks(range(GENERATIONS)), plt.xlabel("generation"), plt.ylabel("return, at least −80"), plt.legend()
plt.savefig("batches.png", dpi=100)

assert np.median(history[-1]) > np.median(history[0]), "the search must find better gains"
same = np.tile(mean, (WORLDS, 1))
returns(env, same)
assert len(set(env.batch.state_hashes.tolist())) == 1, "equal actions must give equal bits in all worlds"
