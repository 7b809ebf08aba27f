// Nets that can be dragged on the page: rocks are recounted at every step, what changed is shown, and the nets can be
// saved for `bannwald net try`.

import { element } from "./controls.js";
import { wrongWith } from "./net_checks.js";
import { figuresOf, listOf, rocksToTell } from "./net_count.js";
import { unpackNets } from "./net_data.js";
import { tableOf } from "./net_file.js";
import { NetMap } from "./net_map.js";
import { exact, rowsOf } from "./net_words.js";
import { text } from "./texts.js";

/** Counting that takes longer waits until the hand rests. */
const shortCount = 60; // ms
const rest = 150; // ms

const wordsFor = {
    far: "script.nets.wrong.far",
    ground: "script.nets.wrong.ground",
    itself: "script.nets.wrong.itself",
    one_place: "script.nets.wrong.one_place",
    short: "script.nets.wrong.short",
    height: "script.nets.wrong.height",
    gap: "script.nets.wrong.gap",
    capacity: "script.nets.wrong.capacity",
};

const copyOf = (net) => ({ ...net, line: net.line.map((point) => [...point]) });

/** Words with commands in them, between backquotes. */
function withCommands(words) {
    return words.split("`").map((part, i) => (i % 2 === 1 ? element("code", {}, part) : part));
}

function numberField(label, value, step, changed) {
    const input = element("input", { type: "number", min: "0", step, value, oninput: () => changed(input.value === "" ? NaN : Number(input.value)) });
    return { input, label: element("label", {}, `${label} `, input) };
}

class MovingNets {
    constructor(section, data) {
        [this.section, this.data] = [section, data];
        this.nets = data.nets.map(copyOf);
        section.querySelector(".unmoved").remove();
        const { figures } = figuresOf(data, this.nets);
        this.before = figures;
        if (!this.agrees()) {
            section.prepend(element("p", { class: "alert", role: "alert" }, ...withCommands(text("script.nets.disagrees"))));
            return;
        }
        section.classList.add("is-live");
        this.now = figures;
        this.needed = rocksToTell(data.design.percentile);
        this.cards = [...section.querySelectorAll("figure.net-move")].map((figure) => this.card(figure, Number(figure.dataset.net)));
        section.querySelector(".net-maps").before(element("p", { class: "screen-only soft" }, text("script.nets.how")));
        this.save = element("button", { type: "button", onclick: () => this.download() }, text("script.nets.save"));
        this.said = element("span", { role: "status", class: "soft" });
        section.append(element("p", { class: "screen-only save-nets" }, this.save, " ", this.said));
        this.show();
        document.documentElement.dataset.nets = String(this.nets.length);
    }

    /** Whether the script comes to the numbers that the program wrote into the page. */
    agrees() {
        return this.before.every((slopes, net) => slopes.every((of, slope) => {
            const expected = this.data.nets[net].counted[slope];
            const list = listOf(of);
            return list.length === expected.length && list.every((value, i) => Object.is(value, expected[i]));
        }));
    }

    card(figure, number) {
        const net = this.nets[number];
        const set = (change) => this.change(number, change);
        const height = numberField(text("script.nets.height"), net.height_m, "0.1", (height_m) => set({ height_m }));
        const gap = numberField(text("script.nets.gap"), net.gap_m, "0.1", (gap_m) => set({ gap_m }));
        const capacity = numberField(text("script.nets.capacity"), net.capacity_kj, "any", (capacity_kj) => set({ capacity_kj, energy_class: "" }));
        const sold = this.data.classes.filter(({ mel_kj }) => mel_kj !== null);
        const classes = element("select", {
            onchange: () => {
                const found = sold.find(({ name }) => name === classes.value);
                set({ energy_class: classes.value, capacity_kj: found ? found.mel_kj : this.nets[number].capacity_kj });
            },
        }, element("option", { value: "" }, text("script.nets.by_capacity")), ...sold.map(({ name, mel_kj }) => element("option", { value: name }, `${name} (${exact(mel_kj)} kJ)`)));
        const back = element("button", { type: "button", onclick: () => this.change(number, copyOf(this.data.nets[number])) }, text("script.nets.back"));
        const wrong = element("p", { class: "alert", role: "alert", hidden: true });
        const table = element("div", { class: "wide" });
        const side = element("div", { class: "net-side" },
            element("div", { class: "net-fields" }, height.label, gap.label, element("label", {}, `${text("script.nets.class")} `, classes), capacity.label, back),
            wrong, table);
        figure.append(side);
        const map = new NetMap(figure, number, this.data, (line) => set({ line }));
        return { figure, map, wrong, table, back, fields: { height_m: height.input, gap_m: gap.input, capacity_kj: capacity.input }, classes };
    }

