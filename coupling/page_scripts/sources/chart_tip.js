// What a chart says at a place along its x axis.

import { labelAt, rows, threeDigits, tickText } from "./numbers.js";
import { sampleOf } from "./style.js";
import { text } from "./texts.js";

function nearest(all, x) {
    let best = null;
    for (const row of all) {
        if (best === null || Math.abs(row[0] - x) < Math.abs(best[0] - x)) {
            best = row;
        }
    }
    return best;
}

/** The value of a part at x as a text; null where it has none. `reach`: how far off a point may lie. */
function valueAt(part, x, reach) {
    if (part.kind === "steps") {
        const bin = rows(part.numbers, 3).find(([from, to]) => x >= from && x < to);
        return bin ? threeDigits(bin[2]) : null;
    }
    if (part.kind === "bar") {
        const [from, to, low, high] = part.numbers;
        return x >= from && x <= to ? threeDigits(high - low) : null;
    }
    const wide = part.kind === "band" || part.kind === "whiskers";
    const found = nearest(rows(part.numbers, wide ? 3 : 2), x);
    if (found === null || Math.abs(found[0] - x) > reach) {
        return null;
    }
    return wide ? `${threeDigits(found[1])} – ${threeDigits(found[2])}` : threeDigits(found[1]);
}

/** Of areas on top of each other the thickness is what counts. */
function thicknessAt(part, x, reach) {
    const found = nearest(rows(part.numbers, 3), x);
    return found === null || Math.abs(found[0] - x) > reach ? null : threeDigits(found[2] - found[1]);
}

function placeText(chart, x) {
    const steps = chart.parts.find((part) => part.kind === "steps");
    const bin = steps && rows(steps.numbers, 3).find(([from, to]) => x >= from && x < to);
    if (bin && bin[1] - bin[0] === 1 && !Number.isInteger(bin[0])) {
        return `${chart.x.title}: ${tickText(x)}`; // a bar around a whole number
    }
    return bin
        ? `${chart.x.title}: ${text("script.charts.range", { from: threeDigits(bin[0]), to: threeDigits(bin[1]) })}`
        : `${chart.x.title}: ${labelAt(chart.x, x)}`;
}

/** Lines of the tip: sample, name, value. */
function entries(chart, hidden, x) {
    const reach = (chart.x.high - chart.x.low) / 50;
    const lines = [];
    for (const { of, name, sample } of chart.names) {
        if (hidden.has(of)) {
            continue;
        }
        const mine = chart.parts.filter((part) => part.of === of);
        const hasLine = mine.some((part) => part.kind === "line");
        if (sample === "band" && hasLine) {
            continue; // explains the bands of all lines
        }
        const texts = [];
        for (const part of mine) {
            const stacked = part.kind === "band" && !hasLine;
            const shown = stacked ? thicknessAt(part, x, reach) : valueAt(part, x, reach);
            if (shown !== null && !(sample === "dot" && part.kind === "line")) {
                texts.push(part.kind === "band" && hasLine ? `(${shown})` : shown);
            }
        }
        if (texts.length > 0) {
            // A mean before the range around it.
            texts.sort((a, b) => a.startsWith("(") - b.startsWith("("));
            lines.push({ of, sample, name, value: texts.join(" ") });
        }
    }
    return lines;
}

export function tipFor(chart, hidden, x) {
    const box = document.createElement("div");
    box.className = "tip";
    const head = document.createElement("b");
    head.textContent = placeText(chart, x);
    box.append(head);
    for (const { of, sample, name, value } of entries(chart, hidden, x)) {
        const line = document.createElement("div");
        const words = document.createElement("span");
        words.textContent = name;
        const number = document.createElement("b");
        number.textContent = value;
        line.append(sampleOf(of, sample), words, number);
        box.append(line);
    }
    const unit = document.createElement("small");
    unit.textContent = chart.y.title;
    box.append(unit);
    return box;
}
