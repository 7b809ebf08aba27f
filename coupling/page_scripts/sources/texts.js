// Texts of the page's language: the keys script.* of coupling/results/text/texts_en.csv and its like, which the page carries.

import { grouped } from "./numbers.js";

let texts = null;

/** A text by its key; `{name}` in it stands for a field. */
export function text(key, fields = {}) {
    texts ??= JSON.parse(document.querySelector("script.page-texts").textContent);
    return texts[key].replace(/\{(\w+)\}/g, (_, name) => fields[name]);
}

/** A whole number as the pages write it. */
export function counted(number) {
    return grouped(String(number));
}
