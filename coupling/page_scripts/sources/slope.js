// The slope in three dimensions: ground with a map on it, trees of a regime and year, paths by energy, targets.

import { AmbientLight, DirectionalLight, Scene, WebGLRenderer } from "three";

import { blocksOf, enlargements } from "./blocks.js";
import { Eye } from "./camera.js";
import { button, checkbox, choice, element, layerChoice, sample } from "./controls.js";
import { Falling } from "./falling.js";
import { Ground } from "./ground.js";
import { classLooks, drop, logColour, logsOf, pathsOf, restColour, targetColour, targetsOf } from "./lines.js";
import { Mass, speedColours } from "./mass.js";
import { grouped } from "./numbers.js";
import { counted, text } from "./texts.js";
import { fell, grow } from "./trees.js";

/** What is left out of a stand, as a sentence; empty if nothing. */
function drawnOf(drawn, all, key) {
    return drawn < all ? text(key, { drawn: counted(drawn), all: counted(all) }) : "";
}

const coverNames = { forest: "script.slope.paths_with_forest", bare: "script.slope.paths_bare" };

class SlopeView {
    constructor(figure, numbers, renderer) {
        this.numbers = numbers;
        this.renderer = renderer;
        this.canvas = renderer.domElement;
        this.ground = new Ground(numbers);
        this.scene = new Scene();
        this.lights();
        this.scene.add(this.ground.mesh());
        this.paths = {};
        this.shown = {};
        this.ofYear = [];
        this.logs = [];
        this.eye = new Eye(this.canvas, this.ground, () => this.ask());
        this.legend = element("ul", { class: "names" });
        this.note = element("p", { class: "soft", "aria-live": "polite" });
        this.mapLegend = element("div", { class: "map-legend" });
        this.build(figure);
        if (numbers.picture) {
            this.ground.drape(null, () => this.ask());
        }
        this.plant(0);
        this.eye.reset();
        // At once, not before the next frame: a browser that shows nothing (printing, no window) may never make one.
        this.draw();
    }

    lights() {
        // From the north-west as on the maps, and enough from the sky that nothing is black.
        const sun = new DirectionalLight(0xffffff, 2.3);
        sun.position.set(-1, 1.4, -1);
        this.scene.add(sun, new AmbientLight(0xffffff, 1.25));
    }

    build(figure) {
        this.canvas.tabIndex = 0;
        this.canvas.setAttribute("role", "img");
        this.canvas.setAttribute("aria-label", text("script.slope.label"));
        this.compass = element("div", { class: "compass", "aria-hidden": "true" });
        this.compass.innerHTML = '<svg viewBox="-20 -20 40 40"><path d="M0-15L6 12 0 7-6 12z" fill="#1d2528"/></svg><b>' + text("script.slope.north") + '</b>';
        this.scale = element("div", { class: "scale" });
        const stage = element("div", { class: "stage" }, this.canvas, this.compass, this.scale);
        const view = element("div", { class: "live" }, this.switches(), stage, this.legend, this.mapLegend, this.note,
            element("p", { class: "soft" }, text("script.slope.how_to_move")));
        figure.querySelector(".instead").replaceWith(view);
        figure.classList.add("is-live");
        new ResizeObserver(() => this.resize(stage.clientWidth)).observe(stage);
        this.resize(stage.clientWidth);
    }

