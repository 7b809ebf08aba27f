// The eye: turned by pointer, keys and buttons around a point on the ground.

import { PerspectiveCamera, Spherical, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

export class Eye {
    constructor(canvas, ground, changed) {
        this.ground = ground;
        this.camera = new PerspectiveCamera(40, 1.6, 1, 20 * ground.extent);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.maxPolarAngle = 0.495 * Math.PI;
        this.controls.minDistance = 8;
        this.controls.maxDistance = 4 * ground.extent;
        this.controls.zoomToCursor = true;
        this.controls.enableDamping = false;
        // A page is scrolled with the wheel: the view zooms once it has the focus.
        this.controls.enableZoom = false;
        canvas.addEventListener("focus", () => { this.controls.enableZoom = true; });
        canvas.addEventListener("blur", () => { this.controls.enableZoom = false; });
        this.changed = () => {
            // Depths keep their precision: what is near is only cut off where the eye is far.
            this.camera.near = Math.max(0.5, 0.01 * this.camera.position.distanceTo(this.controls.target));
            this.camera.updateProjectionMatrix();
            changed();
        };
        this.controls.addEventListener("change", this.changed);
        canvas.addEventListener("keydown", (event) => this.key(event));
    }

    /** Looks up the slope from below: from where the ground falls to. */
    reset() {
        const { data } = this.ground;
        const mean = (edge) => {
            const known = edge.filter((height) => !Number.isNaN(height));
            return known.length ? known.reduce((sum, height) => sum + height, 0) / known.length : 0;
        };
        const columns = [...Array(data.columns).keys()];
        const rows = [...Array(data.rows).keys()];
        const east = mean(rows.map((row) => this.ground.at(data.columns - 1, row)));
        const west = mean(rows.map((row) => this.ground.at(0, row)));
        const south = mean(columns.map((column) => this.ground.at(column, data.rows - 1)));
        const north = mean(columns.map((column) => this.ground.at(column, 0)));
        const down = new Vector3((west - east) / data.width_m, 0, (north - south) / data.height_m);
        this.look(down.length() > 1e-6 ? Math.atan2(down.x, down.z) : 0, 0.36 * Math.PI);
    }

    fromAbove() {
        this.look(0, 0.001);
    }

    look(azimuth, polar) {
        const distance = 1.12 * this.ground.extent;
        const nearer = polar > 0.1 ? 0.07 * this.ground.extent : 0; // what is near takes more room
        this.controls.target.set(nearer * Math.sin(azimuth), -0.06 * this.ground.top, nearer * Math.cos(azimuth));
        this.camera.position.setFromSpherical(new Spherical(distance, polar, azimuth)).add(this.controls.target);
        this.controls.update();
        this.changed();
    }

    get azimuth() {
        return this.controls.getAzimuthalAngle();
    }

    /** Metres that a pixel is wide at the point that the eye looks at. */
    metresAPixel(height) {
        const distance = this.camera.position.distanceTo(this.controls.target);
        return (2 * distance * Math.tan((0.5 * this.camera.fov * Math.PI) / 180)) / height;
    }

    turn(azimuth, polar, zoom) {
        const offset = this.camera.position.clone().sub(this.controls.target);
        const place = new Spherical().setFromVector3(offset);
        place.theta += azimuth;
        place.phi = Math.min(this.controls.maxPolarAngle, Math.max(0.001, place.phi + polar));
        place.radius = Math.min(this.controls.maxDistance, Math.max(this.controls.minDistance, place.radius * zoom));
        this.camera.position.setFromSpherical(place).add(this.controls.target);
        this.controls.update();
        this.changed();
    }

    /** Moves the point looked at: to the right and away, as a share of the distance to it. */
    shift(right, away) {
        const step = 0.05 * this.camera.position.distanceTo(this.controls.target);
        const angle = this.azimuth;
        const move = new Vector3(
            step * (right * Math.cos(angle) - away * Math.sin(angle)), 0,
            step * (-right * Math.sin(angle) - away * Math.cos(angle)));
        this.controls.target.add(move);
        this.camera.position.add(move);
        this.controls.update();
        this.changed();
    }

    key(event) {
        const angle = Math.PI / 36;
        const moves = event.shiftKey
            ? { ArrowLeft: () => this.shift(-1, 0), ArrowRight: () => this.shift(1, 0), ArrowUp: () => this.shift(0, 1), ArrowDown: () => this.shift(0, -1) }
            : { ArrowLeft: () => this.turn(-angle, 0, 1), ArrowRight: () => this.turn(angle, 0, 1), ArrowUp: () => this.turn(0, -angle, 1), ArrowDown: () => this.turn(0, angle, 1) };
        Object.assign(moves, { "+": () => this.turn(0, 0, 0.85), "-": () => this.turn(0, 0, 1 / 0.85), Home: () => this.reset() });
        if (event.key in moves && !event.ctrlKey && !event.altKey && !event.metaKey) {
            event.preventDefault();
            moves[event.key]();
        }
    }
}
