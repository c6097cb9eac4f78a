#compdef kalos
# SPDX-License-Identifier: BSD-3-Clause
# Completion of the command kalos for zsh; needs python3-argcomplete.
autoload -U +X bashcompinit && bashcompinit
eval "$(register-python-argcomplete kalos 2>/dev/null || register-python-argcomplete3 kalos 2>/dev/null)"
