// Numbers as the pages write them (coupling/results/text/markup.cpp).

const isSwiss = document.documentElement.lang.endsWith("-CH");
const decimalSign = isSwiss || document.documentElement.lang === "en" ? "." : ",";
const betweenThousands = isSwiss ? "\u2019" : "\u202f";

/** Whole digits in groups of three with narrow blanks (apostrophes in Switzerland), a true minus sign, the decimal sign of the page's language. */
export function grouped(text) {
    const [whole, fraction] = text.replace("-", "").split(".");
    const groups = whole.replace(/\B(?=(\d{3})+$)/g, betweenThousands);
    return (text.startsWith("-") ? "\u2212" : "") + groups + (fraction ? decimalSign + fraction : "");
}

/** Three significant digits without an exponent. */
export function threeDigits(value) {
    if (value === null || !Number.isFinite(value)) {
        return "–";
    }
    if (value === 0) {
        return "0";
    }
    const decimals = Math.min(6, Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value)))));
    const rounded = decimals > 0 ? value : Number(value.toPrecision(3));
    return grouped(rounded.toFixed(decimals));
}

/** A number of an axis without needless zeros. */
export function tickText(value) {
    return grouped(String(Number(value.toPrecision(6))));
}

/** Numbers of a JSON list in rows of `width`. */
export function rows(numbers, width) {
    const all = [];
    for (let i = 0; i + width <= numbers.length; i += width) {
        all.push(numbers.slice(i, i + width));
    }
    return all;
}

/** What stands at a place of an axis: the name of its tick, or the number. */
export function labelAt(axis, value) {
    return axis.names ? (axis.names[axis.ticks.indexOf(value)] ?? "") : tickText(value);
}
