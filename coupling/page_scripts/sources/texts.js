// Texts of the page's language: the keys script.* of coupling/results/report/texts_en.csv, which the page carries.

let texts = null;

/** A text by its key; `{name}` in it stands for a field. */
export function text(key, fields = {}) {
    texts ??= JSON.parse(document.querySelector("script.page-texts").textContent);
    return texts[key].replace(/\{(\w+)\}/g, (_, name) => fields[name]);
}

/** A whole number as the page's language writes it. */
export function counted(number) {
    return number.toLocaleString(document.documentElement.lang);
}
