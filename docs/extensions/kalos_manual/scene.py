# SPDX-License-Identifier: BSD-3-Clause
"""The scene file and summary.json, from their JSON Schemas; each key with an example."""
import json
from pathlib import Path

SCHEMAS = Path(__file__).resolve().parents[3] / "python" / "kalos" / "schemas"
HERE = Path(__file__).resolve().parents[2] / "reference"


def read(name):
    return json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))


def resolved(value, definitions):
    """A schema with what its reference says, its own words first."""
    if "$ref" in value:
        return definitions[value["$ref"].rsplit("/", 1)[1]] | {key: word for key, word in value.items() if key != "$ref"}
    return value


def kind(value, definitions):
    """What a value may be, in words."""
    name = value.get("$ref", "").rsplit("/", 1)[-1]
    value = resolved(value, definitions)
    if name and value.get("type") == "object":
        return f"[{name}](#{name})"
    if "const" in value:
        return f"`{json.dumps(value['const'])}`"
    if "enum" in value:
        return " or ".join(f"`{json.dumps(one)}`" for one in value["enum"])
    if "oneOf" in value and "type" not in value:
        return " or ".join(kind(one, definitions) for one in value["oneOf"])
    of = value.get("type", "object")
    of = of[0] if isinstance(of, list) else of
    if of == "array":
        items = kind(value["items"], definitions)
        return f"{value['minItems']} × {items}" if value.get("minItems") == value.get("maxItems", -1) else f"list: {items}"
    return of + limits(value)


def limits(value):
    words = [f"{sign} {value[key]}" for key, sign in (("minimum", "≥"), ("exclusiveMinimum", ">"), ("maximum", "≤"), ("exclusiveMaximum", "<"))
             if key in value]
    return " " + ", ".join(words) if words else ""


def required(value):
    return set(value.get("required", ()))


def table(title, value, definitions, examples):
    lines = [f"## `{title}`", "", sentence(value.get("description", "")), "", "| key | value | meaning | example |", "| --- | --- | --- | --- |"]
    for key, one in value["properties"].items():
        if (title, key) not in examples:
            raise ValueError(f"docs/reference/scene-examples.json: '{title}' lacks an example of '{key}'")
        example = json.dumps({key: examples[title, key]}, ensure_ascii=False)[1:-1]
        star = " (required)" if key in required(value) else ""
        meaning = resolved(one, definitions).get("description", "")
        lines.append(f"| `{key}`{star} | {kind(one, definitions)} | {meaning} | `{example}` |")
    return [*lines, ""]


def sentence(words):
    return f"{words[:1].upper()}{words[1:].rstrip('.')}." if words else ""


def write():
    schema = read("scene")
    definitions = schema["$defs"]
    written = json.loads((HERE / "scene-examples.json").read_text(encoding="utf-8"))
    examples = {(title, key): value for title, keys in written.items() for key, value in keys.items()}
    lines = table("scene", schema, definitions, examples)
    for name, value in definitions.items():
        if value.get("type") == "object":
            lines += table(name, value, definitions, examples)
    return "\n".join(lines)


def write_summary():
    schema = read("summary")
    lines = ["| key | value | meaning and unit |", "| --- | --- | --- |"]

    def add(path, value):
        value = resolved(value, schema.get("$defs", {}))
        lines.append(f"| `{path}` | {kind(value, schema.get('$defs', {}))} | {value.get('description', '')} |")
        for key, one in value.get("properties", {}).items():
            add(f"{path}.{key}", one)
        if isinstance(value.get("additionalProperties"), dict):
            add(f"{path}.NAME", value["additionalProperties"])
        if value.get("type") == "array" and value["items"].get("type") == "object":
            add(f"{path}[]", value["items"])

    for key, one in schema["properties"].items():
        add(key, one)
    return "\n".join(lines)
