// Build step: node embed.js OUT.cc FILE...: the page of a report (text/page.h) as strings of the program: page.html, with its
// style, the templates and its scripts (d3 and mustache.js among them) in the place of their names.
// Formulas in templates, \( ... \), become HTML and MathML here, so that a page needs neither KaTeX's script nor a network.
"use strict";
const fs = require("fs");
const path = require("path");
const katex = require("katex");

const [out, ...files] = process.argv.slice(2);
const fonts = ["Main-Regular", "Math-Italic", "Size1-Regular"];  // which the formulas of the templates use

function typeset(text, file) {
  return text.replace(/\\\((.*?)\\\)/gs, (_, tex) => {
    const html = katex.renderToString(tex, {throwOnError: true, strict: "error"});
    if (html.includes("{{")) throw new Error(`${file}: the formula ${tex} has two braces in a row, which a template takes for a marker`);
    return html;
  });
}

/// With the fonts inside; other ones would be asked for at the network.
function styleOfFormulas() {
  const folder = path.dirname(require.resolve("katex/dist/katex.min.css"));
  const css = fs.readFileSync(path.join(folder, "katex.min.css"), "utf8");
  return css.replace(/@font-face\{.*?\}/gs, (face) => {
    const font = /fonts\/KaTeX_([\w-]+)\.woff2/.exec(face)[1];
    if (!fonts.includes(font)) return "";
    const data = fs.readFileSync(path.join(folder, "fonts", `KaTeX_${font}.woff2`)).toString("base64");
    return face.replace(/src:.*?(?=[;}])/s, `src:url(data:font/woff2;base64,${data}) format("woff2")`);
  });
}

const parts = {
  "d3.js": fs.readFileSync(require.resolve("d3/dist/d3.min.js"), "utf8"),
  "mustache.js": fs.readFileSync(require.resolve("mustache/mustache.min.js"), "utf8"),
  "katex.css": styleOfFormulas(),
};
const templates = {};
for (const file of files) {
  const text = fs.readFileSync(file, "utf8"), {name, base} = path.parse(file);
  if (file.endsWith(".html") && name !== "page") templates[name] = typeset(text, file);
  else parts[base] = text;
}
parts["templates.js"] = `const templates = ${JSON.stringify(templates).replace(/</g, "\\u003c")};\n`;
for (const [name, text] of Object.entries(parts))
  if (name.endsWith(".js") && /<\/script|<!--/i.test(text)) throw new Error(`${name}: would end the script of a page`);

const filled = (piece) => piece.replace(/\{\{(.*?)\}\}/g, (_, name) => parts[name]);
const pieces = parts["page.html"].split(/\{\{(?:title|words|document)\}\}/).map((piece) => `      ${JSON.stringify(filled(piece))},`);
fs.writeFileSync(out, `#include "comparison/report/text/page.h"

namespace fretval {

const std::array<std::string_view, 4>& page_pieces() {
  static const std::array<std::string_view, 4> pieces{
${pieces.join("\n")}
  };
  return pieces;
}

}  // namespace fretval
`);
