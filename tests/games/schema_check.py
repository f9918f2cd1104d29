"""Checks the schema of native levels, the page about them, and the program against one another.
     schema_check.py PROGRAM ROOT WORK

The examples on the page use every key. Each is valid by the schema, opens without a complaint, and is written again as it
is. Then the limits are tried: at each place that the schema describes, the example gets a value just beyond."""
import copy
import json
import os
import re
import struct
import subprocess
import sys
import zlib

import jsonschema

PROGRAM, ROOT, WORK = sys.argv[1:4]
with open(ROOT + "/assets/talus.schema.json", encoding="utf-8") as file:
    SCHEMA = json.load(file)
jsonschema.Draft7Validator.check_schema(SCHEMA)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)
LOOKS = {"group": 0, "visible": False, "locked": True, "opacity": 0.5, "offset": [1, 2], "parallax": [0.5, 1], "tint": "80ffff"}
PART = {"picture": 0, "rect": [0, 0, 1, 1], "shift": [1, 2], "keeps_ratio": True, "swaps_axes": True, "mirrors_x": True,
        "mirrors_y": True}


def unshown(pictures):
    """What the page shows for one kind of object alone, or not at all, as Talus reads and writes it for others."""
    levels = [{"talus": 1, "tuning": {"balls_block": 0}},
            {"talus": 7, "layers": [{"name": "a", "ldtk": "b", **LOOKS}], "groups": [{"name": "g"}, {"name": "h", **LOOKS}],
             "pictures": pictures, "objects": [{"name": "c", "place": 0, **LOOKS, "image": {"path": "", **PART}, "ldtk": 7,
                                                "objects": [{"form": "tile", "x": 0, "y": 0, **PART}]}]},
            {"talus": 3, "tile_shapes": {"1": {"kind": "group", "parts": [{"kind": "slope", "side": "ceiling", "one_way": True,
                                                                           "tiles": 2, "heights": [0, 8]}]}}}]
    return json.loads(json.dumps(levels))  # no two keys share a list, as changes of one would change the other


# PNGs and packed cells are written again with other bytes.
REWRITTEN = {"picture", "pictures", "packed", "packed_turns"}
PACKED = {"packed": "rows", "packed_turns": "turns"}
# Of a linked tileset. A command stores its pixels instead; LinkedFiles.* are the tests of what the editor saves.
LINK = {"image", "tile_size", "spacing", "margin", "offset"}


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = (b"\0" + b"\x40\x80\xc0\xff" * width) * height
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def run(level, *words):
    path = os.path.join(WORK, "level.talus.json")
    with open(path, "w", encoding="utf-8") as out:
        json.dump(level, out)
    done = subprocess.run([PROGRAM, words[0], path, *words[1:]], capture_output=True, text=True, check=False)
    return done.returncode, (done.stdout + done.stderr).replace(path, "LEVEL")


def errors_of(level):
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in VALIDATOR.iter_errors(level)]


def written_of(level):
    """What Talus writes of a level, or nothing if it refuses it."""
    written = os.path.join(WORK, "written.talus.json")
    if run(level, "import", "-o", written)[0] != 0:
        return None
    with open(written, encoding="utf-8") as file:
        text = file.read()
    os.remove(written)
    return text


# ---- Levels of the repository ----

def levels_of_repository():
    for folder in ("assets", "tests"):
        for path, _, names in os.walk(os.path.join(ROOT, folder)):
            yield from (os.path.join(path, name) for name in sorted(names) if name.endswith(".talus.json"))


def check_levels():
    count = 0
    for path in levels_of_repository():
        with open(path, encoding="utf-8") as file:
            level = json.load(file)
        if "companion" in level:
            continue  # no level, but a part of one
        status, _ = run(level, "import", "-o", WORK + "/copy.talus.json")
        if status != 0:  # a seed of the fuzzers
            assert errors_of(level), path + " does not open, but is valid"
            continue
        os.remove(WORK + "/copy.talus.json")
        assert not errors_of(level), f"{path}: {errors_of(level)}"
        count += 1
    assert count >= 135, f"only {count} levels"
    return count


# ---- Examples of the page ----