    change(number, change) {
        Object.assign(this.nets[number], change);
        this.said.textContent = "";
        this.show();
    }

    show() {
        this.wrong = this.nets.map((_, number) => wrongWith(this.data, this.nets, number));
        const isRefused = this.wrong.some((wrong) => wrong !== null);
        this.cards.forEach(({ map, wrong, fields, classes, back }, number) => {
            const net = this.nets[number];
            map.show(this.nets, this.wrong[number] !== null);
            wrong.hidden = this.wrong[number] === null;
            wrong.replaceChildren(...(this.wrong[number] === null ? [] : withCommands(text(wordsFor[this.wrong[number]]))));
            for (const [name, input] of Object.entries(fields)) {
                if (input !== document.activeElement && Number(input.value) !== net[name]) {
                    input.value = Number.isNaN(net[name]) ? "" : net[name];
                }
            }
            classes.value = net.energy_class;
            back.disabled = JSON.stringify(copyOf(net)) === JSON.stringify(copyOf(this.data.nets[number]));
        });
        // Beyond the area `net try` knows more than this page: such nets can be saved, others that are refused cannot.
        this.save.disabled = this.wrong.some((wrong) => wrong !== null && wrong !== "far");
        clearTimeout(this.timer);
        this.section.classList.remove("is-stale");
        if (isRefused) {
            this.now = null;
            this.showTables();
        } else if ((this.took ?? 0) < shortCount) {
            this.count();
        } else {
            this.section.classList.add("is-stale");
            this.timer = setTimeout(() => this.count(), rest);
        }
    }

    count() {
        const start = performance.now();
        const { figures, groundless } = figuresOf(this.data, this.nets);
        this.took = performance.now() - start;
        this.now = groundless ? null : figures;
        this.section.classList.remove("is-stale");
        this.showTables();
        if (groundless) {
            this.cards.forEach(({ wrong }) => {
                wrong.hidden = false;
                wrong.textContent = text(wordsFor.ground);
            });
        }
    }

    showTables() {
        const all = [this.before, ...(this.now ? [this.now] : [])].flat(2);
        const rows = rowsOf(this.data.design.percentile, this.needed, all.some(({ inexact }) => inexact > 0));
        this.cards.forEach(({ map, table }, number) => {
            const slopes = this.data.slopes;
            const heads = slopes.map(({ name }) => element("th", { scope: "colgroup", colspan: "2" }, name));
            const times = slopes.flatMap(() => [element("th", { scope: "col" }, text("script.nets.before")), element("th", { scope: "col" }, text("script.nets.now"))]);
            const body = rows.map(([name, words]) => {
                if (!words) {
                    return element("tr", { class: "group" }, element("th", { colspan: String(1 + 2 * slopes.length) }, name));
                }
                const cells = slopes.flatMap((_, slope) => {
                    const before = words(this.before[number][slope]);
                    const now = this.now ? words(this.now[number][slope]) : "–";
                    return [element("td", {}, before), element("td", { class: this.now && now !== before ? "now is-new" : "now" }, now)];
                });
                return element("tr", {}, element("td", {}, name), ...cells);
            });
            table.replaceChildren(element("table", {},
                element("thead", {}, element("tr", {}, element("td", { rowspan: "2" }), ...heads), element("tr", {}, ...times)),
                element("tbody", {}, ...body)));
            map.showMeetings(this.now ? this.now[number][0].rocks : []);
        });
    }

    download() {
        const address = URL.createObjectURL(new Blob([tableOf(this.nets)], { type: "text/csv" }));
        element("a", { href: address, download: "nets.csv" }).click();
        setTimeout(() => URL.revokeObjectURL(address), 0);
        this.said.replaceChildren(...withCommands(text("script.nets.saved")));
    }
}

document.querySelectorAll("section.moving-nets").forEach((section) => {
    new MovingNets(section, unpackNets(JSON.parse(section.querySelector("script.net-paths").textContent)));
});