    switches() {
        const bar = element("div", { class: "switches" });
        const layers = layerChoice((layer) => this.drape(layer));
        bar.append(...[layers, ...this.standSwitches()].filter((part) => part !== null));
        for (const cover of Object.keys(coverNames)) {
            if (this.numbers.paths.some((path) => path.cover === cover)) {
                const { lines, rests } = pathsOf(this.numbers, this.ground, this.numbers.paths.filter((path) => path.cover === cover));
                const shown = cover === "forest" || !this.numbers.paths.some((path) => path.cover === "forest");
                this.paths[cover] = lines;
                this.scene.add(lines, rests);
                lines.visible = rests.visible = shown;
                this.shown[cover] = shown;
                bar.append(checkbox(text(coverNames[cover]), shown, (on) => {
                    lines.visible = rests.visible = on;
                    this.shown[cover] = on;
                    this.fallAgain();
                    this.ask();
                }));
            }
        }
        bar.append(...this.blockSwitch(), ...this.massSlider(), ...this.fallSlider());
        if (this.numbers.targets.length > 0) {
            const targets = targetsOf(this.numbers, this.ground);
            this.scene.add(targets);
            bar.append(checkbox(text("script.slope.targets"), true, (on) => {
                targets.visible = on;
                this.ask();
            }));
        }
        bar.append(button(text("script.slope.reset"), () => this.eye.reset()), button(text("script.slope.from_above"), () => this.eye.fromAbove()));
        return bar;
    }

    /** How large blocks are drawn, where rocks have a shape. */
    blockSwitch() {
        if (!this.numbers.paths.some((path) => path.shape)) {
            return [];
        }
        // At first so large that they can be seen beside the whole slope.
        const largest = Math.max(...this.numbers.paths.map((path) => (path.shape ? path.diameter_m : 0)));
        this.times = enlargements.find((times) => times * largest >= 0.006 * this.ground.extent) ?? enlargements.at(-1);
        this.roll();
        const options = enlargements.map((times) => [String(times), times === 1 ? text("script.slope.blocks_as_they_are") : text("script.slope.blocks_enlarged", { times })]);
        const list = choice(text("script.slope.blocks"), new Map([["", [...options, ["0", text("script.slope.blocks_hidden")]]]]), (value) => {
            this.times = Number(value);
            this.fallAgain();
            this.ask();
        });
        list.querySelector("select").value = String(this.times);
        return [list];
    }

    /** Through the times of a rock mass. */
    massSlider() {
        if (!this.numbers.mass) {
            return [];
        }
        const { times_s } = this.numbers.mass;
        const mass = new Mass(this.numbers, this.ground);
        this.scene.add(mass.mesh);
        const word = element("output", {});
        const slider = element("input", { type: "range", min: 0, max: times_s.length - 1, step: 1, value: 0, "aria-label": text("script.slope.time_label"),
            oninput: () => show(Number(slider.value)) });
        const show = (frame) => {
            mass.show(frame);
            word.textContent = text("script.slope.after", { time: grouped(times_s[frame].toFixed(1)) });
            this.ask();
        };
        show(0);
        return [element("label", { class: "years" }, text("script.slope.rock_mass"), " ", word, " ", slider)];
    }

    /** What is shown has changed. */
    fallAgain() {
        if (this.fallen === undefined) {
            this.roll();
        } else {
            this.fallTo(this.fallen);
        }
    }

    /** Through the falls of the drawn paths: all rocks begin at once. */
    fallSlider() {
        if (!this.numbers.paths.some((path) => path.times)) {
            return [];
        }
        const falling = new Falling(this.numbers, this.ground);
        const steps = 400;
        const word = element("output", {});
        const slider = element("input", { type: "range", min: 0, max: steps, step: 1, value: 0, "aria-label": text("script.slope.time_label"),
            oninput: () => this.fallTo(Number(slider.value)) });
        this.fallTo = (step) => {
            this.fallen = step;
            const time_s = (step / steps) * falling.end;
            if (!falling.group.parent) {
                this.scene.add(falling.group);
            }
            falling.show(time_s, this.shown, this.times || 1);
            word.textContent = text("script.slope.after", { time: grouped(time_s.toFixed(1)) });
            this.roll();
            this.ask();
        };
        word.textContent = text("script.slope.after", { time: grouped((0).toFixed(1)) });
        return [element("label", { class: "years" }, text("script.slope.falling"), " ", word, " ", slider)];
    }

    /** Puts the blocks along the paths that are shown; while rocks fall each is drawn once. */
    roll() {
        if (this.times === undefined) {
            return;
        }
        if (this.blocks) {
            this.scene.remove(this.blocks);
            drop(this.blocks);
            this.blocks = null;
        }
        if (this.times > 0 && this.fallen === undefined) {
            this.blocks = blocksOf(this.numbers, this.ground, this.numbers.paths.filter((path) => this.shown[path.cover]), this.times);
            this.scene.add(this.blocks);
        }
    }

