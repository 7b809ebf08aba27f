// The numbers of a chart as an option of ECharts. Every series is drawn by a shape of our own in the style that the page
// gives its class, so that bands, patterns and dashes are those of the printed drawing.

import { labelAt, rows } from "./numbers.js";
import { pageColour, styleOf } from "./style.js";
import { inLines, widthOf } from "./text_width.js";

const titleSize = 13;
const titleLine = 16;
const smallFont = "11px sans-serif";
const narrowest = { left: 68, right: 30, top: 12, bottom: 54 };

/** What surrounds the drawing: titles that are longer than their axis take more than one line. */
function marginOf(chart, area) {
    const lines = (title, room) => inLines(title, room, `${titleSize}px ${fontOfPage()}`).length;
    const bottom = narrowest.bottom +
                   titleLine * (lines(chart.x.title, area.clientWidth - narrowest.left - narrowest.right) - 1);
    const left = narrowest.left + titleLine * (lines(chart.y.title, area.clientHeight - narrowest.top - bottom) - 1);
    return { ...narrowest, left, bottom };
}

const fontOfPage = () => getComputedStyle(document.body).fontFamily;

function axisOption(axis, isX, room) {
    const ink = pageColour("--ink");
    return {
        type: axis.logarithmic ? "log" : "value",
        min: axis.low,
        max: axis.high,
        name: inLines(axis.title, room, `${titleSize}px ${fontOfPage()}`).join("\n"),
        nameLocation: "middle",
        nameGap: isX ? 30 : 48,
        nameTextStyle: { color: ink, fontSize: titleSize, lineHeight: titleLine },
        axisLine: { show: isX, onZero: false, lineStyle: { color: ink } },
        axisTick: { show: isX, customValues: axis.ticks },
        axisLabel: { color: ink, fontSize: 12, customValues: axis.ticks, formatter: (tick) => labelAt(axis, tick), hideOverlap: true },
        splitLine: { show: !isX, lineStyle: { color: pageColour("--line") } },
        minorTick: { show: false },
        axisPointer: { label: { show: false }, lineStyle: { color: pageColour("--soft") } },
    };
}

/** Lines in style `look`, as ECharts wants them. */
function stroke(look) {
    return {
        stroke: look.stroke,
        lineWidth: look.width,
        lineDash: look.dash ?? "solid",
        strokeOpacity: look.strokeOpacity,
        fill: "none",
    };
}

function filled(look) {
    return {
        fill: look.fill,
        fillOpacity: look.fillOpacity,
        stroke: look.stroke === "none" ? null : look.stroke,
        lineWidth: look.width,
        lineDash: look.dash ?? "solid",
        strokeOpacity: look.strokeOpacity,
    };
}

const polyline = (points, style) => ({ type: "polyline", shape: { points }, style, silent: true });
const polygon = (points, style) => ({ type: "polygon", shape: { points }, style, silent: true });

function stepsOutline(part, at, floor) {
    const bins = rows(part.numbers, 3);
    const points = [at(bins[0][0], floor)];
    for (const [from, to, height] of bins) {
        points.push(at(from, height), at(to, height));
    }
    points.push(at(bins[bins.length - 1][1], floor));
    return points;
}

/** Shapes of a part; `at(x, y)` turns values into pixels. */
const shapes = {
    line: (part, at, look) => [polyline(rows(part.numbers, 2).map(([x, y]) => at(x, y)), stroke(look))],
    steps: (part, at, look, floor) =>
        part.numbers.length ? [polygon(stepsOutline(part, at, floor), filled(look))] : [],
    band: (part, at, look) => {
        const ranges = rows(part.numbers, 3);
        const upper = ranges.map(([x, , high]) => at(x, high));
        const lower = ranges.map(([x, low]) => at(x, low)).reverse();
        return [polygon([...upper, ...lower], filled(look))];
    },
    bar: (part, at, look) => {
        const [from, to, low, high] = part.numbers;
        return [polygon([at(from, low), at(from, high), at(to, high), at(to, low)], filled(look))];
    },
    dots: (part, at, look) =>
        rows(part.numbers, 2).map(([x, y]) => {
            const [cx, cy] = at(x, y);
            return { type: "circle", shape: { cx, cy, r: 4 }, style: filled(look), silent: true };
        }),
    whiskers: (part, at, look) =>
        rows(part.numbers, 3).flatMap(([x, low, high]) => {
            const [px, bottom] = at(x, low);
            const top = at(x, high)[1];
            const cap = (y) => polyline([[px - 3, y], [px + 3, y]], stroke(look));
            return [polyline([[px, bottom], [px, top]], stroke(look)), cap(bottom), cap(top)];
        }),
};

const classOfKind = { line: "line", steps: "area", band: "band", bar: "band", dots: "dot", whiskers: "whiskers" };

/** A series that draws all shapes of `draw(at)`. */
function drawnSeries(chart, draw) {
    return {
        type: "custom",
        coordinateSystem: "cartesian2d",
        silent: true,
        clip: true,
        animation: false,
        data: [[chart.x.low, chart.y.low]],
        renderItem: (_, api) => ({
            type: "group",
            children: draw((x, y) =>
                api.coord([
                    Math.min(Math.max(x, chart.x.low), chart.x.high),
                    Math.min(Math.max(y, chart.y.low), chart.y.high),
                ]),
            ),
        }),
    };
}

