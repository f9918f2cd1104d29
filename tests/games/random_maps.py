"""Random maps of Tiled, and what is ground in them by a reading of its own.
     random_maps.py make SEED FOLDER         writes FOLDER/map.tmx with its tilesets and FOLDER/ground.json
     random_maps.py check FOLDER LEVEL.json  compares points with the outlines that `talus export --to json` wrote"""
import json
import math
import random
import struct
import sys
import zlib

FLIP_X, FLIP_Y, FLIP_XY = 1 << 31, 1 << 30, 1 << 29
NEAR = 0.15  # px: an ellipse is a polygon in a level, and points of polygons are rounded


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + bytes((x * 7 + y * 13 + channel * 50) % 256 for x in range(width) for channel in range(3))
                    for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def eighths(dice, least, most):
    return dice.randint(int(least * 8), int(most * 8)) / 8


def random_area(dice, width, height):
    """A box, an ellipse or a star around a point, which is a simple polygon, in a tile or on the map."""
    form = dice.choice(["box", "ellipse", "polygon"])
    area = {"form": form, "x": eighths(dice, -width / 4, width / 2), "y": eighths(dice, -height / 4, height / 2),
            "w": eighths(dice, 1, width), "h": eighths(dice, 1, height), "rotation": 0, "points": []}
    if form == "polygon":
        count = dice.randint(3, 8)
        turns = [(i + dice.uniform(0.1, 0.7)) / count * 2 * math.pi for i in range(count)]
        sizes = [dice.uniform(0.2, 0.6) for _ in turns]
        area["points"] = [(round(8 * width * size * math.cos(turn)) / 8, round(8 * height * size * math.sin(turn)) / 8)
                          for size, turn in zip(sizes, turns)]
        area["x"], area["y"], area["w"], area["h"] = width / 2, height / 2, 0, 0
    elif dice.random() < 0.4:
        area["rotation"] = dice.randrange(15, 360, 15)
    return area


def xml_of_area(area, number):
    text = f'<object id="{number}" x="{area["x"]:g}" y="{area["y"]:g}" width="{area["w"]:g}" height="{area["h"]:g}"'
    text += f' rotation="{area["rotation"]}">'
    if area["form"] == "ellipse":
        text += "<ellipse/>"
    if area["form"] == "polygon":
        text += '<polygon points="' + " ".join(f"{x:g},{y:g}" for x, y in area["points"]) + '"/>'
    return text + "</object>"


def outline(area):
    """Its points; those of an ellipse lie on it."""
    if area["form"] == "polygon":
        points = area["points"]
    elif area["form"] == "ellipse":
        turns = [i / 256 * 2 * math.pi for i in range(256)]
        points = [(area["w"] / 2 * (1 + math.cos(t)), area["h"] / 2 * (1 + math.sin(t))) for t in turns]
    else:
        points = [(0, 0), (area["w"], 0), (area["w"], area["h"]), (0, area["h"])]
    turn = math.radians(area["rotation"])
    cos, sin = math.cos(turn), math.sin(turn)
    return [(area["x"] + x * cos - y * sin, area["y"] + x * sin + y * cos) for x, y in points]


def turned(points, cell, width, height):
    """As a cell with these flips shows them, in a square tile or one that is not turned by a quarter."""
    for x, y in points:
        if cell & FLIP_XY:
            x, y = y, x
        yield (width - x if cell & FLIP_X else x), (height - y if cell & FLIP_Y else y)


def tileset(dice, name, width, height, folder):
    columns, rows, gap, margin = dice.randint(2, 5), dice.randint(1, 4), dice.randint(0, 2), dice.randint(0, 2)
    picture = [2 * margin + count * (side + gap) - gap for count, side in ((columns, width), (rows, height))]
    with open(f"{folder}/{name}.png", "wb") as file:
        file.write(png(*picture))
    shapes = {tile: [random_area(dice, width, height) for _ in range(dice.choice([1, 1, 2]))]
              for tile in range(columns * rows) if dice.random() < 0.5}
    text = (f'name="{name}" tilewidth="{width}" tileheight="{height}" tilecount="{columns * rows}" columns="{columns}" '
            f'spacing="{gap}" margin="{margin}"><image source="{name}.png" width="{picture[0]}" height="{picture[1]}"/>')
    for tile, areas in shapes.items():
        objects = "".join(xml_of_area(area, i + 1) for i, area in enumerate(areas))
        text += f'<tile id="{tile}"><objectgroup draworder="index">{objects}</objectgroup></tile>'
    return text + "</tileset>", shapes, columns * rows


