// Reads maps that Talus wrote for Tiled with the readers of Phaser and Excalibur, compares what arrives with the map
// itself, and the ground with the same level's plain data. The lines of docs/engines.md are run for that.
//   node engines.js NODE_MODULES PHASER_LINES EXCALIBUR_LINES MAP.tmj...
// Beside each MAP.tmj is MAP.json, exported as plain data.
"use strict";
const assert = require("assert").strict;
const fs = require("fs");
const path = require("path");
const [modules, phaserLines, excaliburLines, ...files] = process.argv.slice(2);

// Both engines ask a browser what it can do as soon as they are loaded. This one answers anything to anything.
const anything = new Proxy(function () {}, {
  get: (_, key) => key === Symbol.toPrimitive ? () => "" : key === Symbol.iterator ? function* () {} : anything,
  apply: () => anything, construct: () => anything, set: () => true,
});
for (const name of ["window", "document", "navigator", "HTMLElement", "HTMLCanvasElement", "HTMLImageElement", "Image",
  "Element", "AudioContext"])
  if (!(name in globalThis)) globalThis[name] = anything;
globalThis.self = globalThis;
const load = require("module").createRequire(path.join(path.resolve(modules), "of-the-tests.js"));
const parse = require(path.join(path.resolve(modules), "phaser/src/tilemaps/parsers/tiled/ParseJSONTiled.js"));
const excalibur = load("excalibur"), plugin = load("@excaliburjs/plugin-tiled");
const named = (file, names, given) =>
  new Function(...Object.keys(given), `${fs.readFileSync(file, "utf8")}\nreturn {${names}};`)(...Object.values(given));
const {floorBelow, preload, create} = named(phaserLines, "floorBelow, preload, create", {});
const {TiledResource} = plugin;
const read = async (file, type) => type === "json" ? JSON.parse(fs.readFileSync(file, "utf8")) : "";
let config = {}, opened = "";
class HeadlessResource extends TiledResource {
  constructor() { super(opened, {headless: true, fileLoader: read, layerConfig: config}); }
}
const lines = named(excaliburLines, "load, floorOfLayer, isIce", {...excalibur, TiledResource: HeadlessResource});

const jsType = {bool: "boolean", int: "number", float: "number", string: "string"};
const values = (list) => Object.fromEntries((list || []).map(({name, type, value}) => {
  assert.equal(typeof value, jsType[type], name);
  return [name, value];
}));
const same = (found, expected, what) => assert.deepEqual(JSON.parse(JSON.stringify(found)), expected, what);
const TURNED = 0xe0000000;
const tileOf = (gid) => (gid & ~TURNED) >>> 0;

// Where a point of a tile is after its turn, both relative to the tile's middle.
function turnedByMap(gid, {x, y}) {
  if (gid & 0x20000000) [x, y] = [y, x];
  return {x: gid & 0x80000000 ? -x : x, y: gid & 0x40000000 ? -y : y};
}
function turnedByPhaser({flipX, rotation}, {x, y}) {
  const [along, across] = [Math.round(Math.cos(rotation)), Math.round(Math.sin(rotation))];
  if (flipX) x = -x;
  return {x: along * x - across * y + 0, y: across * x + along * y + 0};
}

// All layers of a kind, with what the groups around them give, as Phaser adds it up.
function layersOf(list, type, around = {name: "", opacity: 1, visible: true, x: 0, y: 0}) {
  return list.flatMap((layer) => {
    const own = {
      name: around.name + layer.name, opacity: around.opacity * layer.opacity, visible: around.visible && layer.visible,
      x: around.x + (layer.offsetx || 0), y: around.y + (layer.offsety || 0)};
    if (layer.type === "group") return layersOf(layer.layers, type, {...own, name: own.name + "/"});
    return layer.type === type ? [{...own, layer}] : [];
  });
}

