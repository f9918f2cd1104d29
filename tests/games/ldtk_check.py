"""Checks projects of LDtk against schemas. Also checks what a schema cannot say: that numbers refer to things that exist.
     ldtk_check.py FILE.ldtk... -- SCHEMA.json..."""
import json
import os
import sys

import jsonschema


def check_references(path, project):
    defs, level = project["defs"], project["levels"][0]
    layers = {layer["uid"]: layer for layer in defs["layers"]}
    tilesets = {tileset["uid"]: tileset for tileset in defs["tilesets"]}
    fields = {field["uid"]: (entity["uid"], field) for entity in defs["entities"] for field in entity["fieldDefs"]}
    uids = [level["uid"], *layers, *tilesets, *fields, *(entity["uid"] for entity in defs["entities"])]
    assert len(uids) == len(set(uids)) and max(uids) < project["nextUid"], "numbers are used twice"
    iids = [project["iid"], level["iid"]]
    cells = level["pxWid"] * level["pxHei"] // 64
    for layer in level["layerInstances"]:
        definition = layers[layer["layerDefUid"]]
        assert (layer["__identifier"], layer["__type"]) == (definition["identifier"], definition["type"])
        assert layer["levelId"] == level["uid"] and layer["__cWid"] * layer["__cHei"] == cells
        values = {value["value"] for value in definition["intGridValues"]} | {0}
        assert len(layer["intGridCsv"]) == (cells if layer["__type"] == "IntGrid" else 0)
        assert set(layer["intGridCsv"]) <= values, "a cell has a value that is not defined"
        for tile in layer["gridTiles"]:
            x, y = tile["px"]
            assert tile["d"] == [y // 8 * layer["__cWid"] + x // 8]
            assert tile["f"] in (0, 1, 2, 3)
            assert tile["src"] == [tile["t"] % 16 * 8, tile["t"] // 16 * 8]
        iids.append(layer["iid"])
        for entity in layer["entityInstances"]:
            iids.append(entity["iid"])
            for field in entity["fieldInstances"]:
                owner, definition = fields[field["defUid"]]
                assert owner == entity["defUid"] and definition["identifier"] == field["__identifier"]
                value = field["__value"]
                if field["__type"] == "Tile" and value:
                    value = f'{value["x"]},{value["y"]},{value["w"]},{value["h"]}'
                assert field["realEditorValues"] == [] if value is None else field["realEditorValues"][0]["params"] == [value]
    assert len(iids) == len(set(iids)), "an iid is used twice"
    for tileset in tilesets.values():
        with open(os.path.join(os.path.dirname(path), tileset["relPath"]), "rb") as picture:
            header = picture.read(24)
        size = int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")
        assert size == (tileset["pxWid"], tileset["pxHei"]), "the sheet has another size"
        for tile in tileset["customData"]:
            json.loads(tile["data"])


valid = set()  # items of arrays, by the schema for them


def check_items(validator, schema, array, _):
    """The keyword "items". An item that is valid is not looked at again: most cells of most levels are alike."""
    for index, item in enumerate(array if validator.is_type(array, "array") else []):
        key = id(schema), repr(item)
        if key in valid:
            continue
        errors = list(validator.descend(item, schema, path=index))
        if not errors:
            valid.add(key)
        yield from errors


Validator = jsonschema.validators.extend(jsonschema.Draft7Validator, {"items": check_items})


def main():
    split = sys.argv.index("--")
    validators = []
    for name in sys.argv[split + 1:]:
        with open(name, encoding="utf-8") as file:
            validators.append((name, Validator(json.load(file))))
    for path in sys.argv[1:split]:
        with open(path, encoding="utf-8") as file:
            project = json.load(file)
        for name, validator in validators:
            for error in validator.iter_errors(project):
                sys.exit(f"{path}: {name}: {'/'.join(map(str, error.absolute_path))}: {error.message}")
        check_references(path, project)
        broken = dict(project, levels="none")
        assert all(not validator.is_valid(broken) for _, validator in validators), "the schema checks nothing"
    print(f"{split - 1} projects, {len(validators)} schemas, no error")


main()
