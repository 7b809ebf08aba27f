// The paths near nets that a page carries (coupling/assessments/nets/moving), unpacked. Numbers keep all their bits: what is
// counted from them is what the program counts.

import { bytes } from "./unpack.js";

/** Acceleration of gravity as config/units/constants.hpp has it. */
const gravity = 9.81;

/** Bits of the kind of a piece (moving/near_paths.cpp). */
const kindOf = { flies: 1, slides: 2, turns: 4, follows: 8, keepsSpeed: 16 };

/** Numbers packed as "f4:" or "f8:" and base64. */
export function floats(text) {
    const raw = bytes(text.slice(3));
    const view = new DataView(raw.buffer);
    const width = text.startsWith("f8:") ? 8 : 4;
    const all = new Float64Array(raw.length / width);
    for (let i = 0; i < all.length; ++i) {
        all[i] = width === 8 ? view.getFloat64(8 * i, true) : view.getFloat32(4 * i, true);
    }
    return all;
}

/** Whole numbers of four bytes. */
export function longs(text) {
    const raw = bytes(text);
    const view = new DataView(raw.buffer);
    return Uint32Array.from({ length: raw.length / 4 }, (_, i) => view.getUint32(4 * i, true));
}

const pairs = (numbers) => Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);

/** Twice the area of the triangle a, b, p: above 0 where p lies left of the way from a to b. */
function side(ax, ay, bx, by, x, y) {
    return (ax - x) * (by - y) - (ay - y) * (bx - x);
}

/** The triangles of the ground near the nets. */
class Ground {
    constructor({ x, y, z, corners }) {
        [this.x, this.y, this.z] = [floats(x), floats(y), floats(z)];
        this.corners = longs(corners);
        this.west = this.x.reduce((a, b) => Math.min(a, b), Infinity);
        this.south = this.y.reduce((a, b) => Math.min(a, b), Infinity);
        const width = this.x.reduce((a, b) => Math.max(a, b), -Infinity) - this.west;
        const height = this.y.reduce((a, b) => Math.max(a, b), -Infinity) - this.south;
        const triangles = this.corners.length / 3;
        this.cell = Math.max(0.1, Math.sqrt((4 * width * height) / Math.max(1, triangles)));
        this.columns = Math.floor(width / this.cell) + 1;
        this.rows = Math.floor(height / this.cell) + 1;
        this.lists = new Map();
        for (let triangle = 0; triangle < triangles; ++triangle) {
            this.enlist(triangle);
        }
    }

    enlist(triangle) {
        const [a, b, c] = this.corners.subarray(3 * triangle, 3 * triangle + 3);
        const column = (x) => Math.floor((x - this.west) / this.cell);
        const row = (y) => Math.floor((y - this.south) / this.cell);
        const [x, y] = [this.x, this.y];
        for (let j = row(Math.min(y[a], y[b], y[c])); j <= row(Math.max(y[a], y[b], y[c])); ++j) {
            for (let i = column(Math.min(x[a], x[b], x[c])); i <= column(Math.max(x[a], x[b], x[c])); ++i) {
                const key = j * this.columns + i;
                if (!this.lists.has(key)) {
                    this.lists.set(key, []);
                }
                this.lists.get(key).push(triangle);
            }
        }
    }

    /** The height of the ground at a place; null where the page has none. */
    heightAt(px, py) {
        const [i, j] = [Math.floor((px - this.west) / this.cell), Math.floor((py - this.south) / this.cell)];
        if (i < 0 || j < 0 || i >= this.columns || j >= this.rows) {
            return null;
        }
        const { x, y, z, corners } = this;
        for (const triangle of this.lists.get(j * this.columns + i) ?? []) {
            const [a, b, c] = [corners[3 * triangle], corners[3 * triangle + 1], corners[3 * triangle + 2]];
            if (side(x[a], y[a], x[b], y[b], px, py) >= 0 && side(x[b], y[b], x[c], y[c], px, py) >= 0 &&
                side(x[c], y[c], x[a], y[a], px, py) >= 0) {
                const [ux, uy, uz] = [x[b] - x[a], y[b] - y[a], z[b] - z[a]];
                const [vx, vy, vz] = [x[c] - x[a], y[c] - y[a], z[c] - z[a]];
                const area2 = ux * vy - uy * vx;
                return z[a] + ((uz * vy - vz * uy) / area2) * (px - x[a]) + ((vz * ux - uz * vx) / area2) * (py - y[a]);
            }
        }
        return null;
    }
}

