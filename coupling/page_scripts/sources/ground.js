// The ground as a mesh: x to the east, y up, z to the south, metres from the middle of the map.

import { BufferAttribute, BufferGeometry, CanvasTexture, DoubleSide, Mesh, MeshLambertMaterial, SRGBColorSpace } from "three";

import { shorts } from "./unpack.js";

const none = 65535;

/** A picture once it can be drawn; null without an address. */
const loaded = (address) => (address
    ? new Promise((done) => {
        const picture = new Image();
        picture.onload = () => done(picture);
        picture.src = address;
    })
    : null);

export class Ground {
    constructor(scene) {
        const data = scene.ground;
        this.data = data;
        this.picture = scene.picture;
        this.z = shorts(data.z);
        this.step = scene.z.step;
        this.middle = { x: 0.5 * data.width_m, y: 0.5 * data.height_m };
        this.top = this.z.reduce((most, z) => (z === none ? most : Math.max(most, z)), 0) * this.step;
        this.half = 0.5 * this.top;
        this.extent = Math.hypot(data.width_m, data.height_m);
    }

    /** Metres from the western rim of a column of heights, and from the northern one of a row. */
    west(column) {
        const { block, cell_width_m, width_m } = this.data;
        return Math.min((column * block + Math.floor(block / 2) + 0.5) * cell_width_m, width_m - 0.5 * cell_width_m);
    }
    north(row) {
        const { block, cell_height_m, height_m } = this.data;
        return Math.min((row * block + Math.floor(block / 2) + 0.5) * cell_height_m, height_m - 0.5 * cell_height_m);
    }

    /** A place of the map (metres from the south-western corner, height above the lowest ground) in the scene. */
    place(x, y, height) {
        return [x - this.middle.x, height - this.half, this.middle.y - y];
    }

    at(column, row) {
        const z = this.z[row * this.data.columns + column];
        return z === none ? NaN : z * this.step;
    }

    /** Height of the drawn ground at a place of the map; NaN beyond it. */
    height(x, y) {
        const { block, cell_width_m, cell_height_m, height_m, columns, rows } = this.data;
        const offset = Math.floor(block / 2) + 0.5;
        const u = Math.min(columns - 1, Math.max(0, (x / cell_width_m - offset) / block));
        const v = Math.min(rows - 1, Math.max(0, ((height_m - y) / cell_height_m - offset) / block));
        const column = Math.min(columns - 2, Math.floor(u));
        const row = Math.min(rows - 2, Math.floor(v));
        const a = this.at(column, row);
        const b = this.at(column + 1, row);
        const c = this.at(column, row + 1);
        const d = this.at(column + 1, row + 1);
        const s = u - column;
        const t = v - row;
        // The same two triangles as the mesh.
        return s + t <= 1 ? a + s * (b - a) + t * (c - a) : d + (1 - s) * (c - d) + (1 - t) * (b - d);
    }

    mesh() {
        const { columns, rows, width_m, height_m } = this.data;
        const positions = new Float32Array(3 * columns * rows);
        const uv = new Float32Array(2 * columns * rows);
        for (let row = 0; row < rows; ++row) {
            for (let column = 0; column < columns; ++column) {
                const i = row * columns + column;
                const west = this.west(column);
                const north = this.north(row);
                const height = this.at(column, row);
                positions.set(this.place(west, height_m - north, Number.isNaN(height) ? 0 : height), 3 * i);
                uv.set([west / width_m, 1 - north / height_m], 2 * i);
            }
        }
        const index = [];
        const there = (...corners) => corners.every((i) => this.z[i] !== none);
        for (let row = 0; row + 1 < rows; ++row) {
            for (let column = 0; column + 1 < columns; ++column) {
                const a = row * columns + column;
                const [b, c, d] = [a + 1, a + columns, a + columns + 1];
                if (there(a, b, c)) {
                    index.push(a, c, b);
                }
                if (there(b, c, d)) {
                    index.push(b, c, d);
                }
            }
        }
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(positions, 3));
        geometry.setAttribute("uv", new BufferAttribute(uv, 2));
        geometry.setIndex(new BufferAttribute(new Uint32Array(index), 1));
        geometry.computeVertexNormals();
        this.material = new MeshLambertMaterial({ color: 0xe9e6da, side: DoubleSide });
        return new Mesh(geometry, this.material);
    }

    /** Lays a map over the ground, and below it the picture of the maps where there is one; null for the ground
     * without a map. Calls back when it lies there. */
    drape(layer, done) {
        const lay = (texture) => {
            this.material.map?.dispose();
            this.material.map = texture;
            this.material.color.set(texture ? 0xffffff : 0xe9e6da);
            this.material.needsUpdate = true;
            done();
        };
        const behind = this.picture && document.getElementById("ground-picture")?.getAttribute("href");
        if (layer === null && !behind) {
            lay(null);
            return;
        }
        Promise.all([behind, layer?.address].map(loaded)).then(([picture, values]) => {
            const size = behind ? 2048 : 1024;
            const canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [size, Math.round(size * (layer?.aspect ?? this.data.height_m / this.data.width_m))];
            const context = canvas.getContext("2d");
            context.fillStyle = "#e9e6da";
            context.fillRect(0, 0, canvas.width, canvas.height);
            if (picture) {
                const { west, north, width, height } = this.picture;
                context.drawImage(picture, west * canvas.width, north * canvas.height, width * canvas.width, height * canvas.height);
            }
            if (values) {
                context.globalAlpha = picture ? 0.8 : 1; // as on the maps
                context.imageSmoothingEnabled = false;
                context.drawImage(values, 0, 0, canvas.width * layer.wide, canvas.height * layer.high);
            }
            const texture = new CanvasTexture(canvas);
            texture.colorSpace = SRGBColorSpace;
            lay(texture);
        });
    }
}
