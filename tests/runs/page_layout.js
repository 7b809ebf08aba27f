// Measures pages in a browser: what is wider than the screen, which labels lie outside of their drawing, which names on a
// map outside of its frame, which labels lie over each other. Runs in a page with an attribute data-pages, their names, and data-widths, in pixels; opens each with its
// scripts and without; writes one line a fault into an element with the id "faults", and how many drawings and labels it
// looked at into "seen".

const clearance = 2;  // px; letters are smaller than the boxes around them

const isShown = (box) => box.width > 0 && box.height > 0;
const shortText = (element) => element.textContent.trim().replace(/\s+/g, " ").slice(0, 60);

/** Whether a parent scrolls or cuts what is too wide for it. */
function isCut(element, view) {
    for (let parent = element.parentElement; parent; parent = parent.parentElement) {
        if (view.getComputedStyle(parent).overflowX !== "visible") {
            return true;
        }
    }
    return false;
}

function widerThanTheScreen(page, view) {
    const width = page.documentElement.clientWidth;
    return [...page.body.querySelectorAll("*")]
        .filter((element) => !element.parentElement.closest("svg") && isShown(element.getBoundingClientRect()) &&
                             element.getBoundingClientRect().right > width + 1 && !isCut(element, view))
        .slice(0, 3)
        .map((element) => `wider than the screen: ${element.tagName} ${shortText(element)}`);
}

const labelsOf = (drawing) => [...drawing.querySelectorAll("text")]
    .filter((label) => label.textContent.trim() !== "" && isShown(label.getBoundingClientRect()));

function outsideOf(frame, labels, what) {
    const around = frame.getBoundingClientRect();
    return labels
        .filter((label) => {
            const box = label.getBoundingClientRect();
            return box.left < around.left - clearance || box.right > around.right + clearance ||
                   box.top < around.top - clearance || box.bottom > around.bottom + clearance;
        })
        .map((label) => `outside of its ${what}: ${shortText(label)}`);
}

/** Around the ground of a map stand coordinates; names of things stand on it. */
function namesOutside(drawing, labels) {
    const ground = drawing.querySelector(":scope > rect.paper");
    return ground === null ? [] : outsideOf(ground, labels.filter((label) => label.classList.contains("name")), "map");
}

function overEachOther(labels) {
    const boxes = labels.map((label) => label.getBoundingClientRect());
    const faults = [];
    for (let i = 0; i < boxes.length; ++i) {
        for (let k = i + 1; k < boxes.length; ++k) {
            const wide = Math.min(boxes[i].right, boxes[k].right) - Math.max(boxes[i].left, boxes[k].left);
            const high = Math.min(boxes[i].bottom, boxes[k].bottom) - Math.max(boxes[i].top, boxes[k].top);
            if (wide > clearance && high > 2 * clearance) {
                faults.push(`over each other: ${shortText(labels[i])} | ${shortText(labels[k])}`);
            }
        }
    }
    return faults;
}

async function load(frame, page) {
    const loaded = new Promise((done) => frame.addEventListener("load", done, { once: true }));
    frame.src = page;
    await loaded;
    await new Promise((done) => setTimeout(done, 200));  // charts are drawn
}

async function measure() {
    const frame = document.createElement("iframe");
    document.body.append(frame);
    frame.style.height = "1600px";
    const widths = document.body.dataset.widths.split(" ");
    // Without scripts drawings grow with the screen as a whole: one width shows all.
    const ways = [...widths.map((width) => ["with", width]), ["without", widths[0]]];
    const faults = [];
    let drawings = 0;
    let labelsSeen = 0;
    for (const name of document.body.dataset.pages.split(" ")) {
        for (const [scripts, width] of ways) {
            frame.style.width = `${width}px`;
            frame.sandbox = `allow-same-origin${scripts === "with" ? " allow-scripts" : ""}`;
            await load(frame, name);
            const page = frame.contentDocument;
            const found = widerThanTheScreen(page, frame.contentWindow);
            for (const drawing of page.querySelectorAll("svg")) {
                if (isShown(drawing.getBoundingClientRect())) {
                    const labels = labelsOf(drawing);
                    found.push(...outsideOf(drawing, labels, "drawing"), ...namesOutside(drawing, labels), ...overEachOther(labels));
                    drawings += 1;
                    labelsSeen += labels.length;
                }
            }
            faults.push(...new Set(found.map((fault) => `${name}, ${width} px, ${scripts} scripts, ${fault}`)));
        }
    }
    for (const [id, text] of [["faults", faults.join("\n")], ["seen", `${drawings} ${labelsSeen}`]]) {
        const result = document.createElement("pre");
        result.id = id;
        result.textContent = text;
        document.body.append(result);
    }
}

measure();
