#!/usr/bin/env node
// Plots as one SVG file, drawn by the report's own script in Chromium: plots.js PLOTS.json OUT.svg [COLUMNS [WIDTH]]
// PLOTS.json: a list of plots as figures of a report have them in its element "data"; COLUMNS: side by side, 1 unless it is said; WIDTH: of each.
"use strict";
const {execFileSync} = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

module.paths.push("/usr/share/nodejs");  // where Debian has d3
const [plots, out, columns = 1, width = 640] = process.argv.slice(2);
const templates = path.join(__dirname, "../../comparison/report/templates"), read = (name) => fs.readFileSync(path.join(templates, name), "utf8");
const data = fs.readFileSync(plots, "utf8"), count = JSON.parse(data).length;
const page = `<!DOCTYPE html><meta charset="utf-8"><style>${read("report.css")}</style>
${Array.from({length: count}, (_, k) => `<figure><div class="plot" data-plot="${k}" data-width="${width}"></div></figure>`).join("\n")}
<header></header><main></main>
<script type="application/json" id="data">${data.replace(/</g, "\\u003c")}</script>
<script>${fs.readFileSync(require.resolve("d3/dist/d3.min.js"), "utf8")}</script>
<script>const shownPage = (plots) => ({header: "", main: "", plots});</script><script>${read("report.js")}</script>
<script>
const saved = [];
URL.createObjectURL = (file) => { saved.push(file.text()); return "#"; };
document.querySelectorAll(".tools button").forEach((button) => { if (button.textContent === "SVG") button.click(); });
Promise.all(saved).then((texts) => { document.body.dataset.saved = JSON.stringify(texts); });
</script>`;

const scratch = fs.mkdtempSync(path.join(os.tmpdir(), "plots-"));
try {
  fs.writeFileSync(path.join(scratch, "page.html"), page);
  const document = execFileSync("chromium", ["--headless=new", "--no-sandbox", "--disable-gpu", `--user-data-dir=${scratch}/profile`, "--virtual-time-budget=20000", "--dump-dom",
    `file://${scratch}/page.html`], {encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "ignore"]});
  const text = /data-saved="([^"]*)"/.exec(document)[1].replace(/&quot;/g, '"').replace(/&lt;/g, "<").replace(/&gt;/g, ">").replace(/&nbsp;/g, "\u00a0").replace(/&amp;/g, "&");
  const drawings = JSON.parse(text).map((svg) => svg.replace(/^<\?xml.*\n/, "")), heights = drawings.map((svg) => +/ height="(\d+)"/.exec(svg)[1]);
  let y = 0;
  const placed = drawings.map((svg, k) => {
    if (k > 0 && k % columns === 0) y += Math.max(...heights.slice(k - columns, k));
    return svg.replace("<svg", `<svg x="${(k % columns) * width}" y="${y}"`);
  });
  y += Math.max(...heights.slice(Math.floor((count - 1) / columns) * columns));
  fs.writeFileSync(out, count === 1 ? drawings[0] : `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${columns * width} ${y}" width="${columns * width}" height="${y}">
<rect width="${columns * width}" height="${y}" fill="#fff"/>\n${placed.join("")}</svg>\n`);
} finally {
  fs.rmSync(scratch, {recursive: true, force: true});
}