function checkPhaser(map, parsed) {
  const expected = layersOf(map.layers, "tilelayer");
  same(parsed.layers.map(({name, alpha, visible, x, y}) => ({name, opacity: alpha, visible, x, y})),
    expected.map(({name, opacity, visible, x, y}) => ({name, opacity, visible, x, y})), "layers of tiles");
  const tiles = new Map(map.tilesets[0].tiles.map((tile) => [tile.id + 1, tile]));
  let cells = 0;
  expected.forEach(({layer}, at) => {
    same(values(parsed.layers[at].properties), values(layer.properties), "properties of a layer");
    assert.equal(layer.encoding, undefined, "a small layer is a list");
    layer.data.forEach((gid, i) => {
      const tile = parsed.layers[at].data[Math.floor(i / map.width)][i % map.width];
      assert.equal(tile.index, tileOf(gid) || -1, "a cell");
      if (!gid) return;
      ++cells;
      const corner = {x: 3, y: 1};
      same(turnedByPhaser(tile, corner), turnedByMap(gid, corner), "a turned cell");
      same(tile.properties, values((tiles.get(tileOf(gid)) || {}).properties), "properties of a tile");
    });
  });
  for (const [gid, {id, objectgroup, animation}] of tiles) {
    const found = parsed.tilesets[0];
    if (objectgroup) same(found.getTileCollisionGroup(gid).objects.map(({rectangle, ...object}) => object), objectgroup.objects, "an outline");
    if (animation) same(found.tileData[id].animation.map(({tileid, duration}) => ({tileid, duration})), animation);
  }
  const objects = layersOf(map.layers, "objectgroup");
  assert.deepEqual(parsed.objects.map(({name}) => name), objects.map(({name}) => name), "layers of objects");
  objects.forEach(({layer, x, y}, at) => {
    layer.objects.forEach((object, i) => {
      const {gid, ...found} = parsed.objects[at].objects[i];
      for (const key of ["id", "name", "type", "width", "height", "rotation", "visible"])
        assert.equal(found[key], object[key], key);
      same([found.x, found.y], [object.x + x, object.y + y], "place of an object");
      same(values(found.properties), values(object.properties), "properties of an object");
      same([found.polygon, found.polyline, found.point, found.ellipse, gid],
        [object.polygon, object.polyline, object.point, object.ellipse, object.gid].map((value) => value ?? null));
    });
  });
  const pictures = layersOf(map.layers, "imagelayer");
  assert.deepEqual(parsed.images.map(({image}) => image), pictures.map(({layer}) => layer.image), "layers of pictures");
  return cells;
}

// The lines of the docs make all layers, of a game that answers what Phaser would.
function checkScene(map, parsed) {
  const asked = [], made = [];
  const loader = new Proxy({}, {get: (_, kind) => (...names) => { asked.push([kind, ...names]); return loader; }});
  preload.call({load: loader});
  assert.deepEqual(asked.map(([kind]) => kind), ["image", "tilemapTiledJSON", "json"]);
  create.call({make: {tilemap: ({key}) => {
    assert.equal(key, asked[1][1]);
    return {layers: parsed.layers, addTilesetImage: (name) => name, createLayer: (...all) => made.push(all)};
  }}});
  assert.deepEqual(made, parsed.layers.map(({name}) => [name, map.tilesets[0].name]), "layers that are drawn");
}

// The outlines of all tiles of ground, on the map, from what Phaser has read.
function outlinesOf(parsed) {
  const outlines = [];
  for (const layer of parsed.layers) {
    if (values(layer.properties).ground === false) continue;
    for (const tile of layer.data.flat()) {
      const group = tile.index > 0 && parsed.tilesets[0].getTileCollisionGroup(tile.index);
      const {width, height} = tile;
      for (const {x, y, width: w, height: h, polygon} of group ? group.objects : []) {
        const points = (polygon || [{x: 0, y: 0}, {x: w, y: 0}, {x: w, y: h}, {x: 0, y: h}]).map((p) => {
          const turned = turnedByPhaser(tile, {x: x + p.x - width / 2, y: y + p.y - height / 2});
          return [turned.x + (tile.x + 0.5) * width, turned.y + (tile.y + 0.5) * height];
        });
        outlines.push({points, layer: layer.name, isCeiling: tile.properties.shape_side === "ceiling"});
      }
    }
  }
  return outlines;
}
// Where a vertical line crosses an outline, from top to bottom: every second time it leaves it.
function crossings({points}, x) {
  return points.flatMap(([x0, y0], i) => {
    const [x1, y1] = points[(i + 1) % points.length];
    return (x0 < x) === (x1 < x) ? [] : [y0 + (x - x0) * (y1 - y0) / (x1 - x0)];
  }).sort((a, b) => a - b);
}

