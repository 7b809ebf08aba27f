// What a table of nets may hold (coupling/inputs/nets): checked before anything is counted, so that the page refuses what
// `bannwald net try` refuses.

import { sideOf } from "./net_count.js";

const shortest = 0.1; // m
const groundStep = 1; // m: so far apart lie the places that are looked at for ground

/** A line without corners given twice. */
export function withoutDoubles(line) {
    return line.filter(([x, y], i) => i === 0 || x !== line[i - 1][0] || y !== line[i - 1][1]);
}

export function lengthOf(line) {
    let length = 0;
    for (let i = 1; i < line.length; ++i) {
        length += Math.hypot(line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]);
    }
    return length;
}

/** Whether a place lies in a convex area, whose corners go round counter-clockwise. */
export function isInside(area, [x, y]) {
    return area.every(([ax, ay], i) => {
        const [bx, by] = area[(i + 1) % area.length];
        return sideOf(ax, ay, bx, by, x, y) >= 0;
    });
}

function isBetween(a, b, p) {
    return sideOf(...a, ...b, ...p) === 0 && (p[0] - a[0]) * (p[0] - b[0]) + (p[1] - a[1]) * (p[1] - b[1]) <= 0;
}

function touch(a, b, c, d) {
    return (sideOf(...a, ...b, ...c) * sideOf(...a, ...b, ...d) < 0 && sideOf(...c, ...d, ...a) * sideOf(...c, ...d, ...b) < 0) ||
        isBetween(a, b, c) || isBetween(a, b, d) || isBetween(c, d, a) || isBetween(c, d, b);
}

const isSame = (a, b) => a[0] === b[0] && a[1] === b[1];

/** Whether a line crosses, touches or folds back onto itself; it may close. */
export function meetsItself(line) {
    const pieces = line.length - 1;
    const closed = isSame(line[0], line[pieces]);
    for (let i = 0; i < pieces; ++i) {
        for (let j = i + 1; j < pieces; ++j) {
            const nextToIt = j === i + 1 || (closed && i === 0 && j + 1 === pieces);
            if (!nextToIt && touch(line[i], line[i + 1], line[j], line[j + 1])) {
                return true;
            }
            if (j === i + 1 && (isBetween(line[i], line[i + 1], line[j + 1]) || isBetween(line[j], line[j + 1], line[i]))) {
                return true;
            }
        }
    }
    return false;
}

/** The part of the piece c-d beside a-b, no farther than `within`: from and to, in metres from c. */
function partBeside(a, b, c, d, within) {
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    let [first, last] = [0, 1];
    const keepBetween = ([x, y], low, high) => {
        const start = (c[0] - a[0]) * x + (c[1] - a[1]) * y;
        const way = (d[0] - c[0]) * x + (d[1] - c[1]) * y;
        if (way === 0) {
            last = start < low || start > high ? first : last;
            return;
        }
        first = Math.max(first, Math.min((low - start) / way, (high - start) / way));
        last = Math.min(last, Math.max((low - start) / way, (high - start) / way));
    };
    keepBetween(along, 0, length);
    keepBetween([-along[1], along[0]], -within, within);
    const way = Math.hypot(d[0] - c[0], d[1] - c[1]);
    return [first * way, last * way];
}

function sharedLength(line, other, within, least) {
    const parts = [];
    let way = 0;
    for (let j = 1; j < other.length; ++j) {
        for (let i = 1; i < line.length; ++i) {
            const [first, last] = partBeside(line[i - 1], line[i], other[j - 1], other[j], within);
            if (last > first) {
                parts.push([way + first, way + last]);
            }
        }
        way += Math.hypot(other[j][0] - other[j - 1][0], other[j][1] - other[j - 1][1]);
    }
    parts.sort((a, b) => a[0] - b[0]);
    let sum = 0;
    for (let i = 0; i < parts.length;) {
        let [first, last] = parts[i];
        for (++i; i < parts.length && parts[i][0] <= last + 2 * within; ++i) {
            last = Math.max(last, parts[i][1]);
        }
        sum += last - first > least ? last - first : 0;
    }
    return sum;
}

/** Whether two nets stand in one place, wholly or partly. */
export function inOnePlace(line, other) {
    return sharedLength(line, other, 1e-6, 1e-3) > 0 || sharedLength(line, other, 0.01, 0.1) > 0;
}

function isOnGround(line, ground) {
    for (let i = 1; i < line.length; ++i) {
        const [[ax, ay], [bx, by]] = [line[i - 1], line[i]];
        const steps = Math.ceil(Math.hypot(bx - ax, by - ay) / groundStep);
        for (let k = 0; k <= steps; ++k) {
            if (ground.heightAt(ax + (k / steps) * (bx - ax), ay + (k / steps) * (by - ay)) === null) {
                return false;
            }
        }
    }
    return true;
}

/**
 * The key of the text that says what is wrong with the net `number` among all; null where nothing is. "far": the page does
 * not have the paths there, but `bannwald net try` does.
 */
export function wrongWith(data, nets, number) {
    const { line, height_m, gap_m, capacity_kj } = nets[number];
    const relative = (points) => withoutDoubles(points).map(([x, y]) => [x - data.origin[0], y - data.origin[1]]);
    const own = relative(line);
    if (!(height_m > 0 && height_m <= 50)) {
        return "height";
    }
    if (!(gap_m >= 0 && gap_m < height_m)) {
        return "gap";
    }
    if (!(capacity_kj > 0) || !Number.isFinite(capacity_kj)) {
        return "capacity";
    }
    if (own.length < 2 || lengthOf(own) < shortest) {
        return "short";
    }
    if (meetsItself(own)) {
        return "itself";
    }
    if (nets.some((other, i) => i !== number && lengthOf(other.line) > 0 && inOnePlace(relative(other.line), own))) {
        return "one_place";
    }
    if (!own.every((point) => isInside(data.nets[number].area, point))) {
        return "far";
    }
    return isOnGround(own, data.ground) ? null : "ground";
}
