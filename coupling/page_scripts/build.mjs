// Bundles the scripts of the result pages: `npm ci && npm run build` in this folder. The bundles are committed, so that
// neither the build of the program nor its users need npm.
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";

const scripts = ["charts", "slope", "nets"];

await build({
    entryPoints: scripts.map((name) => `sources/${name}.js`),
    outdir: "built",
    bundle: true,
    minify: true,
    format: "iife",
    target: ["chrome100", "firefox100", "safari15"],
    charset: "utf8",
    legalComments: "none", // the licences stand whole in built/LICENSES.txt
});

const sums = scripts.map((name) => {
    const hash = createHash("sha256").update(readFileSync(`built/${name}.js`)).digest("hex");
    return `${hash}  ${name}.js\n`;
});
writeFileSync("built/SHA256SUMS", sums.join(""));

const licences = [
    ["Apache ECharts (in charts.js)", "echarts", ["LICENSE", "NOTICE", "licenses/LICENSE-d3"]],
    ["ZRender (in charts.js)", "zrender", ["LICENSE"]],
    ["tslib (in charts.js)", "tslib", ["LICENSE.txt"]],
    ["three.js (in slope.js)", "three", ["LICENSE"]],
];
const rule = "=".repeat(78);
writeFileSync(
    "built/LICENSES.txt",
    "What the bundles hold besides Bannwald's own scripts, which are under GPL-3.0-or-later.\n" +
        licences
            .map(([title, folder, files]) => {
                const version = JSON.parse(readFileSync(`node_modules/${folder}/package.json`)).version;
                const texts = files.map((file) => readFileSync(`node_modules/${folder}/${file}`, "utf8").trim());
                return `\n${rule}\n${title}, version ${version}\n${rule}\n\n${texts.join("\n\n")}\n`;
            })
            .join(""),
);