    /** Regime and year of the trees. */
    standSwitches() {
        const { stands } = this.numbers;
        if (stands.length === 0) {
            return [];
        }
        const regimes = [...new Set(stands.map((stand) => stand.regime))];
        const years = [...new Set(stands.map((stand) => stand.year))].sort((a, b) => a - b);
        let [regime, year] = [regimes[0], 0];
        const word = element("output", {}, text("script.slope.year", { year: years[0] }));
        const plant = () => {
            word.textContent = years[year] === 0 ? text("script.slope.start") : text("script.slope.year", { year: years[year] });
            this.plant(stands.findIndex((stand) => stand.regime === regime && stand.year === years[year]));
        };
        const parts = [checkbox(text("script.slope.trees"), true, (on) => {
            this.treesHidden = !on;
            this.trees && (this.trees.visible = on);
            this.logs.forEach((part) => (part.visible = on));
            this.ask();
        })];
        if (regimes.length > 1) {
            parts.push(choice(text("script.slope.regime"), new Map([["", regimes.map((name) => [name, name])]]), (name) => {
                regime = name;
                plant();
            }));
        }
        if (stands.some((stand) => stand.paths?.length > 0)) {
            parts.push(checkbox(text("script.slope.paths_of_the_year"), true, (on) => {
                this.pathsHidden = !on;
                this.ofYear.forEach((part) => (part.visible = on));
                this.ask();
            }));
        }
        if (years.length > 1) {
            const slider = element("input", { type: "range", min: 0, max: years.length - 1, step: 1, value: 0, "aria-label": text("script.slope.year_label"),
                oninput: () => {
                    year = Number(slider.value);
                    plant();
                } });
            word.textContent = text("script.slope.start");
            parts.push(element("label", { class: "years" }, text("script.slope.trees_of"), " ", word, " ", slider));
        }
        return parts;
    }

    plant(index) {
        if (this.trees) {
            this.scene.remove(this.trees);
            fell(this.trees);
            this.trees = null;
        }
        [...this.ofYear, ...this.logs].forEach((part) => this.scene.remove(part));
        drop(...this.ofYear, ...this.logs);
        this.ofYear = [];
        this.logs = [];
        const chosen = this.numbers.stands[index];
        const stand = chosen?.same_as === undefined ? chosen : this.numbers.stands[chosen.same_as];
        let seen = { species: new Set(), dead: false, broken: false };
        if (stand) {
            const grown = grow(this.numbers, this.ground, stand);
            this.trees = grown.group;
            this.trees.visible = !this.treesHidden;
            this.scene.add(this.trees);
            seen = { ...grown.seen, paths: stand.paths.length > 0 };
            if (seen.paths) {
                const { lines, rests } = pathsOf(this.numbers, this.ground, stand.paths);
                this.ofYear = [lines, rests];
                this.ofYear.forEach((part) => (part.visible = !this.pathsHidden));
            }
            const logs = logsOf(this.numbers, this.ground, stand);
            if (logs !== null) {
                logs.visible = !this.treesHidden;
                this.logs = [logs];
                seen.logs = true;
            }
            [...this.ofYear, ...this.logs].forEach((part) => this.scene.add(part));
            this.note.textContent = [
                stand.left_out > 0
                    ? text("script.slope.trees_drawn", { drawn: counted(stand.trees), left_out: counted(stand.left_out) })
                    : text("script.slope.all_trees_drawn", { drawn: counted(stand.trees) }),
                drawnOf(stand.drawn_logs, stand.all_logs, "script.slope.logs_drawn"),
                drawnOf(stand.paths.length, stand.all_paths, "script.slope.paths_drawn"),
            ].filter((sentence) => sentence !== "").join(" ");
        }
        this.explain(seen);
        this.ask();
    }

