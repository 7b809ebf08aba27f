// The blocks of a rock mass at the times of a slider, coloured by their speed.

import { BufferAttribute, BufferGeometry, Mesh, MeshLambertMaterial } from "three";

import { quaternion, turned } from "./blocks.js";
import { bytes, shorts } from "./unpack.js";

/** By class of speed; bounds and colours of the views from the side (coupling/assessments/collapse). */
export const speedColours = [0x9aa5b1, 0xf0b429, 0xde6b1f, 0xa31621];

export class Mass {
    constructor(scene, ground) {
        this.data = scene.mass;
        this.ground = ground;
        this.places = shorts(this.data.places);
        this.attitudes = shorts(this.data.attitudes);
        this.speeds = bytes(this.data.speeds);
        const corners = this.data.blocks.reduce((sum, block) => sum + block.faces.length, 0);
        this.geometry = new BufferGeometry();
        this.geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * corners), 3));
        this.geometry.setAttribute("color", new BufferAttribute(new Float32Array(3 * corners), 3));
        this.mesh = new Mesh(this.geometry, new MeshLambertMaterial({ vertexColors: true, flatShading: true }));
        this.mesh.frustumCulled = false;
    }

    /** Puts every block where it was in a frame. */
    show(frame) {
        const { blocks, x, y, z } = this.data;
        const positions = this.geometry.getAttribute("position").array;
        const colours = this.geometry.getAttribute("color").array;
        let at = 0;
        blocks.forEach(({ vertices, faces }, b) => {
            const i = frame * blocks.length + b;
            const [east, north, up] = [x, y, z].map((axis, k) => axis.low + axis.step * this.places[3 * i + k]);
            const centre = this.ground.place(east, north, up);
            const q = quaternion(this.attitudes, i);
            const corners = [];
            for (let k = 0; k + 2 < vertices.length; k += 3) {
                const [a, c, d] = turned(q, vertices.slice(k, k + 3));
                corners.push([centre[0] + a, centre[1] + d, centre[2] - c]);
            }
            const colour = speedColours[this.speeds[i]];
            const rgb = [colour >> 16, (colour >> 8) & 255, colour & 255].map((part) => (part / 255) ** 2.2);
            for (const corner of faces) {
                positions.set(corners[corner], at);
                colours.set(rgb, at);
                at += 3;
            }
        });
        this.geometry.getAttribute("position").needsUpdate = true;
        this.geometry.getAttribute("color").needsUpdate = true;
    }
}
