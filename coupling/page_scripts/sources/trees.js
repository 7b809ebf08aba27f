// Trees as crowns on stems: cones for conifers, ellipsoids for broadleaves. Dead ones are bare grey stems, broken ones end
// in a pale disc.

import {
    ConeGeometry, CylinderGeometry, Group, OctahedronGeometry, InstancedMesh, Matrix4, MeshLambertMaterial,
} from "three";

import { bytes, shorts } from "./unpack.js";

const living = 0;
const broken = 2;
/** Stems are drawn thicker than they are, or they could not be seen. */
const stemWidening = 2;
const stemColours = { living: 0x6b543f, dead: 0x8c8c8c, end: 0xf2e2b8 };

/** Unit bodies that stand on y = 0. */
function bodies() {
    const cone = new ConeGeometry(1, 1, 6, 1, true).translate(0, 0.5, 0);
    const round = new OctahedronGeometry(1, 1).scale(1, 0.5, 1).translate(0, 0.5, 0);
    const stem = new CylinderGeometry(0.6, 1, 1, 5, 1, true).translate(0, 0.5, 0);
    const end = new CylinderGeometry(1, 1, 1, 6).translate(0, 0.5, 0);
    return { cone, round, stem, end };
}

/** Crowns that nobody measured [choice]: half as long as a broadleaf is tall, two thirds of a conifer; width by height. */
function crownOf(tree, conifer) {
    if (tree.radius > 0) {
        return tree;
    }
    const base = tree.height * (conifer ? 0.33 : 0.45);
    return { ...tree, base, radius: Math.min(6, 0.4 + tree.height * (conifer ? 0.085 : 0.14)) };
}

function treesOf(scene, stand) {
    const [x, y] = [shorts(stand.x), shorts(stand.y)];
    const [dbh, height] = [shorts(stand.dbh_mm), shorts(stand.height_cm)];
    const [base, radius] = [shorts(stand.base_cm), shorts(stand.radius_cm)];
    const kind = bytes(stand.kind);
    return Array.from(x, (_, i) => ({
        x: x[i] * scene.x.step,
        y: y[i] * scene.y.step,
        dbh: dbh[i] / 1000,
        height: height[i] / 100,
        base: base[i] / 100,
        radius: radius[i] / 100,
        species: kind[i] >> 2,
        state: kind[i] & 3,
    }));
}

class Batch {
    constructor(body, colour) {
        this.body = body;
        this.colour = colour;
        this.places = [];
    }
    add(x, y, z, wide, high) {
        this.places.push(x, y, z, wide, high);
    }
    mesh() {
        const count = this.places.length / 5;
        const mesh = new InstancedMesh(this.body, new MeshLambertMaterial({ color: this.colour }), count);
        const matrix = new Matrix4();
        for (let i = 0; i < count; ++i) {
            const [x, y, z, wide, high] = this.places.slice(5 * i, 5 * i + 5);
            matrix.makeScale(wide, high, wide).setPosition(x, y, z);
            mesh.setMatrixAt(i, matrix);
        }
        mesh.frustumCulled = false;
        return mesh;
    }
}

/** The trees of a stand as a group, and the species that stand in it. */
export function grow(scene, ground, stand) {
    const shapes = bodies();
    const crowns = new Map();
    const stems = new Batch(shapes.stem, stemColours.living);
    const deadStems = new Batch(shapes.stem, stemColours.dead);
    const ends = new Batch(shapes.end, stemColours.end);
    const seen = { species: new Set(), dead: false, broken: false };
    for (const listed of treesOf(scene, stand)) {
        const foot = ground.height(listed.x, listed.y);
        if (Number.isNaN(foot)) {
            continue;
        }
        const species = scene.species[listed.species];
        const [x, y, z] = ground.place(listed.x, listed.y, foot);
        const thick = Math.max(0.04, 0.5 * stemWidening * listed.dbh);
        if (listed.state !== living) {
            deadStems.add(x, y, z, thick, listed.height);
            seen.dead = true;
            if (listed.state === broken) {
                ends.add(x, y + listed.height, z, 1.3 * thick, 0.25);
                seen.broken = true;
            }
            continue;
        }
        const tree = crownOf(listed, species.conifer);
        if (!crowns.has(listed.species)) {
            crowns.set(listed.species, new Batch(species.conifer ? shapes.cone : shapes.round, species.colour));
            seen.species.add(listed.species);
        }
        crowns.get(listed.species).add(x, y + tree.base, z, tree.radius, Math.max(0.1, tree.height - tree.base));
        if (tree.base > 0.3) {
            stems.add(x, y, z, thick, tree.base + 0.2 * (tree.height - tree.base));
        }
    }
    const group = new Group();
    for (const batch of [...crowns.values(), stems, deadStems, ends]) {
        if (batch.places.length > 0) {
            group.add(batch.mesh());
        }
    }
    return { group, seen };
}

/** Frees what a group of trees took on the graphics card. */
export function fell(group) {
    group.children.forEach((mesh) => {
        mesh.geometry.dispose();
        mesh.material.dispose();
        mesh.dispose();
    });
}
