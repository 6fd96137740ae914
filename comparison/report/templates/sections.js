// Makes the page from its document: a part with a "template" becomes the HTML of that template, filled with what the
// part has. Text is escaped where it stands; {{{name}}} takes the HTML of a part within. A "plot" becomes its number
// in the list of plots, which report.js draws.
"use strict";
function shownPage({heading, sections}) {
  const plots = [];
  const shown = (part) => {
    if (part === null || typeof part !== "object") return part;
    if (Array.isArray(part)) return part.map(shown);
    const filling = Object.fromEntries(Object.entries(part).map(([name, value]) => [name, name === "plot" ? plots.push(value) - 1 : shown(value)]));
    return part.template ? Mustache.render(templates[part.template], filling) : filling;
  };
  return {header: shown(heading), main: shown(sections).join(""), plots};
}
