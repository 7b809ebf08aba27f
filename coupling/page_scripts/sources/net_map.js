// A map on which one net can be dragged: its corners, the whole line, new corners; with a pointer, a finger or keys.

import { exact } from "./net_words.js";
import { text } from "./texts.js";

const svgNamespace = "http://www.w3.org/2000/svg";
const handlePixels = 7;
const grabPixels = 16;
const stepMetres = 1;
const longStepMetres = 10;
const mostWays = 150;
const mostDots = 400;

function drawn(tag, attributes, ...children) {
    const made = document.createElementNS(svgNamespace, tag);
    for (const [name, value] of Object.entries(attributes)) {
        made.setAttribute(name, value);
    }
    made.append(...children);
    return made;
}

/** To the centimetre: what is dragged is what is saved. */
const toCentimetres = (value) => Math.round(100 * value) / 100;
const toDecimetres = (value) => Math.round(10 * value) / 10;

export class NetMap {
    /** `changed` is called with the new line after each step. */
    constructor(figure, number, data, changed) {
        [this.number, this.data, this.changed] = [number, data, changed];
        const { west, north, units } = figure.dataset;
        [this.west, this.north, this.units] = [Number(west), Number(north), Number(units)];
        const still = figure.querySelector("svg.cut-out");
        this.svg = still.cloneNode(true);
        this.svg.setAttribute("role", "group");
        this.svg.setAttribute("aria-label", text("script.nets.map", { net: data.nets[number].name }));
        this.svg.classList.add("live-map");
        still.after(this.svg);
        this.layer = drawn("g", { class: "moving" });
        this.svg.append(this.layer);
        this.ways = drawn("path", { class: "way", d: this.waysText() });
        this.others = drawn("path", { class: "other-nets" });
        this.line = drawn("path", { class: "moved-net" });
        this.dots = drawn("g", { class: "meetings" });
        this.grab = drawn("path", { class: "grab", tabindex: "0", role: "button" });
        this.handles = drawn("g", {});
        this.layer.append(this.ways, this.others, this.line, this.dots, this.grab, this.handles);
        this.listen();
        new ResizeObserver(() => this.place()).observe(this.svg);
    }

    onMap([x, y]) {
        return [(x - this.west) * this.units, (this.north - y) * this.units];
    }

    /** Absolute coordinates under a pointer. */
    under(event) {
        const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
        return [this.west + point.x / this.units, this.north - point.y / this.units];
    }

    pathText(line) {
        return line.map((point, i) => (i === 0 ? "M" : "L") + this.onMap(point).map((v) => v.toFixed(2)).join(" ")).join("");
    }

    /** Some of the paths near the net, evenly chosen, on the first slope. */
    waysText() {
        const { paths, origin } = this.data;
        const here = [];
        let piece = 0;
        paths.counts.forEach((count, path) => {
            if (paths.covers[path] === 0) {
                here.push([piece, piece + count]);
            }
            piece += count;
        });
        const every = Math.max(1, Math.ceil(here.length / mostWays));
        const at = (x, y) => this.onMap([x + origin[0], y + origin[1]]).map((v) => v.toFixed(1)).join(" ");
        return here.filter((_, i) => i % every === 0).map(([first, end]) => {
            let words = "";
            for (let i = first; i < end; ++i) {
                words += `M${at(paths.startX[i], paths.startY[i])}L${at(paths.endX[i], paths.endY[i])}`;
            }
            return words;
        }).join("");
    }

    listen() {
        this.svg.addEventListener("pointerdown", (event) => this.take(event));
        this.svg.addEventListener("pointermove", (event) => this.drag(event));
        for (const ending of ["pointerup", "pointercancel"]) {
            this.svg.addEventListener(ending, () => { this.held = null; });
        }
        this.svg.addEventListener("dblclick", (event) => {
            const corner = event.target.dataset?.corner;
            if (corner !== undefined) {
                this.remove(Number(corner));
            }
        });
        this.svg.addEventListener("keydown", (event) => this.press(event));
    }

    take(event) {
        const { corner, between } = event.target.dataset ?? {};
        if (event.button !== 0 || (corner === undefined && between === undefined && event.target !== this.grab)) {
            return;
        }
        event.preventDefault();
        if (between !== undefined) {
            this.insert(Number(between) + 1);
        }
        const index = between !== undefined ? Number(between) + 1 : corner !== undefined ? Number(corner) : null;
        this.held = { index, from: this.under(event), line: this.own };
        (index === null ? this.grab : this.corners[index]).focus({ preventScroll: true });
        this.svg.setPointerCapture(event.pointerId);
    }

