// A large map that shows one of the page's maps at a time: quantity, slope or regime, and year are chosen.

import { choice, element } from "./controls.js";
import { mapLayers } from "./layers.js";
import { text } from "./texts.js";

/** Choices that the layers of a viewer differ in. */
function addViewer(place) {
    const layers = mapLayers().filter(({ figure }) => place.parentElement.contains(figure));
    if (layers.length < 2) {
        return;
    }
    const groups = [...new Set(layers.map(({ group }) => group))];
    let group = groups[0];
    const sheet = element("div", { class: "sheet-of-choice" });
    const names = element("span", { class: "names-of-layers" });
    const show = (layer) => {
        const { figure } = layer;
        const caption = element("b", {}, `${layer.group}: ${layer.name}`);
        const parts = [...figure.querySelectorAll(":scope > svg, :scope > p")].map((part) => part.cloneNode(true));
        sheet.replaceChildren(caption, ...parts);
    };
    const showGroup = () => {
        const here = layers.filter((layer) => layer.group === group);
        names.replaceChildren(choice(text("script.map.layer"), new Map([["", here.map(({ name }, i) => [String(i), name])]]), (i) => show(here[Number(i)])));
        show(here[0]);
    };
    place.append(
        element("div", { class: "switches" },
            choice(text("script.map.of"), new Map([["", groups.map((name) => [name, name])]]), (name) => {
                group = name;
                showGroup();
            }),
            names),
        sheet);
    place.hidden = false;
    showGroup();
}

export function addMapViewers() {
    document.querySelectorAll("figure.map-choice").forEach(addViewer);
}