def make(seed, folder):
    dice = random.Random(seed)
    width, height = (dice.randint(5, 40), dice.randint(5, 40)) if seed % 2 else (dice.randint(5, 40),) * 2
    columns, rows = dice.randint(3, 12), dice.randint(3, 9)
    own, own_shapes, own_count = tileset(dice, "own", width, height, folder)
    other, other_shapes, other_count = tileset(dice, "other", width, height, folder)
    with open(f"{folder}/other.tsx", "w") as file:
        file.write("<tileset " + other)
    first = {0: own_shapes, own_count: other_shapes}
    flips = [0, FLIP_X, FLIP_Y, FLIP_X | FLIP_Y] + ([FLIP_XY, FLIP_XY | FLIP_X] if width == height else [])
    polygons, layers = [], ""
    for layer in range(dice.randint(1, 3)):
        cells = [dice.randint(0, own_count + other_count) for _ in range(columns * rows)]
        cells = [cell | dice.choice(flips) if cell else 0 for cell in cells]
        for place, cell in enumerate(cells):
            number = (cell & 0xFFFFFF) - 1
            before = max((begin for begin in first if begin <= number), default=0)
            x, y = place % columns * width, place // columns * height
            for area in first[before].get(number - before, []):
                polygons.append([(x + px, y + py) for px, py in turned(outline(area), cell, width, height)])
        layers += f'<layer id="{layer + 1}" name="l{layer}" width="{columns}" height="{rows}">'
        layers += f'<data encoding="csv">{",".join(map(str, cells))}</data></layer>'
    objects = [random_area(dice, columns * width, rows * height) for _ in range(dice.randint(0, 3))]
    polygons += [outline(area) for area in objects]
    with open(f"{folder}/map.tmx", "w") as file:
        file.write(f'<map version="1.8" orientation="orthogonal" width="{columns}" height="{rows}" tilewidth="{width}" '
                   f'tileheight="{height}" infinite="0" nextlayerid="9" nextobjectid="9"><tileset firstgid="1" {own}'
                   f'<tileset firstgid="{own_count + 1}" source="other.tsx"/>{layers}'
                   '<objectgroup id="8" name="collision">'
                   + "".join(xml_of_area(area, i + 1) for i, area in enumerate(objects)) + "</objectgroup></map>")
    with open(f"{folder}/ground.json", "w") as file:
        json.dump({"width": columns * width, "height": rows * height, "polygons": polygons}, file)


def sides(points):
    return zip(points[-1:] + points[:-1], points)


def is_inside(points, x, y):
    return sum((y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)
               for (x0, y0), (x1, y1) in sides(points)) % 2 == 1


def is_near(points, x, y):
    for (x0, y0), (x1, y1) in sides(points):
        dx, dy = x1 - x0, y1 - y0
        along = max(0, min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy))) if dx or dy else 0
        if math.hypot(x0 + along * dx - x, y0 + along * dy - y) < NEAR:
            return True
    return False


def box_around(points):
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs) - NEAR, min(ys) - NEAR, max(xs) + NEAR, max(ys) + NEAR


def check(folder, exported):
    ground = json.load(open(f"{folder}/ground.json"))
    rings = [list(zip(ring["points"][::2], ring["points"][1::2])) for ring in json.load(open(exported))["polygons"]]
    boxes = [box_around(points) for points in ground["polygons"]]
    dice = random.Random(17)
    known = wrong = 0
    for _ in range(1000):
        x, y = dice.uniform(0, ground["width"]), dice.uniform(0, ground["height"])
        around = [points for points, (left, top, right, bottom) in zip(ground["polygons"], boxes)
                  if left <= x <= right and top <= y <= bottom]
        if any(is_near(points, x, y) for points in around):
            continue
        known += 1
        expected = any(is_inside(points, x, y) for points in around)
        if expected != (sum(is_inside(ring, x, y) for ring in rings) % 2 == 1):
            wrong += 1
            print(f"({x}, {y}) is {'ground' if expected else 'no ground'}, but not so in {exported}")
    sys.exit(1 if wrong or known < 300 else 0)


if sys.argv[1] == "make":
    make(int(sys.argv[2]), sys.argv[3])
else:
    check(sys.argv[2], sys.argv[3])
