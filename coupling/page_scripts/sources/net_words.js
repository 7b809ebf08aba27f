// Numbers as the pages write them (coupling/results/text/markup.cpp), and a row of figures for each thing that is counted.

import { grouped } from "./numbers.js";
import { counted, text } from "./texts.js";

const unknown = "–";

/** Three significant digits without an exponent. */
function threeDigits(value) {
    if (value === null || !Number.isFinite(value)) {
        return unknown;
    }
    if (value === 0) {
        return "0";
    }
    const exponentOf = (number) => Math.floor(Math.log10(Math.abs(number)) + 1e-12);
    const unit = Math.pow(10, exponentOf(value) - 2);
    const rounded = Math.round(value / unit) * unit;
    return grouped(rounded.toFixed(Math.min(9, Math.max(0, 2 - exponentOf(rounded)))));
}

const percentSign = "\u00a0%";

function percent(share) {
    const value = 100 * share;
    if (!Number.isFinite(value)) {
        return unknown;
    }
    if (value !== 0 && value < 0.01) {
        return text("script.nets.less_than", { share: grouped("0.01") + percentSign });
    }
    const rounded = Math.round(value * 10 * (1 + 1e-13)) / 10;
    return (value < 10 ? threeDigits(value) : grouped(rounded.toFixed(1))) + percentSign;
}

/** All digits of a number. */
export const exact = (value) => grouped(String(value));

const share = (part, whole) => (whole === 0 ? unknown : `${percent(part / whole)} (${counted(part)})`);
const ofDesign = (words) => ({ design }) => (design === null ? unknown : words(design));

function netToOrder(of, needed) {
    if (of.reached === 0) {
        return unknown;
    }
    const { design } = of;
    if (design === null) {
        return text("script.nets.too_few", { rocks: counted(of.reached), needed: counted(needed) });
    }
    const level = design.isOpen ? text("script.nets.open_class", { from: counted(design.openFrom), energy: counted(design.capacity) }) : `${counted(design.capacity)} kJ`;
    const net = text("script.nets.net_to_order", { class: design.energyClass, level, height: exact(design.height) });
    return design.sold === null ? text("script.nets.not_on_offer", { net }) : net;
}

/** The rows of the table: a heading, or a name and the words for the figures of a net on one slope. */
export function rowsOf(percentile, needed, withInexact) {
    const fields = { percentile: exact(percentile) };
    const quantity = (name) => [
        [text("script.nets.mean"), (of) => threeDigits(of[name].mean)],
        [text("script.nets.median"), (of) => threeDigits(of[name].p50)],
        [`90${percentSign}`, (of) => threeDigits(of[name].p90)],
        [`95${percentSign}`, (of) => threeDigits(of[name].p95)],
        [`99${percentSign}`, (of) => threeDigits(of[name].p99)],
        [text("script.nets.largest"), (of) => threeDigits(of[name].max)],
    ];
    return [
        [text("script.nets.reach"), (of) => `${counted(of.reached)}; ${percent(of.reached / of.fell)}`],
        ...(withInexact ? [[text("script.nets.inexact"), (of) => counted(of.inexact)]] : []),
        [text("script.nets.held"), (of) => share(of.counts[0], of.reached)],
        [text("script.nets.over"), (of) => share(of.counts[1], of.reached)],
        [text("script.nets.below"), (of) => share(of.counts[2], of.reached)],
        [text("script.nets.broke"), (of) => share(of.counts[3], of.reached)],
        [text("script.nets.design")],
        [text("script.nets.order"), (of) => netToOrder(of, needed)],
        [text("script.nets.percentile_energy", fields), ofDesign(({ percentileEnergy }) => threeDigits(percentileEnergy))],
        [text("script.nets.design_energy"), ofDesign(({ energy }) => threeDigits(energy))],
        [text("script.nets.percentile_height", fields), ofDesign(({ percentileHeight }) => threeDigits(percentileHeight))],
        [text("script.nets.design_height"), ofDesign(({ wantedHeight }) => threeDigits(wantedHeight))],
        [text("script.nets.would_hold"), (of) => (of.design === null ? unknown : percent(of.design.held / of.reached))],
        [text("script.nets.energy")],
        ...quantity("energy"),
        [text("script.nets.height_of_passage")],
        ...quantity("height"),
    ];
}