def examples_of_page(page):
    examples = [json.loads(text) for text in re.findall(r"^```json\n(.*?)^```$", page, re.M | re.S)]
    assert len(examples) >= 20, f"only {len(examples)} examples"
    return examples


def missing_in(wanted, got, place=""):
    """What of an example is not in what was written."""
    if isinstance(wanted, dict) and isinstance(got, dict):
        for key, value in wanted.items():
            written = PACKED.get(key, key)
            if "first" in wanted and key in LINK or key == "data" and "comment" in wanted:
                continue  # a text project of bytes gets the palette of the level
            if written not in got:
                yield place + "." + key
            elif not (key in REWRITTEN and isinstance(value, list)):
                yield from missing_in(value, got[written], place + "." + key)
    elif isinstance(wanted, list) and isinstance(got, list) and len(wanted) == len(got):
        for i, (one, other) in enumerate(zip(wanted, got)):
            yield from missing_in(one, other, f"{place}[{i}]")
    elif wanted != got:
        yield f"{place}: {json.dumps(got)[:80]} instead of {json.dumps(wanted)[:80]}"


def keys_of(value):
    if isinstance(value, dict):
        for key, inner in value.items():
            if not key.isdigit():
                yield key
            yield from keys_of({}) if key == "properties" else keys_of(inner)
    elif isinstance(value, list):
        for inner in value:
            yield from keys_of(inner)


def check_example(example):
    assert not errors_of(example), f"{example}: {errors_of(example)}"
    status, said = run(example, "check")
    wrong = [line for line in said.splitlines() if ": error: " in line or "[unknown-key]" in line or "LEVEL:" not in line
             and not line.startswith("LEVEL: warning")]
    assert status == 0 and not wrong, f"{json.dumps(example)}: {said}"
    level = json.loads(written_of(example) or "{}")
    missing = list(missing_in(example, level))
    assert not missing, f"{json.dumps(example)} is written without {missing}"
    assert not errors_of(level), errors_of(level)
    return set(keys_of(level))


# ---- Keys ----

def property_names(schema):
    yield from schema.get("properties", {})
    for name in ("properties", "patternProperties", "definitions"):
        for inner in schema.get(name, {}).values():
            yield from property_names(inner)
    items = schema.get("items", [])
    for inner in [*(items if isinstance(items, list) else [items]), *schema.get("anyOf", [])]:
        yield from property_names(inner)


def keys_of_source():
    """The keys that the readers and writers of native levels name."""
    keys = set()
    for name in sorted(os.listdir(ROOT + "/core/formats/native")):
        if not (name.startswith("native") or name == "hard_case_file.cpp"):
            continue
        with open(f"{ROOT}/core/formats/native/{name}", encoding="utf-8") as file:
            text = file.read()
        keys |= set(re.findall(r'(?:json|document|map|its|cart|json\)|part|case)\["(\w+)"\]', text))
        keys |= set(re.findall(r'\b(?:take|put|io|take_\w+|whole|member|list_in|text_in|require|optional|ranged|text|choice|size)'
                               r'\((?:\w+, )?"(\w+)"', text))
    return keys


def check_keys(page, written):
    described = set(property_names(SCHEMA))
    source = keys_of_source()
    assert len(source) > 100, f"only {len(source)} keys found in the source"
    for what, keys in (("the source has", source), ("a written level has", written)):
        assert keys <= described, f"{what} keys that the schema has not: {sorted(keys - described)}"
    on_page = set(re.findall(r"`([\w$]+)`", page))
    assert described <= on_page, f"the page does not have {sorted(described - on_page)}"


# ---- Limits ----

def resolved(schema):
    while "$ref" in schema or "allOf" in schema and set(schema) <= {"allOf", "description"}:
        schema = schema if "$ref" in schema else schema["allOf"][0]
        schema = SCHEMA["definitions"][schema["$ref"].rsplit("/", 1)[1]]
    return schema


def branch(schema, value):
    """The alternative of "anyOf" that a value has."""
    for one in schema.get("anyOf", []):
        if set(one) != {"required"} and jsonschema.Draft7Validator({**one, "definitions": SCHEMA["definitions"]}).is_valid(value):
            return resolved(one)
    return schema


