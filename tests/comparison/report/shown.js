// node shown.js: for each line of its input, PAGE and OUT with a tabulator between them, the HTML that the script of a page
// of the report makes of the document in it, without a browser.
"use strict";
const fs = require("fs");

function shown(page) {
  const script = (id) => page.match(new RegExp(`<script[^>]* id="${id}">(.*?)</script>`, "s"))[1];
  const {header, main} = require("vm").runInNewContext(`${script("sections")}; shownPage(${script("data")})`);
  // Mustache escapes these, too; they stand for themselves in a text.
  const plain = {"&#x2F;": "/", "&#x3D;": "=", "&#x60;": "`"};
  return (header ?? "") + main.replace(/&#x(2F|3D|60);/g, (code) => plain[code]);
}

require("readline").createInterface({input: process.stdin}).on("line", (line) => {
  const [page, out] = line.split("\t");
  let html;
  try {
    html = shown(fs.readFileSync(page, "utf8"));
  } catch (error) {
    html = String(error);
  }
  fs.writeFileSync(out, html);
});