// Points in the air, with the first ground below them by the outlines: fewer in a larger map.
function* airPoints(map, outlines) {
  const step = Math.ceil(map.width / 30);
  for (let x = 0.5; x < map.width * map.tilewidth; x += step) {
    const crossed = outlines.map((outline) => ({outline, at: crossings(outline, x)})).filter(({at}) => at.length);
    for (let y = 0.3; y < map.height * map.tileheight; y += step * map.tileheight / 2) {
      if (crossed.some(({at}) => at.filter((one) => one < y).length % 2)) continue;
      let best = {at: Infinity};
      for (const {outline, at} of crossed)
        for (const one of at) if (one >= y && one < best.at) best = {at: one, outline};
      yield {x, y, floor: best.at, outline: best.outline};
    }
  }
}

async function checkExcalibur(map, file) {
  opened = file;
  config = {};
  const layers = map.layers.filter(({type}) => type === "tilelayer");
  for (const {name, properties} of layers) {
    const isGround = values(properties).ground !== false;
    config[name] = {useTileColliders: isGround, useTileCollidersWhenInvisible: isGround};
  }
  const made = await lines.load(new excalibur.Scene());
  assert.deepEqual(made.getTileLayers().map(({name}) => name), layers.map(({name}) => name), "layers of tiles");
  layers.forEach((layer, at) => {
    const found = made.getTileLayers()[at];
    assert.deepEqual(found.data, layer.data, "cells");
    layer.data.forEach((gid, i) => {
      if (!gid) return;
      const {properties} = map.tilesets[0].tiles.find(({id}) => id + 1 === tileOf(gid)) || {};
      const [column, row] = [i % map.width, Math.floor(i / map.width)];
      const tile = made.getTileByCoordinate(layer.name, column, row).tiledTile;
      const [x, y] = [(column + 0.5) * map.tilewidth, (row + 0.5) * map.tileheight];
      assert.equal(lines.isIce(made, layer.name, x, y), values(properties).ice === true, "ice");
      same(tile ? Object.fromEntries(tile.properties) : {},
        Object.fromEntries((properties || []).map(({name, value}) => [name.toLowerCase(), value])), "properties");
    });
    found.tilemap.update(null, 16);  // as the first frame of a game does
  });
  const objects = map.layers.filter(({type}) => type === "objectgroup");
  assert.deepEqual(made.getObjectLayers().map(({name}) => name), objects.map(({name}) => name), "layers of objects");
  objects.forEach((layer, at) => layer.objects.forEach((object, i) => {
    const found = made.getObjectLayers()[at].objects[i];
    const middle = object.ellipse ? 0.5 : 0;  // where Excalibur has an ellipse
    same([found.id, found.name, found.class || "", found.x, found.y], [object.id, object.name, object.type,
      object.x + middle * object.width, object.y + middle * object.height], "an object");
    same(Object.fromEntries(found.properties), values(object.properties), "properties of an object");
  }));
  return made;
}

async function check(file) {
  const map = JSON.parse(fs.readFileSync(file, "utf8"));
  const level = JSON.parse(fs.readFileSync(file.replace(/tmj$/, "json"), "utf8"));
  const parsed = parse("map", map, false);
  const cells = checkPhaser(map, parsed);
  checkScene(map, parsed);
  const made = await checkExcalibur(map, file);
  const near = (found, expected, what) =>
    assert(found === expected || Math.abs(found - expected) < 0.02, `${what}: ${found} instead of ${expected}`);
  let floors = 0, rays = 0;
  for (const {x, y, floor, outline} of airPoints(map, outlinesOf(parsed))) {
    const place = `${file}: below ${x}, ${y}`;
    if (outline && outline.isCeiling) continue;  // whose top is no floor in plain data
    near(floorBelow(level, x, y), floor, `${place} in plain data`);
    ++floors;
    if (map.layers.some(({type}) => type === "group")) continue;
    const names = made.getTileLayers().filter(({name}) => config[name].useTileColliders).map(({name}) => name);
    near(Math.min(...names.map((name) => lines.floorOfLayer(made, name, x, y))), floor, `${place} in Excalibur`);
    ++rays;
  }
  assert(cells > 0 && floors > 0, "nothing was compared");
  return `${path.basename(file)}: ${cells} cells, ${floors} floors, ${rays} rays`;
}

(async () => {
  for (const file of files) console.log(await check(file));
})().catch((problem) => {
  console.log(problem.stack.slice(0, 2000));
  process.exit(1);
});
