# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the Vändplan authors
"""nav2_bringup with Vändplan as its planner: its parameter file, with ours laid over it.

ros2 launch vandplan_nav2 planner.launch.py [bringup:=tb3_loopback_simulation_launch.py] [params_file:=FILE]
"""

import tempfile

import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration

OURS = get_package_share_directory("vandplan_nav2") + "/params/planner.yaml"
BRINGUP = get_package_share_directory("nav2_bringup")


def with_our_planner(file):
    """The name of a file with the parameters of `file`, whose planners are ours."""
    with open(file, encoding="utf-8") as text:
        parameters = yaml.safe_load(text)
    with open(OURS, encoding="utf-8") as text:
        ours = yaml.safe_load(text)["planner_server"]["ros__parameters"]
    server = parameters.setdefault("planner_server", {}).setdefault("ros__parameters", {})
    for name in server.pop("planner_plugins", []):
        server.pop(name, None)
    server.update(ours)
    with tempfile.NamedTemporaryFile("w", prefix="vandplan_nav2_", suffix=".yaml", delete=False) as merged:
        yaml.safe_dump(parameters, merged)
    return merged.name


def bringup(context):
    launched = LaunchConfiguration("bringup").perform(context)
    params = with_our_planner(LaunchConfiguration("params_file").perform(context))
    source = PythonLaunchDescriptionSource(f"{BRINGUP}/launch/{launched}")
    return [IncludeLaunchDescription(source, launch_arguments={"params_file": params}.items())]


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("bringup", default_value="tb3_loopback_simulation_launch.py"),
            DeclareLaunchArgument("params_file", default_value=f"{BRINGUP}/params/nav2_params.yaml"),
            OpaqueFunction(function=bringup),
        ]
    )
