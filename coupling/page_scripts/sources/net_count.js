// What stored paths say of nets: the rules of `bannwald net try` (rockfall/obstacles/nets, coupling/assessments/nets/figures),
// step by step and in the same order of operations, so that the numbers are the same to the last bit.

import { gravity, heightOfFlight, isFlight, isSliding } from "./net_data.js";

export const outcomes = ["held", "over", "below", "broke"];
const [held, over, below, broke] = [0, 1, 2, 3];

/** Twice the area of the triangle a, b, p: above 0 where p lies left of the line from a to b. */
export function sideOf(ax, ay, bx, by, px, py) {
    return (bx - ax) * (py - ay) - (by - ay) * (px - ax);
}

/** A net in coordinates of the terrain with the box around it. */
function placed(net, origin) {
    const line = net.line.map(([x, y]) => [x - origin[0], y - origin[1]]);
    const before = [0];
    for (let i = 1; i < line.length; ++i) {
        const [dx, dy] = [line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1]];
        before.push(before[i - 1] + Math.sqrt(dx * dx + dy * dy));
    }
    const xs = line.map(([x]) => x);
    const ys = line.map(([, y]) => y);
    return {
        line, before,
        west: Math.min(...xs), east: Math.max(...xs), south: Math.min(...ys), north: Math.max(...ys),
        height: net.height_m, gap: net.gap_m, capacity: 1000 * net.capacity_kj,
    };
}

/** Where a straight way crosses the lines of nets, in its order. */
function crossingsOf(nets, fromX, fromY, toX, toY, found) {
    found.length = 0;
    const west = fromX < toX ? fromX : toX;
    const east = fromX < toX ? toX : fromX;
    const south = fromY < toY ? fromY : toY;
    const north = fromY < toY ? toY : fromY;
    for (let number = 0; number < nets.length; ++number) {
        const net = nets[number];
        if (east < net.west || west > net.east || north < net.south || south > net.north) {
            continue;
        }
        const { line, before } = net;
        let aside = sideOf(fromX, fromY, toX, toY, line[0][0], line[0][1]);
        for (let i = 1; i < line.length; ++i) {
            const asideBefore = aside;
            aside = sideOf(fromX, fromY, toX, toY, line[i][0], line[i][1]);
            if (asideBefore < 0 === aside < 0) {
                continue;
            }
            const [ax, ay] = line[i - 1];
            const [bx, by] = line[i];
            const start = sideOf(ax, ay, bx, by, fromX, fromY);
            const end = sideOf(ax, ay, bx, by, toX, toY);
            if (start < 0 === end < 0) {
                continue;
            }
            const ofSegment = asideBefore / (asideBefore - aside);
            found.push({ net: number, share: start / (start - end), along: before[i - 1] + ofSegment * (before[i] - before[i - 1]) });
        }
    }
    if (found.length > 1) {
        found.sort((a, b) => a.share - b.share || a.net - b.net || a.along - b.along);
    }
}

function meet(net, body, underside, energy) {
    if (underside + body.radius > net.height) {
        return over;
    }
    if (underside + body.diameter <= net.gap) {
        return below;
    }
    return energy > net.capacity ? broke : held;
}

/** A crossing of a flight: underside above the ground, square of the speed, energy of rotation. */
function onFlight(paths, ground, i, share, body) {
    const time = share * paths.first[i];
    const x = paths.startX[i] + time * paths.velocityX[i];
    const y = paths.startY[i] + time * paths.velocityY[i];
    const z = heightOfFlight(paths.startZ[i], paths.velocityZ[i], time);
    const groundHeight = ground.heightAt(x, y);
    const rising = paths.velocityZ[i] - gravity * time;
    const spin = paths.second[i];
    return {
        x, y,
        underside: groundHeight === null ? NaN : Math.max(0, z - groundHeight),
        squaredSpeed: paths.velocityX[i] * paths.velocityX[i] + paths.velocityY[i] * paths.velocityY[i] + rising * rising,
        rotation: 0.5 * body.inertia * spin * spin,
    };
}

/** The same on the ground. */
function onGround(paths, i, share, body) {
    const squaredSpeed = Math.max(0, paths.first[i] + share * (paths.second[i] - paths.first[i]));
    const own = paths.turnsFirst[i] + share * (paths.turnsSecond[i] - paths.turnsFirst[i]);
    const ofSphere = isSliding(paths.kind[i]) ? 0 : ((0.5 * body.inertia) / (body.radius * body.radius)) * squaredSpeed;
    return {
        x: paths.startX[i] + share * (paths.endX[i] - paths.startX[i]),
        y: paths.startY[i] + share * (paths.endY[i] - paths.startY[i]),
        underside: 0, squaredSpeed, rotation: own >= 0 ? own : ofSphere,
    };
}

/**
 * The rocks at nets: for each net and slope those that cross its line, each as it first does. `inexact`: rocks that broke
 * another net and would cross this line where none stands. `groundless`: a crossing over no ground of the page.
 */
