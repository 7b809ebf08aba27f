// Blocks with a shape at their real attitude along sampled paths.

import { BufferAttribute, BufferGeometry, Group, Mesh, MeshLambertMaterial } from "three";

import { classLooks } from "./lines.js";
import { bytes, shorts } from "./unpack.js";

/** By how much blocks can be drawn larger. */
export const enlargements = [1, 3, 10, 30];

/** Blocks stand apart by so many of their drawn diameters. */
const apart = 2.5;

/** What a unit quaternion [w, x, y, z] makes of a vector. */
export function turned([w, x, y, z], [a, b, c]) {
    const [s, t, u] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
    return [a + w * s + y * u - z * t, b + w * t + z * s - x * u, c + w * u + x * t - y * s];
}

/** The i-th of packed unit quaternions. */
export function quaternion(packed, i) {
    const q = [0, 1, 2, 3].map((k) => (2 * packed[4 * i + k]) / 65534 - 1);
    const length = Math.hypot(...q);
    return q.map((part) => part / length);
}

/** The blocks of paths, each by the colour of its energy class, `times` as large as they are. */
export function blocksOf(scene, ground, paths, times) {
    const positions = classLooks.map(() => []);
    for (const path of paths) {
        if (!path.shape) {
            continue;
        }
        const points = shorts(path.points);
        const classes = bytes(path.classes);
        const attitudes = shorts(path.attitudes);
        const { vertices, faces } = path.shape;
        const last = classes.length - 1;
        let before = null;
        for (let i = 0; i <= last; ++i) {
            const place = [points[3 * i] * scene.x.step, points[3 * i + 1] * scene.y.step, points[3 * i + 2] * scene.z.step];
            const isFar = before === null || Math.hypot(...place.map((v, k) => v - before[k])) >= apart * times * path.diameter_m;
            if (!isFar && i < last) {
                continue;
            }
            before = place;
            const q = quaternion(attitudes, i);
            const centre = ground.place(place[0], place[1], place[2] + 0.5 * times * path.diameter_m);
            const corners = [];
            for (let k = 0; k + 2 < vertices.length; k += 3) {
                const [x, y, z] = turned(q, vertices.slice(k, k + 3));
                corners.push([centre[0] + times * x, centre[1] + times * z, centre[2] - times * y]);
            }
            faces.forEach((corner) => positions[classes[i]].push(...corners[corner]));
        }
    }
    const group = new Group();
    positions.forEach((numbers, k) => {
        if (numbers.length > 0) {
            const geometry = new BufferGeometry();
            geometry.setAttribute("position", new BufferAttribute(new Float32Array(numbers), 3));
            geometry.computeVertexNormals();
            const mesh = new Mesh(geometry, new MeshLambertMaterial({ color: classLooks[k].colour }));
            mesh.frustumCulled = false;
            group.add(mesh);
        }
    });
    return group;
}
