# SPDX-License-Identifier: BSD-3-Clause
# The classes are wrapped C++, whose types are not written down.
from typing import Any

def __getattr__(name: str) -> Any: ...
