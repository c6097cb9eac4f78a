# SPDX-License-Identifier: BSD-3-Clause
# Completion of the command kalos for bash; needs python3-argcomplete.
eval "$(register-python-argcomplete kalos 2>/dev/null || register-python-argcomplete3 kalos 2>/dev/null)"
