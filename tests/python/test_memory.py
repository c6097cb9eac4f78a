# SPDX-License-Identifier: BSD-3-Clause
"""The memory that there is, as made-up files below /proc and /sys say it, and the memory that a solve will take."""
import resource

import pytest

from kalos.solving import memory

MB = 1024**2


@pytest.fixture
def machine(tmp_path):
    """A root folder of a machine with 8 GB free, and this process of 100 MB in control group /a/b."""
    (tmp_path / "proc/self").mkdir(parents=True)
    (tmp_path / "proc/meminfo").write_text(f"MemTotal: 9999999 kB\nMemAvailable: {8000 * 1024} kB\nHugePages_Total: 0\n")
    (tmp_path / "proc/self/status").write_text(f"Name:\tpython3\nVmSize:\t{1100 * 1024} kB\nVmRSS:\t{100 * 1024} kB\n")
    (tmp_path / "proc/self/cgroup").write_text("0::/a/b\n")
    return tmp_path


def group(root, name, limit, usage, cached, names=("memory.max", "memory.current")):
    folder = root / "sys/fs/cgroup" / name
    folder.mkdir(parents=True, exist_ok=True)
    for file, content in zip((*names, "memory.stat"), (limit, usage, f"anon 5\ninactive_file {cached}\nactive_file 0")):
        (folder / file).write_text(f"{content}\n")


def test_the_machine(machine):
    assert memory.available(machine) == (8100 * MB, "free on this machine")


def test_control_groups(machine):
    group(machine, "a/b", "max", 500 * MB, 0)
    assert memory.available(machine)[1] == "free on this machine"
    group(machine, "a", 2000 * MB, 1500 * MB, 300 * MB)  # the tightest group counts, without the files it keeps in memory
    assert memory.available(machine) == ((2000 - 1500 + 300 + 100) * MB, "left in the control group")
    (machine / "proc/self/cgroup").write_text("5:cpu,cpuacct:/a\n4:memory:/old\n")
    group(machine, "memory/old", 700 * MB, 600 * MB, 0, ("memory.limit_in_bytes", "memory.usage_in_bytes"))
    assert memory.available(machine) == (200 * MB, "left in the control group")


def test_limits_of_the_shell(machine, monkeypatch):
    monkeypatch.setattr(resource, "getrlimit", lambda kind: (3000 * MB if kind == resource.RLIMIT_AS else -1, -1))
    assert memory.available(machine) == ((3000 - 1000) * MB, "allowed by ulimit -v")  # 1000 MB are addresses only


def test_a_system_that_does_not_say(tmp_path):
    assert memory.available(tmp_path)[0] == float("inf")


def test_demand_grows_with_everything():
    least = memory.demand(1000)
    for more in ({"triangles": 2000}, {"receivers": 1000}, {"luminaires": 10}, {"pixels": 1000}):
        assert memory.demand(**{"triangles": 1000, **more}) > least
    assert memory.demand(0, 10**6, bands=3) > memory.demand(0, 10**6, bands=1)
    assert memory.demand(10**6, preparing=False) < memory.demand(10**6)
