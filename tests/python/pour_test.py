# SPDX-FileCopyrightText: 2026 The Meniscus authors
# SPDX-License-Identifier: MIT
"""The Gymnasium environment of samples/python/pour.py. Skipped without gymnasium."""

import os
import pathlib
import sys
import unittest

try:
    import gymnasium  # noqa: F401
    from gymnasium.utils.env_checker import check_env
except ImportError:
    sys.exit(77)

sys.path.insert(0, str(pathlib.Path(os.environ["MENISCUS_SOURCE_DIR"]) / "samples/python"))
import pour  # noqa: E402

MARGIN = 0.5  # of the water, by which the scripted policy beats the random one


class Pour(unittest.TestCase):
    def test_check_env(self):
        check_env(pour.PourEnv(render_mode="rgb_array"))

    def test_scripted_beats_random(self):
        env = pour.PourEnv()
        for seed, again in ((1, env), (2, pour.PourEnv())):
            best, other = self.returns(env, seed)
            self.assertGreater(best, other + MARGIN)
            self.assertGreaterEqual(best, 0.6)
            self.assertEqual((best, other), self.returns(again, seed))

    def returns(self, env, seed):
        """Of both policies."""
        env.action_space.seed(seed)
        return pour.episode(env, seed, pour.scripted), pour.episode(env, seed, lambda _: env.action_space.sample())


if __name__ == "__main__":
    unittest.main()