/** Paths piece by piece in lists of equal length. */
function pathsOf({ covers, bodies, body_of, pieces, kinds, numbers }) {
    const counts = longs(pieces);
    const kind = bytes(kinds);
    const list = () => new Float64Array(kind.length);
    const paths = {
        covers: bytes(covers), bodies: floats(bodies), bodyOf: longs(body_of), counts, kind,
        startX: list(), startY: list(), startZ: list(), // m; z of flights alone
        endX: list(), endY: list(), // m
        velocityX: list(), velocityY: list(), velocityZ: list(), // of a flight, m/s
        first: list(), second: list(), // flight: duration and spin; ground: squares of the speeds at start and end
        turnsFirst: list(), turnsSecond: list(), // energies of rotation at both ends, J; below 0: of a sphere
    };
    const given = floats(numbers);
    let [next, piece] = [0, 0];
    for (const count of counts) {
        let [x, y, speed] = [NaN, NaN, NaN];
        for (const end = piece + count; piece < end; ++piece) {
            const k = kind[piece];
            const flies = k & kindOf.flies;
            if (!(k & kindOf.follows)) {
                x = given[next++];
                y = given[next++];
            }
            paths.startX[piece] = x;
            paths.startY[piece] = y;
            paths.startZ[piece] = flies ? given[next++] : NaN;
            const otherX = given[next++];
            const otherY = given[next++];
            paths.velocityX[piece] = flies ? otherX : NaN;
            paths.velocityY[piece] = flies ? otherY : NaN;
            paths.velocityZ[piece] = flies ? given[next++] : NaN;
            const first = k & kindOf.keepsSpeed ? speed : given[next++];
            const second = given[next++];
            paths.first[piece] = first;
            paths.second[piece] = second;
            paths.turnsFirst[piece] = k & kindOf.turns ? given[next++] : -1;
            paths.turnsSecond[piece] = k & kindOf.turns ? given[next++] : -1;
            x = flies ? x + first * otherX : otherX;
            y = flies ? y + first * otherY : otherY;
            speed = flies ? NaN : second;
            paths.endX[piece] = x;
            paths.endY[piece] = y;
        }
    }
    return paths;
}

/** Height of a flight at a time. */
export function heightOfFlight(start, rising, time) {
    return start + time * (rising - 0.5 * gravity * time);
}

/** What flies and slides among pieces. */
export const isFlight = (kind) => (kind & kindOf.flies) !== 0;
export const isSliding = (kind) => (kind & kindOf.slides) !== 0;
export { gravity };

/** The object that stands in the page, ready to count on. Lines have absolute coordinates, all else those of the terrain. */
export function unpackNets(packed) {
    const numbers = floats(packed.origin);
    return {
        origin: [numbers[0], numbers[1]],
        slopes: packed.slopes, // name and rocks that fell, in the order of the tables
        every: packed.every,
        width: packed.width_m,
        design: { ...packed.design, sold: [...floats(packed.design.sold)] },
        classes: packed.classes, // weakest first; the open one without a level
        nets: packed.nets.map(({ name, energy_class, size, line, area, counted }) => {
            const [height_m, gap_m, capacity_kj] = floats(size);
            return { name, energy_class, height_m, gap_m, capacity_kj, line: pairs(floats(line)), area: pairs(floats(area)), counted: counted.map((one) => [...floats(one)]) };
        }),
        ground: new Ground(packed.ground),
        paths: pathsOf(packed.paths),
    };
}