function textShape([x, y], text, style) {
    return { type: "text", x, y, style: { text, fill: pageColour("--ink"), ...style }, silent: true };
}

/** A row for each name, sorted from left to right: the first in which it lies over no other. */
function rowsApart(names) {
    const ends = [];
    return names.map(({ from, width }) => {
        let row = ends.findIndex((end) => end <= from);
        row = row < 0 ? ends.length : row;
        ends[row] = from + width + 4;
        return row;
    });
}

function markNames(chart, at) {
    const marks = chart.notes.filter(({ kind }) => kind === "mark").sort((a, b) => a.x - b.x);
    const names = marks.map(({ x, text }) => ({ from: at(x, chart.y.high)[0] + 3, width: widthOf(text, smallFont) }));
    const line = rowsApart(names);
    return marks.map(({ x, text }, i) =>
        textShape([names[i].from, at(x, chart.y.high)[1] + 2 + 13 * line[i]], text,
            { font: smallFont, fill: pageColour("--soft") }));
}

function noteShapes(chart, at) {
    const shapes = markNames(chart, at);
    for (const { kind, x, y, text } of chart.notes) {
        if (kind === "word") {
            const halo = { stroke: pageColour("--paper"), lineWidth: 3.5 };
            shapes.push(textShape(at(x, y), text, { font: "600 13px sans-serif", align: "center", ...halo, verticalAlign: "middle" }));
        } else if (kind === "mark") {
            const look = { stroke: pageColour("--soft"), width: 1, dash: [2, 3], strokeOpacity: 1 };
            shapes.push(polyline([at(x, chart.y.low), at(x, chart.y.high)], stroke(look)));
        } else {
            const [px, py] = at(x, y);
            shapes.push(textShape([px + 4, py - 6], text, { font: smallFont, fill: pageColour("--soft") }));
        }
    }
    return shapes;
}

/** Letters right of the drawing at the ends of their lines, moved apart where they would cover each other. */
function letterShapes(chart, at) {
    const apart = 13;
    const placed = chart.letters
        .map(({ y, text }) => ({ text, place: at(chart.x.high, y) }))
        .sort((a, b) => a.place[1] - b.place[1]);
    for (let i = 1; i < placed.length; ++i) {
        placed[i].place[1] = Math.max(placed[i].place[1], placed[i - 1].place[1] + apart);
    }
    let lowest = at(chart.x.high, chart.y.low)[1];
    for (let i = placed.length - 1; i >= 0; --i) {
        placed[i].place[1] = Math.min(placed[i].place[1], lowest);
        lowest = placed[i].place[1] - apart;
    }
    return placed.map(({ text, place: [x, y] }) =>
        textShape([x + 6, y - 6], text, { font: "700 13px sans-serif" }));
}

/** Every x at which the chart knows something: what the pointer snaps to. */
export function knownPlaces(chart) {
    const places = new Set();
    for (const part of chart.parts) {
        if (part.kind === "steps") {
            rows(part.numbers, 3).forEach(([from, to]) =>
                places.add(chart.x.logarithmic ? Math.sqrt(from * to) : 0.5 * (from + to)));
        } else if (part.kind === "bar") {
            places.add(0.5 * (part.numbers[0] + part.numbers[1]));
        } else {
            rows(part.numbers, part.kind === "band" || part.kind === "whiskers" ? 3 : 2)
                .forEach(([x]) => places.add(x));
        }
    }
    return [...places].filter((x) => x >= chart.x.low && x <= chart.x.high).sort((a, b) => a - b);
}

/** `area`: where it is drawn; `hidden`: classes of series that are switched off; `tip(x)`: HTML of the values at x. */
export function optionOf(figure, area, chart, hidden, tip) {
    const margin = marginOf(chart, area);
    const series = chart.parts
        .filter((part) => !hidden.has(part.of))
        .map((part) => {
            const look = styleOf(figure, `${classOfKind[part.kind]} ${part.of}`);
            return drawnSeries(chart, (at) => shapes[part.kind](part, at, look, chart.y.low));
        });
    const shown = { ...chart, letters: chart.letters.filter(({ of }) => !of || !hidden.has(of)) };
    const writing = drawnSeries(chart, (at) => [...noteShapes(shown, at), ...letterShapes(shown, at)]);
    return {
        animation: false,
        grid: margin,
        textStyle: { fontFamily: fontOfPage() },
        xAxis: axisOption(chart.x, true, area.clientWidth - margin.left - margin.right),
        yAxis: axisOption(chart.y, false, area.clientHeight - margin.top - margin.bottom),
        tooltip: {
            trigger: "axis",
            confine: true,
            transitionDuration: 0,
            backgroundColor: pageColour("--paper"),
            borderColor: pageColour("--line"),
            textStyle: { color: pageColour("--ink"), fontSize: 13 },
            formatter: (items) => tip(items[0].data[0]),
        },
        series: [
            ...series,
            { ...writing, clip: false },
            { // unseen; the pointer needs a line to follow
                type: "line",
                data: knownPlaces(chart).map((x) => [x, chart.y.low]),
                showSymbol: false,
                lineStyle: { opacity: 0 },
                animation: false,
                emphasis: { disabled: true },
            },
        ],
    };
}