def places(schema, value, path=()):
    """Each place of a level, with the schema of it, that of the alternative that it is, and its value."""
    whole, schema = resolved(schema), branch(resolved(schema), value)
    yield path, whole, schema, value
    if isinstance(value, dict):
        for key, inner in value.items():
            inner_schema = schema.get("properties", {}).get(key)
            for pattern, other in schema.get("patternProperties", {}).items():
                inner_schema = other if re.search(pattern, key) else inner_schema
            if inner_schema:
                yield from places(inner_schema, inner, (*path, key))
    elif isinstance(value, list):
        items = schema.get("items", {})
        for i, inner in enumerate(value):
            yield from places(items[min(i, len(items) - 1)] if isinstance(items, list) else items, inner, (*path, i))


IS = {"integer": lambda v: isinstance(v, int) and not isinstance(v, bool),
      "number": lambda v: isinstance(v, (int, float)) and not isinstance(v, bool), "string": lambda v: isinstance(v, str),
      "boolean": lambda v: isinstance(v, bool), "array": lambda v: isinstance(v, list), "object": lambda v: isinstance(v, dict),
      "null": lambda v: v is None}


def wrong_numbers(schema):
    step = 1 if schema.get("type") in ("integer", ["integer", "null"]) else 0.0009765625
    if "minimum" in schema:
        yield "minimum", schema["minimum"] - step
    if "maximum" in schema:
        yield "maximum", schema["maximum"] + step * max(1, abs(schema["maximum"]) / 1000000)
    if "exclusiveMinimum" in schema:
        yield "exclusiveMinimum", schema["exclusiveMinimum"]
    if schema.get("type") == "integer":
        yield "whole", schema.get("minimum", 0) + 0.5


def wrong_values(schema, value):
    """Values that the schema forbids at a place, each just beyond one limit."""
    yield from wrong_numbers(schema)
    types = schema.get("type", [])
    types = types if isinstance(types, list) else [types]
    if types:
        yield "type", next(v for v in (True, 7, "?", [], {}) if not any(IS[t](v) for t in types))
    if "enum" in schema or "const" in schema:
        yield "enum", "none of these"
    if "pattern" in schema:
        yield "pattern", value + "?"
    if "maxLength" in schema:
        yield "maxLength", "x" * (schema["maxLength"] + 1)
    if isinstance(value, list):
        if "maxItems" in schema and value:
            yield "maxItems", [value[-1]] * (schema["maxItems"] + 1)
        if schema.get("minItems"):
            yield "minItems", value[:schema["minItems"] - 1]
    if isinstance(value, dict):
        needed = list(schema.get("required", []))
        for rule in schema.get("allOf", []):
            if "if" in rule and jsonschema.Draft7Validator(rule["if"]).is_valid(value):
                needed += rule["then"]["required"]
        for key in needed:
            yield "without " + key, {k: v for k, v in value.items() if k != key}
        if schema.get("additionalProperties") is False:
            yield "additional zzz", {**value, "zzz": 1}


def with_value(level, path, value):
    if not path:
        return value
    level = copy.deepcopy(level)
    inner = level
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    return level


def text_of(path):
    return "".join(f"[{step}]" if isinstance(step, int) else "." + step for step in path).lstrip(".")


def names_key(said, path, limit):
    """Whether the sentence is about the value: it has its key, or one around it and the last key in words."""
    found = re.search(r"^LEVEL:key (\S+): error: (.*)", said, re.M)
    rows = re.search(r"^LEVEL:(map|layers\[\d+\]) row (\d+): error: ", said, re.M)
    if rows:
        return path[-1] == "rows" or path[-2:] == ("rows", int(rows[2]))
    if not found:
        return not path and limit == "type" and "error: is JSON, but not a Talus level" in said
    keys = [step for step in path if isinstance(step, str)]
    if " " in limit:
        keys.append(limit.split(" ")[1])
    if not keys:
        return True
    key = keys[-1]
    is_around = text_of(path).startswith(found[1]) or found[1].startswith(text_of(path))
    in_words = key.rstrip("s").replace("_", " ") in found[1] + " " + found[2] or key.rstrip("s") in found[1] + found[2]
    return is_around and (in_words or key.isdigit() and key in found[1])


