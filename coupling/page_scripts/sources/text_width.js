// How wide a text is drawn, and how it is broken where there is less room.

let ruler = null;

/** In pixels, in a font as CSS writes it. */
export function widthOf(text, font) {
    ruler ??= document.createElement("canvas").getContext("2d");
    ruler.font = font;
    return ruler.measureText(text).width;
}

/** The lines of a text that has so much room, broken between words; one word alone is never broken. */
export function inLines(text, room, font) {
    const lines = [];
    for (const word of text.split(" ")) {
        const longer = lines.length > 0 ? `${lines[lines.length - 1]} ${word}` : word;
        if (lines.length > 0 && widthOf(longer, font) <= room) {
            lines[lines.length - 1] = longer;
        } else {
            lines.push(word);
        }
    }
    return lines;
}