    drag(event) {
        if (!this.held) {
            return;
        }
        const place = this.under(event);
        const by = [0, 1].map((k) => toDecimetres(place[k] - this.held.from[k]));
        this.moveBy(this.held.index, by, this.held.line);
    }

    /** Moves a corner, or without an index all of the line. */
    moveBy(index, by, line = this.own) {
        this.changed(line.map((point, i) => (index === null || i === index ? point.map((v, k) => (by[k] === 0 ? v : toCentimetres(v + by[k]))) : point)));
    }

    insert(index) {
        const [a, b] = [this.own[index - 1], this.own[index]];
        const middle = [0, 1].map((k) => toCentimetres((a[k] + b[k]) / 2));
        this.changed([...this.own.slice(0, index), middle, ...this.own.slice(index)]);
    }

    remove(index) {
        if (this.own.length > 2) {
            this.changed(this.own.filter((_, i) => i !== index));
            this.corners[Math.min(index, this.own.length - 1)].focus({ preventScroll: true });
        }
    }

    press(event) {
        const corner = event.target.dataset?.corner;
        const index = corner === undefined ? null : Number(corner);
        if (index === null && event.target !== this.grab) {
            return;
        }
        const step = event.shiftKey ? longStepMetres : stepMetres;
        const way = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] }[event.key];
        if (way) {
            this.moveBy(index, way);
        } else if (event.key === "Delete" && index !== null) {
            this.remove(index);
        } else if (event.key === "+" && index !== null) {
            this.insert(index + 1 < this.own.length ? index + 1 : index);
        } else {
            return;
        }
        event.preventDefault();
    }

    /** Draws all nets; `wrong`: whether the own one is refused. */
    show(nets, wrong) {
        const rebuilt = this.own?.length !== nets[this.number].line.length;
        this.own = nets[this.number].line;
        this.others.setAttribute("d", nets.filter((_, i) => i !== this.number).map(({ line }) => this.pathText(line)).join(""));
        this.layer.classList.toggle("is-wrong", wrong);
        if (rebuilt) {
            this.corners = this.own.map((_, i) => drawn("circle", { class: "corner", "data-corner": i, tabindex: "0", role: "button" }));
            this.betweens = this.own.slice(1).map((_, i) => drawn("circle", { class: "between", "data-between": i }, drawn("title", {}, text("script.nets.add_corner"))));
            this.handles.replaceChildren(...this.betweens, ...this.corners);
        }
        this.place();
    }

    place() {
        const matrix = this.svg.getScreenCTM();
        if (!this.own || !matrix || !(matrix.a > 0)) {
            return;
        }
        const path = this.pathText(this.own);
        this.line.setAttribute("d", path);
        this.grab.setAttribute("d", path);
        this.grab.setAttribute("stroke-width", grabPixels / matrix.a);
        this.grab.setAttribute("aria-label", text("script.nets.whole_line", { net: this.data.nets[this.number].name }));
        const put = (circle, point, pixels) => {
            const [x, y] = this.onMap(point);
            circle.setAttribute("cx", x);
            circle.setAttribute("cy", y);
            circle.setAttribute("r", pixels / matrix.a);
        };
        this.corners.forEach((circle, i) => {
            put(circle, this.own[i], handlePixels);
            circle.setAttribute("aria-label", text("script.nets.corner", { number: i + 1, count: this.own.length, x: exact(this.own[i][0]), y: exact(this.own[i][1]) }));
        });
        this.betweens.forEach((circle, i) => put(circle, [0, 1].map((k) => (this.own[i][k] + this.own[i + 1][k]) / 2), 0.7 * handlePixels));
        this.dots.querySelectorAll("circle").forEach((dot) => dot.setAttribute("r", 2.5 / matrix.a));
    }

    /** Where rocks meet the net on the first slope. */
    showMeetings(rocks) {
        const every = Math.max(1, Math.ceil(rocks.length / mostDots));
        this.dots.replaceChildren(...rocks.filter((_, i) => i % every === 0).map(({ x, y, outcome }) => {
            const [cx, cy] = this.onMap([x + this.data.origin[0], y + this.data.origin[1]]);
            return drawn("circle", { class: `outcome${outcome}`, cx, cy, r: 1 });
        }));
        this.place();
    }
}
