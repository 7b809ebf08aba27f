// The table of nets as `bannwald net try --nets` and the setting nets.file read it.

import { withoutDoubles } from "./net_checks.js";

const quoted = (text) => `"${text.replaceAll('"', '""')}"`;

/** Nets as CSV; coordinates, heights and energies keep all their digits. */
export function tableOf(nets) {
    const rows = nets.map(({ name, energy_class, height_m, gap_m, capacity_kj, line }) => {
        const corners = withoutDoubles(line).map(([x, y]) => `${x} ${y}`).join(", ");
        return [quoted(name), height_m, energy_class ? "" : capacity_kj, energy_class, gap_m, quoted(`LINESTRING (${corners})`)].join(",");
    });
    return `name,height_m,capacity_kj,class,gap_m,wkt\n${rows.join("\n")}\n`;
}
