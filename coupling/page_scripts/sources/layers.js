// The maps of the page: figures with a picture of values over the hillshade, grouped by what they show.

/** { group, name, figure, address, aspect, wide, high } of every map of values; `wide`, `high`: how far blocks of cells
 * reach over the map. */
export function mapLayers() {
    const layers = [];
    for (const figure of document.querySelectorAll("figure.map[data-group]")) {
        const image = figure.querySelector("svg.sheet image.values");
        const neat = figure.querySelector("svg.sheet rect.neat");
        if (image === null || neat === null) {
            continue;
        }
        const number = (element, name) => parseFloat(element.getAttribute(name));
        layers.push({
            group: figure.dataset.group,
            name: figure.dataset.layer,
            figure,
            address: image.getAttribute("href"),
            aspect: number(neat, "height") / number(neat, "width"),
            wide: number(image, "width") / number(neat, "width"),
            high: number(image, "height") / number(neat, "height"),
        });
    }
    return layers;
}
