// Build step: node embed.js OUT.cc FILE...: the files, d3 and KaTeX's style sheet as strings of the program (resources.h).
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

const resources = {
  "d3.js": fs.readFileSync(require.resolve("d3/dist/d3.min.js"), "utf8"),
  "katex.css": styleOfFormulas(),
};
for (const file of files) {
  const text = fs.readFileSync(file, "utf8");
  resources[path.basename(file)] = file.endsWith(".html") ? typeset(text, file) : text;
}
for (const [name, text] of Object.entries(resources))
  if (name.endsWith(".js") && /<\/script|<!--/i.test(text)) throw new Error(`${name}: would end the script of a page`);

const lines = Object.entries(resources).map(([name, text]) => `      {${JSON.stringify(name)}, ${JSON.stringify(text)}},`);
fs.writeFileSync(out, `#include "comparison/report/text/resources.h"

namespace fretval {

const std::map<std::string, std::string_view>& resources() {
  static const std::map<std::string, std::string_view> all{
${lines.join("\n")}
  };
  return all;
}

}  // namespace fretval
`);
