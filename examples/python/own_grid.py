# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
# A planned path on an occupancy grid of one's own, drawn.

import numpy as np
import vandplan as vp

yard = np.zeros((200, 300), dtype=bool)  # 40 m by 60 m in cells of 0.2 m; True is an obstacle
yard[:150, 148:152] = True  # a wall ...
yard[170:, 148:152] = True  # ... with a gate in it
scenario = vp.Scenario(start=(10, 10, 0), goal=(50, 10, 0), map=yard, resolution=0.2, vehicle="tpcap-car")
result = vp.plan(scenario, time_limit=0.5)
print(result, result.path.poses(step=5.0), sep="\n")
vp.plot(scenario, result).figure.savefig("yard.png")
