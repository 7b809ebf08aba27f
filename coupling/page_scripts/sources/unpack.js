// Numbers packed as base64 (coupling/page_scripts/json_text.cpp).

function bytes(text) {
    const binary = atob(text);
    const all = new Uint8Array(binary.length);
    for (let i = 0; i < binary.length; ++i) {
        all[i] = binary.charCodeAt(i);
    }
    return all;
}

/** Whole numbers of two bytes, lower one first. */
export function shorts(text) {
    const raw = bytes(text);
    const all = new Uint16Array(raw.length / 2);
    for (let i = 0; i < all.length; ++i) {
        all[i] = raw[2 * i] | (raw[2 * i + 1] << 8);
    }
    return all;
}

export { bytes };
