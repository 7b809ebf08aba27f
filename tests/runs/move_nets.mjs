// Moves the nets of a page as its script would: node move_nets.mjs PAGE FOLDER LINES writes so many tables of nets into the
// folder, 1.csv and so on, as the page saves them, and beside each, 1_figures.csv, what the page shows for it.

import { mkdirSync, readFileSync, writeFileSync } from "node:fs";

import { wrongWith } from "../../coupling/page_scripts/sources/net_checks.js";
import { figuresOf, listOf } from "../../coupling/page_scripts/sources/net_count.js";
import { unpackNets } from "../../coupling/page_scripts/sources/net_data.js";
import { tableOf } from "../../coupling/page_scripts/sources/net_file.js";

const [page, folder, lines] = process.argv.slice(2);
const packed = /<script type="application\/json" class="net-paths">(.*?)<\/script>/s.exec(readFileSync(page, "utf8"))[1];
const data = unpackNets(JSON.parse(packed));

// What the program wrote into the page for the nets where they stand has to come out to the last bit.
figuresOf(data, data.nets).figures.forEach((slopes, net) => slopes.forEach((of, slope) => {
    const expected = data.nets[net].counted[slope];
    listOf(of).forEach((value, i) => {
        if (!Object.is(value, expected[i])) {
            throw new Error(`net ${net}, slope ${slope}, number ${i}: ${value} for ${expected[i]}`);
        }
    });
}));

let state = 12345;
/** An even number from 0 to 1 (Park & Miller 1988). */
function draw() {
    state = (state * 16807) % 2147483647;
    return state / 2147483647;
}
const between = (low, high) => low + (high - low) * draw();
const rounded = (value) => Math.round(100 * value) / 100;

/** Shifted, with bent, new and missing corners, and of another size. */
function moved(net) {
    const shift = [between(-0.8, 0.8) * data.width, between(-0.5, 0.5) * data.width];
    let line = net.line.map(([x, y]) => [rounded(x + shift[0] + between(-6, 6)), rounded(y + shift[1] + between(-6, 6))]);
    if (draw() < 0.5) {
        const at = 1 + Math.floor(draw() * (line.length - 1));
        const middle = [0, 1].map((k) => rounded((line[at - 1][k] + line[at][k]) / 2 + between(-5, 5)));
        line = [...line.slice(0, at), middle, ...line.slice(at)];
    } else if (line.length > 2) {
        line = line.filter((_, i) => i !== 1);
    }
    const height_m = rounded(between(0.4, 4));
    const sold = data.classes.filter(({ mel_kj }) => mel_kj !== null);
    const one = sold[Math.floor(draw() * sold.length)];
    const size = draw() < 0.3 ? { energy_class: one.name, capacity_kj: one.mel_kj } : { energy_class: "", capacity_kj: rounded(Math.exp(between(0, 6))) };
    return { ...net, line, height_m, gap_m: draw() < 0.5 ? 0 : rounded(between(0, 0.9 * height_m)), ...size };
}

function fields(net, slope, of) {
    const design = of.design;
    const quantity = (name, ending, { mean, p50, p90, p95, p99, max }) => ({
        [`${name}_mean_${ending}`]: mean, [`${name}_50_${ending}`]: p50, [`${name}_90_${ending}`]: p90,
        [`${name}_95_${ending}`]: p95, [`${name}_99_${ending}`]: p99, [`${name}_max_${ending}`]: max,
    });
    return {
        net: net.name, cover: data.slopes.length > 1 && slope === 0 ? "forest" : "bare",
        class: net.energy_class, capacity_kj: net.capacity_kj, net_height_m: net.height_m, gap_m: net.gap_m,
        rocks: of.fell, reached: of.reached, inexact_rocks: of.inexact,
        held: of.counts[0], over: of.counts[1], below: of.counts[2], broke: of.counts[3],
        ...quantity("energy", "kj", of.energy), ...quantity("height", "m", of.height),
        percentile_energy_kj: design?.percentileEnergy, design_energy_kj: design?.energy, design_class: design?.energyClass,
        design_capacity_kj: design?.capacity, percentile_height_m: design?.percentileHeight, design_height_m: design?.wantedHeight,
        sold_height_m: design?.sold, design_held: design?.held, design_over: design?.over, design_through: design?.through,
    };
}

mkdirSync(folder, { recursive: true });
let written = 0;
for (let tries = 0; written < Number(lines); ++tries) {
    if (tries > 2000 * Number(lines)) {
        throw new Error(`only ${written} of ${lines} lines are accepted`);
    }
    const nets = data.nets.map(moved);
    if (nets.some((_, number) => wrongWith(data, nets, number) !== null)) {
        continue;
    }
    const { figures, groundless } = figuresOf(data, nets);
    if (groundless) {
        continue;
    }
    ++written;
    const rows = data.slopes.flatMap((_, slope) => nets.map((net, number) => fields(net, slope, figures[number][slope])));
    const text = [Object.keys(rows[0]), ...rows.map((row) => Object.values(row).map((value) => (typeof value === "string" ? `"${value.replaceAll('"', '""')}"` : value ?? "")))].map((row) => row.join(",")).join("\n");
    writeFileSync(`${folder}/${written}.csv`, tableOf(nets));
    writeFileSync(`${folder}/${written}_figures.csv`, `${text}\n`);
}
/** What the page refuses, each for its reason. */
const [[ax, ay], [bx, by]] = data.nets[0].line;
const off = (x, y) => [rounded((ax + bx) / 2 + x), rounded((ay + by) / 2 + y)];
const refused = {
    itself: { line: [off(-5, -5), off(5, 5), off(5, -5), off(-5, 5)] },
    short: { line: [off(0, 0), off(0.05, 0)] },
    ...(data.nets.length > 1 ? { one_place: { line: data.nets.at(-1).line } } : {}),
    height: { height_m: 0 },
    gap: { gap_m: data.nets[0].height_m },
    capacity: { capacity_kj: 0, energy_class: "" },
    ground: { line: [off(0, 0), off(1e5, 0)] },
};
for (const [reason, change] of Object.entries(refused)) {
    const nets = data.nets.map((net, i) => (i === 0 ? { ...net, ...change } : net));
    const found = wrongWith(data, nets, 0);
    // What lies off the ground lies off the area too.
    if (found !== (reason === "ground" ? "far" : reason)) {
        throw new Error(`${reason}: ${found}`);
    }
    writeFileSync(`${folder}/refused_${reason}.csv`, tableOf(nets));
}
console.log(`${written} lines; paths ${data.paths.counts.length}, pieces ${data.paths.kind.length}, width ${data.width} m, one in ${data.every}`);
