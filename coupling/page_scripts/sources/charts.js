// Makes the charts of a page interactive: values under the pointer or the arrow keys, series that can be switched off.
// The drawing that the page came with stays for print and for browsers without scripts.

import { CustomChart, LineChart } from "echarts/charts";
import { GridComponent, TooltipComponent } from "echarts/components";
import * as echarts from "echarts/core";
import { SVGRenderer } from "echarts/renderers";

import { knownPlaces, optionOf } from "./chart_option.js";
import { tipFor } from "./chart_tip.js";
import { addMapViewers } from "./maps.js";
import { sampleOf, whenThemeChanges } from "./style.js";
import { text } from "./texts.js";

echarts.use([CustomChart, LineChart, GridComponent, TooltipComponent, SVGRenderer]);

const live = [];
/** Regimes that are switched off, in all charts at once. */
const hiddenRegimes = new Set();
const isRegime = (name) => /^regime\d+$/.test(name);

class LiveChart {
    constructor(figure, chart) {
        this.figure = figure;
        this.chart = chart;
        this.hidden = new Set();
        this.box = document.createElement("div");
        this.box.className = "live";
        this.area = document.createElement("div");
        this.area.className = "drawn";
        this.area.tabIndex = 0;
        this.area.setAttribute("role", "img");
        this.area.setAttribute("aria-label", text("script.charts.label", { title: chart.title, y: chart.y.title, x: chart.x.title }));
        this.box.append(this.buttons(), this.area);
        figure.querySelector(":scope > svg").after(this.box);
        figure.classList.add("is-live");
        this.drawing = echarts.init(this.area, null, { renderer: "svg" });
        this.area.addEventListener("keydown", (event) => this.step(event));
        new ResizeObserver(() => {
            this.drawing.resize();
            this.draw();
        }).observe(this.area);
        this.draw();
    }

    allHidden() {
        return new Set([...this.hidden, ...hiddenRegimes]);
    }

    draw() {
        const hidden = this.allHidden();
        this.drawing.setOption(optionOf(this.figure, this.area, this.chart, hidden, (x) => tipFor(this.chart, hidden, x)), true);
        this.list.querySelectorAll("button").forEach((button) =>
            button.setAttribute("aria-pressed", String(!hidden.has(button.dataset.of))));
    }

    /** The names of the series as switches. */
    buttons() {
        this.list = document.createElement("ul");
        this.list.className = "names";
        const lines = new Set(this.chart.names.filter(({ sample }) => sample === "line").map(({ of }) => of));
        for (const { of, name, sample } of this.chart.names) {
            const item = document.createElement("li");
            const explainsOnly = sample === "band" && lines.has(of);
            const entry = document.createElement(explainsOnly ? "span" : "button");
            entry.append(sampleOf(of, sample), name);
            if (!explainsOnly) {
                entry.type = "button";
                entry.dataset.of = of;
                entry.title = text(isRegime(of) ? "script.charts.show_in_all" : "script.charts.show");
                entry.addEventListener("click", () => this.toggle(of));
            }
            item.append(entry);
            this.list.append(item);
        }
        return this.list;
    }

    toggle(of) {
        const hidden = isRegime(of) ? hiddenRegimes : this.hidden;
        if (!hidden.delete(of)) {
            hidden.add(of);
        }
        (isRegime(of) ? live : [this]).forEach((chart) => chart.draw());
    }

    /** Moves the pointer to the next or previous known place. */
    step(event) {
        const places = knownPlaces(this.chart).length;
        const moves = { ArrowRight: 1, ArrowLeft: -1, PageUp: 10, PageDown: -10, Home: -places, End: places };
        if (!(event.key in moves)) {
            return;
        }
        event.preventDefault();
        this.place = Math.min(places - 1, Math.max(0, (this.place ?? -1) + moves[event.key]));
        const last = this.drawing.getOption().series.length - 1;
        this.drawing.dispatchAction({ type: "showTip", seriesIndex: last, dataIndex: this.place });
    }
}

function enliven(figure) {
    const data = figure.querySelector(":scope > script.chart-numbers");
    const chart = JSON.parse(data.textContent);
    if (chart.parts.length > 0) {
        // Letters belong to the lines in their order.
        const lines = chart.parts.filter(({ kind }) => kind === "line");
        chart.letters.forEach((letter, i) => { letter.of = lines[i]?.of; });
        live.push(new LiveChart(figure, chart));
    }
}

/** Charts in sight first, the others when there is time. */
function enlivenAll() {
    const figures = [...document.querySelectorAll("figure.chart")].filter((figure) =>
        figure.querySelector(":scope > script.chart-numbers"));
    const next = () => {
        const end = performance.now() + 30;
        while (figures.length > 0 && performance.now() < end) {
            enliven(figures.shift());
        }
        if (figures.length > 0) {
            setTimeout(next, 0);
        } else {
            document.documentElement.dataset.charts = String(live.length);
        }
    };
    next();
}

addMapViewers();
enlivenAll();
whenThemeChanges(() => live.forEach((chart) => chart.draw()));
