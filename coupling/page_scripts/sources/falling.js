// Rocks on their way at a time since their release: where they are, how they are turned, how much energy they have.

import { BufferAttribute, BufferGeometry, Group, IcosahedronGeometry, Mesh, MeshLambertMaterial } from "three";

import { quaternion } from "./blocks.js";
import { classLooks } from "./lines.js";
import { bytes, shorts } from "./unpack.js";

/** Balls of a size that shows beside the whole slope. */
const ballShare = 0.006;

/** The hull of a block, in axes of the scene (east, up, south). */
function hullOf({ vertices, faces }) {
    const positions = [];
    for (const corner of faces) {
        const [a, b, c] = vertices.slice(3 * corner, 3 * corner + 3);
        positions.push(a, c, -b);
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    geometry.computeVertexNormals();
    return geometry;
}

/** The place of the last of rising times that is not after `time`. */
function before(times, time) {
    let [low, high] = [0, times.length];
    while (low + 1 < high) {
        const middle = (low + high) >> 1;
        if (times[middle] <= time) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

export class Falling {
    constructor(scene, ground) {
        this.ground = ground;
        this.steps = [scene.x.step, scene.y.step, scene.z.step];
        this.step_s = scene.time_step_s;
        this.radius = 0.5 * ballShare * ground.extent;
        this.materials = classLooks.map(({ colour }) => new MeshLambertMaterial({ color: colour, flatShading: true }));
        const ball = new IcosahedronGeometry(this.radius, 1);
        this.group = new Group();
        this.rocks = scene.paths.filter((path) => path.times).map((path) => {
            const mesh = new Mesh(path.shape ? hullOf(path.shape) : ball, this.materials[0]);
            mesh.frustumCulled = false;
            this.group.add(mesh);
            return {
                mesh,
                cover: path.cover,
                diameter: path.shape ? path.diameter_m : 0,
                points: shorts(path.points),
                times: shorts(path.times),
                classes: bytes(path.classes),
                attitudes: path.shape ? shorts(path.attitudes) : null,
            };
        });
    }

    /** The time of the last rest, s. */
    get end() {
        return Math.max(...this.rocks.map(({ times }) => times.at(-1))) * this.step_s;
    }

    /** Puts every rock of the shown slopes where it is at a time; `enlarged`: how large blocks are drawn. */
    show(time_s, shown, enlarged) {
        const time = time_s / this.step_s;
        for (const rock of this.rocks) {
            rock.mesh.visible = Boolean(shown[rock.cover]);
            const i = before(rock.times, time);
            const next = Math.min(i + 1, rock.times.length - 1);
            const length = rock.times[next] - rock.times[i];
            const share = length > 0 ? Math.min(1, Math.max(0, (time - rock.times[i]) / length)) : 0;
            const place = [0, 1, 2].map((k) => this.steps[k] * ((1 - share) * rock.points[3 * i + k] + share * rock.points[3 * next + k]));
            // Paths are those of the underside.
            const lift = rock.attitudes ? 0.5 * enlarged * rock.diameter : this.radius;
            rock.mesh.position.set(...this.ground.place(place[0], place[1], place[2] + lift));
            rock.mesh.material = this.materials[rock.classes[i]];
            if (rock.attitudes) {
                const [w, x, y, z] = quaternion(rock.attitudes, share < 0.5 ? i : next);
                rock.mesh.quaternion.set(x, z, -y, w);
                rock.mesh.scale.setScalar(enlarged);
            }
        }
    }
}