export function countCrossings(data, nets) {
    const { paths, ground } = data;
    const walls = nets.map((net) => placed(net, data.origin));
    const at = walls.map(() => data.slopes.map(() => ({ rocks: [], inexact: 0 })));
    let groundless = false;
    const lines = [];
    const met = new Uint8Array(walls.length);
    let piece = 0;
    for (let path = 0; path < paths.counts.length; ++path) {
        const end = piece + paths.counts[path];
        const cover = paths.covers[path];
        const of = 4 * paths.bodyOf[path];
        const [diameter, radius, mass, inertia] = [paths.bodies[of], paths.bodies[of + 1], paths.bodies[of + 2], paths.bodies[of + 3]];
        const body = { diameter, radius, mass, inertia };
        met.fill(0);
        let [goesOn, isKnown] = [true, true];
        for (let i = piece; i < end && goesOn; ++i) {
            crossingsOf(walls, paths.startX[i], paths.startY[i], paths.endX[i], paths.endY[i], lines);
            for (const line of lines) {
                if (!isKnown) {
                    at[line.net][cover].inexact += met[line.net] ? 0 : 1;
                    met[line.net] = 1;
                    continue;
                }
                const seen = isFlight(paths.kind[i]) ? onFlight(paths, ground, i, line.share, body) : onGround(paths, i, line.share, body);
                groundless ||= Number.isNaN(seen.underside);
                const energy = 0.5 * mass * seen.squaredSpeed + seen.rotation;
                const outcome = meet(walls[line.net], body, seen.underside, energy);
                if (!met[line.net]) {
                    met[line.net] = 1;
                    const centre = Math.fround(seen.underside + radius);
                    at[line.net][cover].rocks.push({
                        outcome, energy: Math.fround(energy) / 1000, centre, top: centre + Math.fround(radius),
                        along: Math.fround(line.along), x: seen.x, y: seen.y,
                    });
                }
                if (outcome === held || outcome === broke) {
                    isKnown = false;
                    goesOn = outcome === broke;
                    if (!goesOn) {
                        break;
                    }
                }
            }
        }
        piece = end;
    }
    return { at, groundless };
}

/** How many of `count` a share is, at least 1; a hair less, so that 0.95 of 100 is 95. */
function rankOf(share, count) {
    return Math.min(count, Math.max(1, Math.ceil(share * count - 1e-9)));
}

const quantile = (sorted, share) => sorted[rankOf(share, sorted.length) - 1];

/** Mean, percentiles and largest of values; null where too few rocks say. */
function quantityOf(values) {
    const sorted = Float64Array.from(values).sort();
    const known = (percentile) => (percentileIsKnown(sorted.length, percentile) ? quantile(sorted, 0.01 * percentile) : null);
    return {
        mean: sorted.length > 0 ? sorted.reduce((sum, value) => sum + value, 0) / sorted.length : null,
        p50: known(50), p90: known(90), p95: known(95), p99: known(99),
        max: sorted.length > 0 ? sorted[sorted.length - 1] : null,
    };
}

/** Whether one rock or more lies above a percentile. */
function percentileIsKnown(count, percentile) {
    return count > 0 && count * (100 - percentile) >= 100;
}

/** How many rocks a design asks for. */
export function rocksToTell(percentile) {
    return Math.ceil(1 / (1 - 0.01 * percentile) - 1e-6);
}

function outcomesOf(rocks, capacity, height) {
    const counted = { held: 0, over: 0, through: 0 };
    for (const { centre, energy } of rocks) {
        ++counted[centre > height ? "over" : energy > capacity ? "through" : "held"];
    }
    return counted;
}

/** The net that rocks ask for (figures/barrier_design.cpp); null from fewer than may pass. */
function designFor(rocks, design, classes) {
    if (rocks.length < rocksToTell(design.percentile)) {
        return null;
    }
    const percentileOf = (of) => quantile(Float64Array.from(rocks, of).sort(), 0.01 * design.percentile);
    const percentileEnergy = percentileOf(({ energy }) => energy);
    const percentileHeight = percentileOf(({ top }) => top);
    const energy = design.energy_factor * percentileEnergy;
    const wantedHeight = design.height_factor * percentileHeight + design.freeboard_m;
    const found = classes.find(({ mel_kj }) => mel_kj === null || energy <= mel_kj);
    const openFrom = Math.max(...classes.map(({ mel_kj }) => mel_kj ?? 0));
    const capacity = found.mel_kj ?? 100 * Math.ceil(energy / 100);
    const sold = design.sold.find((height) => height >= wantedHeight) ?? null;
    const height = sold ?? Math.ceil(wantedHeight * 10) / 10;
    return {
        percentileEnergy, energy, percentileHeight, wantedHeight,
        energyClass: found.name, isOpen: found.mel_kj === null, openFrom, capacity, sold, height,
        ...outcomesOf(rocks, capacity, height),
    };
}

/** The figures of nets: by net and slope, as nets.csv has them. */
export function figuresOf(data, nets) {
    const { at, groundless } = countCrossings(data, nets);
    const figures = at.map((slopes) => slopes.map(({ rocks, inexact }, cover) => {
        const counts = outcomes.map((_, outcome) => rocks.filter((rock) => rock.outcome === outcome).length);
        return {
            fell: data.slopes[cover].rocks, reached: rocks.length, counts, inexact,
            energy: quantityOf(rocks.map(({ energy }) => energy)),
            height: quantityOf(rocks.map(({ top }) => top)),
            design: designFor(rocks, data.design, data.classes),
            rocks,
        };
    }));
    return { figures, groundless };
}

/** Figures as a list of numbers, for comparing them with those that the program wrote into the page. */
export function listOf(of) {
    const design = of.design;
    const known = (value) => value ?? NaN;
    return [
        of.fell, of.reached, ...of.counts, of.inexact,
        ...[of.energy, of.height].flatMap(({ mean, p50, p90, p95, p99, max }) => [mean, p50, p90, p95, p99, max].map(known)),
        ...(design
            ? [design.percentileEnergy, design.energy, design.capacity, design.percentileHeight, design.wantedHeight, design.height, design.held, design.over, design.through]
            : Array(9).fill(NaN)),
    ];
}
