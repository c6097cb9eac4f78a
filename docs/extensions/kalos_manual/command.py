# SPDX-License-Identifier: BSD-3-Clause
"""The command line, from the parser that reads it."""
import argparse


def metavar(action):
    return f" {action.metavar}" if action.metavar else f" {{{','.join(map(str, action.choices))}}}" if action.choices else ""


def entry(action):
    """A definition: the option as it is typed, and what --help says about it."""
    names = ", ".join(f"`{name}{metavar(action)}`" for name in action.option_strings) or f"`{action.metavar or action.dest}`"
    words = (action.help or "") % {"default": action.default, "prog": "kalos", "choices": action.choices}
    return f"{names}\n: {words[:1].upper()}{words[1:]}.\n"


def subparsers(parser):
    choice, = (action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    heads = {action.dest: action.help for action in choice._choices_actions}
    return {name: (heads[name], sub) for name, sub in choice.choices.items()}


def write():
    from kalos.commands.main import parser

    lines = []
    for name, (head, sub) in subparsers(parser()).items():
        usage = " ".join(sub.format_usage().removeprefix("usage: ").split())
        lines += [f"## kalos {name}", "", f"{head[:1].upper()}{head[1:]}.", "", "```text", *wrapped(usage), "```", ""]
        lines += [entry(action) for action in sub._actions if not isinstance(action, argparse._HelpAction)]
        if sub.epilog:
            lines += [sub.epilog, ""]
    return "\n".join(lines)


def wrapped(usage, width=100):
    """The usage in lines that end between options."""
    line, lines = "", []
    for word in usage.replace(" [", "\n[").split("\n"):
        if len(line) + len(word) > width:
            lines.append(line.rstrip())
            line = "    "
        line += word + " "
    return [*lines, line.rstrip()]