    explain(seen) {
        const entries = [...seen.species].sort((a, b) => a - b).map((s) => {
            const species = this.numbers.species[s];
            return sample(species.conifer ? "cone" : "round", species.colour, species.name);
        });
        if (seen.dead) {
            entries.push(sample("stem", 0x8c8c8c, text("script.slope.dead_tree")));
        }
        if (seen.broken) {
            entries.push(sample("end", 0xf2e2b8, text("script.slope.broken_tree")));
        }
        if (seen.logs) {
            entries.push(sample("line", logColour, text("script.slope.lying_stem"), 2.2));
        }
        if (seen.paths || this.numbers.paths.length > 0) {
            this.numbers.classes.forEach((name, k) =>
                entries.push(sample("line", classLooks[k].colour, text("script.slope.path", { energy: name }), 1.4 * classLooks[k].width)));
            entries.push(sample("dot", restColour, text("script.slope.path_end")));
        }
        if (this.numbers.mass) {
            const { bounds_mps, blocks, all_blocks } = this.numbers.mass;
            speedColours.forEach((colour, k) => entries.push(sample("stem", colour, k < bounds_mps.length
                ? text("script.slope.slower", { speed: bounds_mps[k] })
                : text("script.slope.faster", { speed: bounds_mps.at(-1) }))));
            this.note.textContent = drawnOf(blocks.length, all_blocks, "script.slope.mass_drawn");
        }
        this.numbers.targets.forEach(({ name }) => entries.push(sample("line", targetColour, name, 4)));
        this.legend.replaceChildren(...entries);
    }

    drape(layer) {
        const legend = layer?.figure.querySelector("svg.legend");
        this.mapLegend.replaceChildren(...(legend ? [element("b", {}, `${layer.group}, ${layer.name}`), legend.cloneNode(true)] : []));
        this.ground.drape(layer, () => this.ask());
    }

    resize(width) {
        const height = Math.round(Math.min(0.62 * width, 640));
        if (width > 0 && (width !== this.width || height !== this.height)) {
            [this.width, this.height] = [width, height];
            this.renderer.setSize(width, height);
            this.eye.camera.aspect = width / height;
            this.eye.camera.updateProjectionMatrix();
            this.ask();
        }
    }

    /** Draws once before the next frame, however often it is asked. */
    ask() {
        if (!this.asked) {
            this.asked = true;
            requestAnimationFrame(() => {
                this.asked = false;
                this.draw();
            });
        }
    }

    draw() {
        this.renderer.render(this.scene, this.eye.camera);
        this.compass.firstChild.style.transform = `rotate(${this.eye.azimuth}rad)`;
        const perPixel = this.eye.metresAPixel(this.height);
        const exponent = Math.floor(Math.log10(120 * perPixel));
        const length = [5, 2, 1].map((n) => n * 10 ** exponent).find((metres) => metres <= 120 * perPixel);
        this.scale.style.width = `${length / perPixel}px`;
        this.scale.textContent = `${length} m`;
        document.documentElement.dataset.slope = "drawn";
    }
}

function rendererOrNull() {
    try {
        const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
        renderer.setPixelRatio(Math.min(2, devicePixelRatio));
        renderer.setClearColor(0xdfe7ea);
        return renderer;
    } catch {
        return null;
    }
}

/** Whether this browser has WebGL; asked before three.js does, which would complain on the console. */
function hasWebGl() {
    return Boolean(document.createElement("canvas").getContext("webgl2"));
}

function show(figure) {
    const renderer = hasWebGl() ? rendererOrNull() : null;
    if (renderer === null) {
        figure.querySelector(".instead").prepend(text("script.slope.no_webgl"), " ");
        document.documentElement.dataset.slope = "no WebGL";
        return;
    }
    const numbers = JSON.parse(figure.querySelector("script.scene-numbers").textContent);
    new SlopeView(figure, numbers, renderer);
}

// A view takes a second and much memory: only when a reader comes near.
const watcher = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
        if (isIntersecting) {
            watcher.unobserve(target);
            show(target);
        }
    }
}, { rootMargin: "400px" });
document.querySelectorAll("figure.scene").forEach((figure) => watcher.observe(figure));
