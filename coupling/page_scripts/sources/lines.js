// Paths of rocks by energy class, where they end, and targets draped over the ground.

import { Group, InstancedMesh, Matrix4, MeshLambertMaterial, OctahedronGeometry } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";

import { bytes, shorts } from "./unpack.js";

/** By energy class: colours and widths of the maps of paths (coupling/results/report/page.css). */
export const classLooks = [
    { colour: 0x4a9fd8, width: 1.2 },
    { colour: 0x1d5fa8, width: 1.4 },
    { colour: 0xe8a020, width: 1.8 },
    { colour: 0xe05010, width: 2.1 },
    { colour: 0xb0122b, width: 2.5 },
    { colour: 0x4d0016, width: 3.0 },
];
export const targetColour = 0x111111;
export const restColour = 0xffd400;
export const logColour = 0x4a2f1b;

function segments(positions, colour, width, extra = {}) {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(positions);
    const lines = new LineSegments2(geometry, new LineMaterial({ color: colour, linewidth: width, ...extra }));
    lines.frustumCulled = false;
    return lines;
}

/** Paths, with a mark where each ends. */
export function pathsOf(scene, ground, paths) {
    const positions = classLooks.map(() => []);
    const rests = [];
    for (const path of paths) {
        const points = shorts(path.points);
        const classes = bytes(path.classes);
        let last = null;
        for (let i = 0; i < classes.length; ++i) {
            const place = ground.place(
                points[3 * i] * scene.x.step, points[3 * i + 1] * scene.y.step, points[3 * i + 2] * scene.z.step + 0.3);
            if (last !== null) {
                positions[Math.max(classes[i - 1], classes[i])].push(...last, ...place);
            }
            last = place;
        }
        if (last !== null) {
            rests.push(last);
        }
    }
    const group = new Group();
    positions.forEach((numbers, k) => {
        if (numbers.length > 0) {
            group.add(segments(numbers, classLooks[k].colour, classLooks[k].width));
        }
    });
    const marks = new InstancedMesh(
        new OctahedronGeometry(Math.max(1, 0.0035 * ground.extent)), new MeshLambertMaterial({ color: restColour }), rests.length);
    rests.forEach(([x, y, z], i) => marks.setMatrixAt(i, new Matrix4().setPosition(x, y + 0.5, z)));
    marks.frustumCulled = false;
    return { lines: group, rests: marks };
}

/** Lying stems as lines on the ground; null without any. */
export function logsOf(scene, ground, stand) {
    const ends = shorts(stand.logs);
    const positions = [];
    for (let i = 0; i + 3 < ends.length; i += 4) {
        const place = (k) => {
            const [x, y] = [ends[k] * scene.x.step, ends[k + 1] * scene.y.step];
            return ground.place(x, y, ground.height(x, y) + 0.4);
        };
        const both = [...place(i), ...place(i + 2)];
        if (!both.some(Number.isNaN)) {
            positions.push(...both);
        }
    }
    return positions.length > 0 ? segments(positions, logColour, 2.2) : null;
}

/** Frees what lines and marks took on the graphics card. */
export function drop(...groups) {
    groups.filter((group) => group).forEach((group) => group.traverse((part) => {
        part.geometry?.dispose();
        part.material?.dispose();
    }));
}

/** Targets as lines on the ground, with a white rim. */
export function targetsOf(scene, ground) {
    const positions = [];
    for (const target of scene.targets) {
        for (const part of target.parts) {
            for (let i = 0; i + 3 < part.length; i += 2) {
                const [x1, y1, x2, y2] = part.slice(i, i + 4);
                const pieces = Math.max(1, Math.ceil(Math.hypot(x2 - x1, y2 - y1) / 3));
                const at = (share) => {
                    const [x, y] = [x1 + share * (x2 - x1), y1 + share * (y2 - y1)];
                    return ground.place(x, y, ground.height(x, y) + 0.8);
                };
                for (let k = 0; k < pieces; ++k) {
                    const [from, to] = [at(k / pieces), at((k + 1) / pieces)];
                    if (![...from, ...to].some(Number.isNaN)) {
                        positions.push(...from, ...to);
                    }
                }
            }
        }
    }
    const group = new Group();
    if (positions.length > 0) {
        const rim = segments(positions, 0xffffff, 7, { depthWrite: false });
        rim.renderOrder = 1;
        const line = segments(positions, targetColour, 3.5);
        line.renderOrder = 2;
        group.add(rim, line);
    }
    return group;
}
