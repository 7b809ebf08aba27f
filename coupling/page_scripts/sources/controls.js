// Small parts of the page around the view: switches, lists, legends.

import { mapLayers } from "./layers.js";
import { text } from "./texts.js";

export function element(tag, attributes = {}, ...children) {
    const made = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
        if (name.startsWith("on")) {
            made.addEventListener(name.slice(2), value);
        } else if (value !== false && value !== null) {
            made.setAttribute(name, value === true ? "" : value);
        }
    }
    made.append(...children);
    return made;
}

export function checkbox(words, checked, changed) {
    const box = element("input", { type: "checkbox", checked, onchange: () => changed(box.checked) });
    return element("label", {}, box, ` ${words}`);
}

/** A list to choose from; `groups`: Map of a heading (empty for none) to [value, text] pairs. */
export function choice(label, groups, changed) {
    const select = element("select", { onchange: () => changed(select.value) });
    for (const [heading, options] of groups) {
        const items = options.map(([value, words]) => element("option", { value }, words));
        select.append(...(heading ? [element("optgroup", { label: heading }, ...items)] : items));
    }
    return element("label", {}, `${label} `, select);
}

export function button(words, pressed) {
    return element("button", { type: "button", onclick: pressed }, words);
}

/** Maps that can be laid over the ground. */
export function layerChoice(changed) {
    const layers = mapLayers();
    if (layers.length === 0) {
        return null;
    }
    const groups = new Map([["", [["", text("script.map.none")]]]]);
    layers.forEach((layer, i) => {
        groups.set(layer.group, [...(groups.get(layer.group) ?? []), [String(i), `${layer.group}: ${layer.name}`]]);
    });
    return choice(text("script.map.on_the_ground"), groups, (value) => changed(value === "" ? null : layers[Number(value)]));
}

const hex = (colour) => (typeof colour === "string" ? colour : `#${colour.toString(16).padStart(6, "0")}`);

/** A legend entry: "line", "cone", "round", "stem" or "dot". */
export function sample(kind, colour, words, width = 2) {
    const shapes = {
        line: `<path d="M1 7h28" stroke="${hex(colour)}" stroke-width="${width}"/>`,
        cone: `<path d="M7 13.5L15 .5L23 13.5z" fill="${hex(colour)}" stroke="#222" stroke-width=".5"/>`,
        round: `<ellipse cx="15" cy="7" rx="9" ry="6.3" fill="${hex(colour)}" stroke="#222" stroke-width=".5"/>`,
        stem: `<path d="M13 13.5V1h4v12.5z" fill="${hex(colour)}"/>`,
        end: `<path d="M13 13.5V5h4v8.500z" fill="#8c8c8c"/><ellipse cx="15" cy="5" rx="4" ry="2" fill="${hex(colour)}"/>`,
        dot: `<path d="M15 2l5 5-5 5-5-5z" fill="${hex(colour)}" stroke="#222" stroke-width=".6"/>`,
    };
    const picture = element("span");
    picture.innerHTML = `<svg viewBox="0 0 30 14" aria-hidden="true" fill="none">${shapes[kind]}</svg>`;
    return element("li", {}, picture.firstChild, words);
}
