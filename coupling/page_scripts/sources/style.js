// Colours and lines come from the page's own style sheet: a drawing by script looks like the drawing it stands for, on
// light and on dark pages.

const svgNamespace = "http://www.w3.org/2000/svg";
let probe = null;

function probeFor(figure) {
    probe ??= document.createElementNS(svgNamespace, "svg");
    probe.setAttribute("class", "definitions");
    figure.append(probe);
    return probe;
}

/** How the page draws an SVG path of these classes inside a figure. */
export function styleOf(figure, classes) {
    const path = document.createElementNS(svgNamespace, "path");
    path.setAttribute("class", classes);
    const holder = probeFor(figure);
    holder.replaceChildren(path);
    const seen = getComputedStyle(path);
    const style = {
        stroke: seen.stroke,
        width: parseFloat(seen.strokeWidth) || 0,
        dash: seen.strokeDasharray === "none" ? null : seen.strokeDasharray.split(/[ ,]+/).map(parseFloat),
        strokeOpacity: parseFloat(seen.strokeOpacity),
        // A pattern is named with the page's address by some browsers.
        fill: seen.fill.replace(/^url\("?[^#"]*(#[^")]*)"?\).*/, "url($1)"),
        fillOpacity: parseFloat(seen.fillOpacity),
    };
    holder.remove();
    return style;
}

/** A custom property of the page, such as "--ink". */
export function pageColour(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** The small picture of a series in a list of names. */
export function sampleOf(series, sample) {
    const svg = document.createElementNS(svgNamespace, "svg");
    svg.setAttribute("viewBox", "0 0 30 14");
    svg.setAttribute("aria-hidden", "true");
    const shape = document.createElementNS(svgNamespace, sample === "dot" ? "circle" : "path");
    shape.setAttribute("class", `${sample} ${series}`);
    if (sample === "dot") {
        shape.setAttribute("cx", "15");
        shape.setAttribute("cy", "7");
        shape.setAttribute("r", "4");
    } else {
        shape.setAttribute("d", sample === "line" ? "M1 7h28" : "M1 2h28v10h-28z");
    }
    svg.append(shape);
    return svg;
}

/** Calls back whenever the page turns dark or light. */
export function whenThemeChanges(callback) {
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", callback);
}