def check_limits(examples):
    tried, wrong, described = set(), [], set()
    for example in examples:
        for path, whole, schema, value in places(SCHEMA, example):
            described |= {id(whole), id(schema)}
            for limit, bad in wrong_values(schema, value):
                name = re.sub(r"\d+", "N", text_of(path)), limit, str(value) if "const" in schema else ""
                if name in tried:
                    continue
                tried.add(name)
                level = with_value(example, path, bad)
                assert errors_of(level) or limit in ("maxItems",), f"{name}: the schema allows {str(bad)[:80]}"
                status, said = run(level, "check")
                if status != 1 or not names_key(said, path, limit):
                    wrong.append(f"{text_of(path)} {limit}: {str(bad)[:60]}: {status}: {said[:300].strip()}")
    assert not wrong, "\n" + "\n".join(wrong) + f"\n{len(wrong)} of {len(tried)}"
    return len(tried), described


def check_all_described(described):
    """Every property of the schema was at some place of an example."""
    def walk(schema, place):
        for key, inner in schema.get("properties", {}).items():
            assert id(resolved(inner)) in described, f"no example of {place}.{key}"
    walk(SCHEMA, "level")
    for name, schema in SCHEMA["definitions"].items():
        walk(schema, name)


# ---- Defaults ----

def check_defaults(examples):
    """A key with the default of the schema is as no key."""
    tried = set()
    for example in examples:
        for path, _, schema, value in places(SCHEMA, example):
            for key, inner in schema.get("properties", {}).items() if isinstance(value, dict) else ():
                name = re.sub(r"\d+", "N", text_of(path)), key
                if "default" not in inner or key not in value or name in tried or path[:1] == ("hard_case",):
                    continue  # a hard case is kept as it is
                tried.add(name)
                without = {k: v for k, v in value.items() if k != key}
                same = written_of(with_value(example, path, {**without, key: inner["default"]}))
                assert same == written_of(with_value(example, path, without)), f"{name} has another default"
    assert len(tried) > 100, f"only {len(tried)} defaults"
    return len(tried)


# ---- Misspelt keys ----

def check_misspelt(examples):
    """A letter twice in any key is said, with the right key, or refused where a level without the key is, too."""
    tried, said_of = set(), 0
    for example in examples:
        for path, _, schema, value in places(SCHEMA, example):
            for key in schema.get("properties", {}) if isinstance(value, dict) else ():
                name = re.sub(r"\d+", "N", text_of(path)), key
                if (path[:1], key) == (("groups",), "group"):
                    continue  # without it the groups come in another order
                if key in value and name not in tried and path[-1:] != ("properties",) and (path, key) != ((), "talus"):
                    tried.add(name)
                    misspelt = key + key[-1]
                    others = {k: v for k, v in value.items() if k != key} if key not in schema.get("required", []) else value
                    level = with_value(example, path, {**others, misspelt: value[key]})
                    status, said = run(level, "check")
                    place = text_of((*path, misspelt))
                    is_said = f'LEVEL:key {place}: warning: is not known; did you mean "{key}"? [unknown-key]' in said
                    is_refused = status == 1 and (misspelt in said or key in said or run(with_value(example, path, others), "check")[0])
                    assert is_said or is_refused, f"{place}: {status}: {said}"
                    if is_said:
                        said_of += 1
                        if ": error: " not in said:
                            check_kept(level, path, misspelt)
    assert said_of > 150, f"only {said_of} keys were said"
    return said_of


def check_kept(level, path, key):
    inner = json.loads(written_of(level) or "{}")
    for step in path:
        inner = inner[step]
    assert key in inner, f"{text_of((*path, key))} is not kept"


def main():
    with open(os.path.join(WORK, "cave.png"), "wb") as file:
        file.write(png(39, 84))
    with open(ROOT + "/docs/native-format.md", encoding="utf-8") as file:
        page = file.read()
    levels = check_levels()
    examples = examples_of_page(page)
    written = set().union(*(check_example(example) for example in examples))
    check_keys(page, written)
    all_keys = examples + unshown(next(e["pictures"] for e in examples if "pictures" in e))
    limits, described = check_limits(all_keys)
    check_all_described(described)
    defaults, misspelt = check_defaults(all_keys), check_misspelt(examples)
    print(f"{levels} levels, {len(examples)} examples, {limits} limits, {defaults} defaults and {misspelt} misspelt keys, no error")


main()
