// Shows the page that sections.js makes of the data in it, and draws its plots. A plot has its series, or a kind of its
// own: "map" (zones of the rings over time), "bars" (shares that add up). Values and units are as the C++ writes them
// (json_of in plots.cc).
"use strict";
(() => {
  // Okabe and Ito's palette, distinguishable with colour-blind eyes, for a light and for a dark page: report.css.
  const n_colours = 9;
  const colour = (k) => `var(--c${k % n_colours})`;
  const zones = {s: ["sticks", "var(--sticks)"], f: ["slips forward", "var(--forward)"], b: ["slips backward", "var(--backward)"], o: ["open", "var(--paper)"]};
  const isDrawn = (v) => v !== null && Number.isFinite(v);
  const number = (v) => Math.abs(v) >= 1e5 || (v !== 0 && Math.abs(v) < 1e-3) ? d3.format(".3e")(v).replace("e+", "e") : String(+v.toPrecision(5));

  /// "c_{FE}" and "φ_0" have subscripts.
  function rich(node, text) {
    let raised = null;
    for (const [, plain, many, one] of text.matchAll(/([^_]+)|_\{([^}]*)\}|_(.)/gu)) {
      const part = node.append("tspan").text(plain ?? many ?? one).attr("dy", plain ? raised : "0.25em");
      if (!plain) part.attr("font-size", "80%");
      raised = plain ? null : "-0.2em";
    }
  }
  /// The same outside of a drawing.
  function richWords(node, text) {
    for (const [, plain, many, one] of text.matchAll(/([^_]+)|_\{([^}]*)\}|_(.)/gu)) {
      if (plain) node.node().append(plain);
      else node.append("sub").text(many ?? one);
    }
  }
  const flat = (text) => text.replace(/_\{([^}]*)\}|_(.)/gu, (_, many, one) => many ?? one);

  /// Above a plot: its title, and buttons that save what `rows` and `svg` return, its data and itself.
  function head(root, plot, rows, svg) {
    const bar = root.append("div").attr("class", "head");
    bar.append("div").attr("class", "title").text(flat(plot.title));
    const tools = bar.append("div").attr("class", "tools");
    const quoted = (v) => (typeof v === "string" ? `"${v.replace(/"/g, '""')}"` : v ?? "");
    const csv = () => rows().map((row) => row.map(quoted).join(",")).join("\n") + "\n";
    for (const [kind, type, part, text] of [["CSV", "text/csv", "the data of ", csv], ["SVG", "image/svg+xml", "", svg]])
      tools.append("button").attr("type", "button").text(kind).attr("title", `save ${part}this plot as ${kind}`).attr("aria-label", `save ${part}${flat(plot.title)} as ${kind}`)
        .on("click", () => download(text(), type, flat(plot.title).replace(/[^\p{L}\p{N}]+/gu, "-").toLowerCase() + "." + kind.toLowerCase()));
    return tools;
  }
  function download(text, type, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([text], {type}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }

  /// A plot as it is now, as a file that needs neither this page nor its style: light, with title and legend above it.
  /// draw: draws it anew; entries: of the legend, a label and what draws its mark; title: with what a slider has chosen.
  function standalone(element, draw, entries, title) {
    const root = d3.select(element).classed("light", true);
    place = "file";
    draw();
    const canvas = root.select("svg.canvas"), [, , width, height] = canvas.attr("viewBox").split(" ").map(Number), edge = 12;
    const sheet = root.append("svg").attr("role", "img");
    sheet.append("title").text(canvas.attr("aria-label"));
    const back = sheet.append("rect").attr("width", width).attr("fill", "var(--paper)");
    const head = sheet.append("text").attr("class", "name").attr("x", edge).attr("y", 24).style("font-size", "15px").style("font-weight", 600);
    rich(head, title);
    head.style("font-size", `${15 * Math.min(1, (width - 2 * edge) / head.node().getComputedTextLength())}px`);
    let x = edge, y = 38;
    for (const {label, mark} of entries) {
      const one = sheet.append("g"), text = one.append("text").attr("class", "name").attr("x", 28).attr("y", 9);
      mark(one);
      rich(text, label);
      const length = 28 + text.node().getComputedTextLength();
      if (x > edge && x + length > width - edge) [x, y] = [edge, y + 19];
      one.attr("transform", `translate(${x},${y})`);
      x += length + 18;
    }
    const top = y + (entries.length ? 18 : 0), drawing = sheet.append("g").attr("transform", `translate(0,${top})`).node();
    canvas.selectAll(".aid").remove();
    drawing.append(...canvas.node().childNodes);
    sheet.attr("viewBox", `0 0 ${width} ${top + height}`).attr("width", width).attr("height", top + height);
    back.attr("height", top + height);
    const copy = sheet.node().cloneNode(true);
    styleAs(sheet.node(), copy);
    copy.setAttributeNS("http://www.w3.org/XML/1998/namespace", "xml:space", "preserve");
    copy.setAttribute("font-family", "Segoe UI, Roboto, Helvetica Neue, Arial, sans-serif");
    sheet.remove();
    root.classed("light", false);
    place = "screen";
    draw();
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + new XMLSerializer().serializeToString(copy) + "\n";
  }
  const inherited = ["fill", "fill-opacity", "stroke", "stroke-width", "stroke-opacity", "stroke-dasharray", "stroke-linejoin", "font-size", "font-weight", "text-anchor"];
  /// What the style sheet says of an element, and of those in it, as attributes of its copy.
  function styleAs(element, copy, above = {}) {
    const own = getComputedStyle(element);
    for (const name of inherited) own[name] === above[name] ? copy.removeAttribute(name) : copy.setAttribute(name, own[name]);
    for (const name of ["class", "style", "tabindex", "font-family"]) copy.removeAttribute(name);
    for (const {name, value} of [...copy.attributes]) copy.setAttribute(name, value.replace(/\d+\.\d{3,}/g, (v) => String(+(+v).toFixed(2))));
    [...element.children].forEach((child, k) => styleAs(child, copy.children[k], own));
  }

  // On paper, half or all of its breadth, whatever the screen was: 12 pixels are 9 points there. In a file, one breadth.
  let place = "screen";
  function sizeOf(element) {
    const width = place === "paper" ? (element.closest("figure").matches(".wide") ? 680 : 330) : place === "file" ? +(element.dataset.width ?? 640) : Math.max(280, Math.round(element.clientWidth || 480));
    return {width, height: Math.round(Math.min(380, Math.max(place === "paper" ? 200 : 230, width * (place === "paper" ? 0.5 : 0.62))))};
  }

  function canvas(root, plot, width, height, margin) {
    const svg = root.append("svg").attr("viewBox", `0 0 ${width} ${height}`).attr("role", "img").attr("aria-label", `${flat(plot.title)}: ${flat(plot.y_label ?? "")} over ${flat(plot.x_label ?? "")}`);
    const label = (text, x, y, turn) => {
      const node = svg.append("text").attr("class", "name").attr("text-anchor", "middle").attr("transform", `translate(${x},${y}) rotate(${turn})`);
      rich(node, text);
    };
    if (plot.x_label) label(plot.x_label, (margin.left + width - margin.right) / 2, height - 6, 0);
    if (plot.y_label) label(plot.y_label, 13, (margin.top + height - margin.bottom) / 2, -90);
    return svg;
  }
  /// Fewer labels on a logarithmic axis: powers of ten.
  function ticks(axis, scale, n, given) {
    if (given) return axis.tickValues(given).tickFormat(d3.format("~g"));
    if (!scale.base) return axis.ticks(n).tickFormat((v) => (Math.abs(v) >= 1e4 || (v !== 0 && Math.abs(v) < 1e-3) ? d3.format(".1~e")(v) : d3.format("~r")(+v.toPrecision(9))).replace("e+", "e"));
    const [low, high] = scale.domain().map(Math.log10), written = (v) => (v >= 0.001 && v <= 1000 ? d3.format("~g")(+v.toPrecision(6)) : (+v.toPrecision(6)).toExponential().replace("e+", "e"));
    const step = Math.max(1, Math.ceil((high - low) / n));
    const powers = d3.range(Math.ceil(low - 1e-9), high + 1e-9, 1).filter((k) => k % step === 0).map((k) => 10 ** k);
    if (powers.length >= 2) return axis.tickValues(powers).tickFormat(written);
    // Less than a decade or two: as many round values as there is room for.
    const decades = d3.range(Math.floor(low), Math.ceil(high) + 1), inside = (v) => Math.log10(v) >= low - 1e-9 && Math.log10(v) <= high + 1e-9;
    const choices = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 3, 5, 7], [1, 2, 5], [1, 3]].map((digits) => decades.flatMap((k) => digits.map((d) => d * 10 ** k)).filter(inside));
    const chosen = choices.find((values) => values.length <= n && values.length >= 2) ?? (choices[0].length < 2 ? d3.ticks(10 ** low, 10 ** high, Math.min(3, n)) : choices[0].filter((v, i, all) => i === 0 || i === all.length - 1));
    return axis.tickValues(chosen).tickFormat(written);
  }
  function axes(svg, x, y, width, height, margin, plot) {
    svg.append("g").attr("transform", `translate(0,${height - margin.bottom})`).call(ticks(d3.axisBottom(x).tickSizeInner(-(height - margin.top - margin.bottom)).tickPadding(7), x, Math.max(3, width / 95), plot.x_tics));
    svg.append("g").attr("transform", `translate(${margin.left},0)`).call(ticks(d3.axisLeft(y).tickSizeInner(-(width - margin.left - margin.right)).tickPadding(6), y, 6));
    svg.selectAll(".tick text").attr("class", "value");
  }
  function symbol(node, series, x, y) {
    const open = series.style === "open points", triangle = series.style === "triangles";
    return node.append("path").attr("d", d3.symbol().type(triangle ? d3.symbolTriangle : d3.symbolCircle).size(triangle ? 60 : series.style === "small points" ? 6 : 22))
      .attr("transform", `translate(${x},${y})`).attr("fill", open ? "var(--paper)" : colour(series.colour)).attr("stroke", colour(series.colour)).attr("stroke-width", 1.3);
  }
  const hasLine = (series) => /line|dashed/.test(series.style);
  const hasPoints = (series) => /points|triangles/.test(series.style);

  // Marks of a legend, 22 by 10.
  const markOf = (series) => (svg) => {
    if (hasLine(series)) svg.append("line").attr("x1", 0).attr("x2", 22).attr("y1", 5).attr("y2", 5).attr("stroke", colour(series.colour)).attr("stroke-width", 2).attr("stroke-dasharray", series.style === "dashed" ? "5 3" : null);
    if (hasPoints(series)) symbol(svg, series, 11, 5);
  };
  const areaMark = (fill, stroke) => (svg) => svg.append("rect").attr("width", 22).attr("height", 10).attr("fill", fill).attr("stroke", stroke);
  const swatch = (node, mark) => mark(node.append("svg").attr("viewBox", "0 0 22 10").attr("aria-hidden", "true"));
  function legendOf(root, entries) {
    const legend = root.append("div").attr("class", "legend");
    for (const {label, mark} of entries) {
      const one = legend.append("span");
      swatch(one, mark);
      one.append("span").style("padding", 0).text(label);
    }
  }

  function tooltip(root) {
    const tip = root.append("div").attr("class", "tip").attr("role", "status").attr("hidden", "");
    return {
      show(lines, x, y, width) {
        tip.attr("hidden", null).text(null);
        for (const line of lines) tip.append("div").text(line);
        const scale = root.select("svg.canvas").node().getBoundingClientRect(), outer = root.node().getBoundingClientRect();
        const factor = scale.width / width, own = tip.node().offsetWidth;
        const left = Math.min(Math.max(0, scale.left - outer.left + x * factor + 12), Math.max(0, outer.width - own));
        tip.style("left", `${left}px`).style("top", `${scale.top - outer.top + y * factor - 14 - tip.node().offsetHeight}px`);
      },
      hide: () => tip.attr("hidden", ""),
    };
  }

  function drawSeries(element, plot) {
    const root = d3.select(element);
    const state = {off: new Set(), zoom: null, frame: plot.frames?.start ?? 0};
    const yOf = (k) => plot.frames?.y[k]?.[state.frame] ?? plot.series[k].y;
    const tools = head(root, plot, () => [["series", flat(plot.x_label), flat(plot.y_label), "error bar"], ...plot.series.flatMap((s, k) => s.x.map((x, i) => [flat(s.label), x, yOf(k)[i], s.bar?.[i]]))],
      () => standalone(element, draw, plot.series.flatMap((s, k) => (s.label && !state.off.has(k) ? [{label: s.label, mark: markOf(s)}] : [])), plot.title + (plot.frames ? `, ${plot.frames.names[state.frame]}` : "")));
    const reset = tools.insert("button", ":first-child").attr("type", "button").attr("class", "whole").text("whole").attr("title", "show all of the plot again").attr("hidden", "").on("click", () => { state.zoom = null; draw(); });
    const legend = root.append("div").attr("class", "legend");
    plot.series.forEach((series, k) => {
      if (!series.label) return;
      const button = legend.append("button").attr("type", "button").attr("aria-pressed", "true").attr("title", "show or hide");
      swatch(button, markOf(series));
      richWords(button.append("span").style("padding", 0).style("display", "block"), series.label);
      button.on("click", () => {
        state.off.has(k) ? state.off.delete(k) : state.off.add(k);
        // Series without a name of their own belong to the one before.
        for (let n = k + 1; n < plot.series.length && !plot.series[n].label; ++n) state.off.has(k) ? state.off.add(n) : state.off.delete(n);
        button.attr("aria-pressed", state.off.has(k) ? "false" : "true");
        draw();
      });
    });
    const area = root.append("div");
    const tip = tooltip(root);
    if (plot.frames) {
      const row = root.append("label").attr("class", "frames");
      row.append("span").text(plot.frames.label);
      const shown = row.append("output").text(plot.frames.names[state.frame]);
      row.insert("input", "output").attr("type", "range").attr("min", 0).attr("max", plot.frames.names.length - 1).property("value", state.frame)
        .on("input", function () { state.frame = +this.value; shown.text(plot.frames.names[state.frame]); draw(); });
    }

    // A plane: of two ranges that are given around 0 the one of x is made as long as there is room beside that of y.
    function widened(range, width, height) {
      return plot.equal_scales && !state.zoom ? range.map((v) => v * width / height) : range;
    }
    function domain(axis, values) {
      if (plot[axis + "_range"]) return plot[axis + "_range"];
      const log = plot["log_" + axis];
      const [low, high] = d3.extent(values.filter((v) => isDrawn(v) && (!log || v > 0)));
      if (low === undefined) return log ? [1, 10] : [0, 1];
      if (log) return low === high ? [low / 2, high * 2] : [low / (high / low) ** 0.04, high * (high / low) ** 0.04];
      if (axis === "x") return low >= 0 && low < 0.1 * high ? [0, high] : low === high ? [low - 1, high + 1] : [low, high];
      // What is constant to a percent looks constant; whoever doubts zooms in.
      const pad = Math.max((high - low) * 0.05, 0.005 * Math.abs(high)) || 1;
      return [low >= 0 && low < 0.3 * high ? 0 : low - pad, high + pad];
    }
    function draw() {
      const size = sizeOf(element), width = size.width, height = plot.equal_scales ? Math.max(size.height, Math.min(width, 480)) : size.height;
      const margin = {left: 62, right: 16, top: plot.marks ? 22 : 10, bottom: 42};
      const span = plot.log_y ? null : state.zoom?.y ?? plot.y_range ?? d3.extent(plot.series.flatMap((s) => s.y).filter(isDrawn));
      if (span?.[0] !== undefined && span && span[1] - span[0] < 0.02 * Math.abs(span[1])) margin.left = 84;
      area.selectAll("*").remove();
      tip.hide();
      const svg = canvas(area, plot, width, height, margin).attr("class", "canvas");
      const all = plot.series.map((s, k) => (plot.frames?.y[k] ? plot.frames.y[k].flat() : s.bar ? s.y.flatMap((v, i) => isDrawn(v) ? [v - (s.bar[i] ?? 0), v + (s.bar[i] ?? 0)] : []) : s.y));
      const xs = widened(state.zoom?.x ?? domain("x", plot.series.flatMap((s) => s.x)), width - margin.left - margin.right, height - margin.top - margin.bottom), ys = (state.zoom?.y ?? domain("y", all.flat()));
      const x = (plot.log_x ? d3.scaleLog() : d3.scaleLinear()).domain(xs).range([margin.left, width - margin.right]);
      const y = (plot.log_y ? d3.scaleLog() : d3.scaleLinear()).domain(ys).range([height - margin.bottom, margin.top]);
      axes(svg, x, y, width, height, margin, plot);
      const clip = `clip-${element.dataset.plot}`;
      svg.append("clipPath").attr("id", clip).append("rect").attr("x", margin.left - 5).attr("y", margin.top - 5).attr("width", width - margin.left - margin.right + 10).attr("height", height - margin.top - margin.bottom + 10);
      for (const mark of plot.marks ?? []) {
        if (mark.x < xs[0] || mark.x > xs[1]) continue;
        svg.append("line").attr("x1", x(mark.x)).attr("x2", x(mark.x)).attr("y1", margin.top).attr("y2", height - margin.bottom).attr("stroke", "var(--axis)").attr("stroke-dasharray", "2 3");
        rich(svg.append("text").attr("text-anchor", "middle").attr("x", x(mark.x)).attr("y", margin.top - 7), mark.name);
      }
      const marks = svg.append("g").attr("clip-path", `url(#${clip})`).append("g");
      const points = [];
      plot.series.forEach((series, k) => {
        if (state.off.has(k)) return;
        const values = yOf(k);
        const drawn = series.x.map((v, i) => [v, values[i], i]).map((p) => (isDrawn(p[0]) && isDrawn(p[1]) && (!plot.log_x || p[0] > 0) && (!plot.log_y || p[1] > 0) ? p : null));
        if (hasLine(series))
          marks.append("path").attr("fill", "none").attr("stroke", colour(series.colour)).attr("stroke-width", series.style === "thin line" ? 0.7 : 1.8).attr("stroke-linejoin", "round").attr("stroke-dasharray", series.style === "dashed" ? "6 4" : null)
            .attr("d", d3.line().defined((p) => p !== null).x((p) => x(p[0])).y((p) => y(p[1]))(drawn));
        for (const p of drawn) {
          if (!p) continue;
          const bar = series.bar?.[p[2]];
          if (bar) marks.append("line").attr("x1", x(p[0])).attr("x2", x(p[0])).attr("y1", y(p[1] - bar)).attr("y2", y(p[1] + bar)).attr("stroke", colour(series.colour)).attr("stroke-width", 1.2);
          if (hasPoints(series)) symbol(marks, series, x(p[0]), y(p[1]));
          points.push({x: x(p[0]), y: y(p[1]), series, k, values: p, bar});
        }
      });
      const visible = points.filter((p) => p.x >= margin.left - 1 && p.x <= width - margin.right + 1 && p.y >= margin.top - 1 && p.y <= height - margin.bottom + 1);
      const ring = svg.append("circle").attr("class", "aid").attr("r", 5).attr("fill", "none").attr("stroke", "var(--ink)").attr("stroke-width", 1.5).attr("display", "none").attr("pointer-events", "none");
      const name = (k) => { while (k > 0 && !plot.series[k].label) --k; return flat(plot.series[k].label); };
      const show = (p) => {
        ring.attr("display", p ? null : "none").attr("cx", p?.x).attr("cy", p?.y);
        if (!p) return tip.hide();
        const own = hasPoints(p.series) && !p.series.label ? "points, " : "";
        tip.show([own + name(p.k), `${flat(plot.x_label)}: ${number(p.values[0])}`, `${flat(plot.y_label)}: ${number(p.values[1])}${p.bar ? " ± " + d3.format(".1~e")(p.bar) : ""}`], p.x, p.y, width);
      };
      const brush = d3.brush().extent([[margin.left, margin.top], [width - margin.right, height - margin.bottom]]).touchable(false)
        .on("end", () => {
          const s = d3.event.selection;
          if (!s) return;
          if (s[1][0] - s[0][0] > 8 && s[1][1] - s[0][1] > 8) state.zoom = {x: [x.invert(s[0][0]), x.invert(s[1][0])], y: [y.invert(s[1][1]), y.invert(s[0][1])]};
          draw();
        });
      const layer = svg.append("g").attr("class", "aid").call(brush).style("touch-action", null);
      layer.selectAll(".selection").attr("fill", "var(--accent)").attr("stroke", "var(--accent)");
      pinches(svg, marks, ({k, from, to}) => {
        const window = (scale, ends, axis) => ends.map((end) => scale.invert(from[axis] + (end - to[axis]) / k));
        state.zoom = k > 1 || state.zoom ? {x: window(x, x.range(), 0), y: window(y, y.range(), 1)} : null;
        draw();
      });
      picks(svg, (px, py) => {
        let best = null, least = 40 ** 2;
        for (const p of visible) {
          const distance = (p.x - px) ** 2 + (p.y - py) ** 2;
          if (distance < least) [best, least] = [p, distance];
        }
        return best;
      }, (p, dx, dy) => {
        if (!p) return visible[0] ?? null;
        if (dx) return visible[Math.min(visible.length - 1, Math.max(0, visible.indexOf(p) + dx))];
        const shown = [...new Set(visible.map((q) => q.k))], next = shown[(shown.indexOf(p.k) - dy + shown.length) % shown.length];
        return visible.filter((q) => q.k === next).sort((q, r) => Math.abs(q.x - p.x) - Math.abs(r.x - p.x))[0];
      }, show);
      svg.on("dblclick", () => { state.zoom = null; draw(); });
      reset.attr("hidden", state.zoom ? null : "");
      if (!points.length) svg.append("text").attr("x", width / 2).attr("y", height / 2).attr("text-anchor", "middle").text("no data");
    }
    return draw;
  }

  /// Two fingers stretch and move the marks; what was under them stays there. done: told the factor k and the middle of
  /// the fingers before and after. One finger is left to the page, which scrolls.
  function pinches(svg, marks, done) {
    let start = null, pinch = null;
    const grip = () => {
      const [a, b] = d3.touches(svg.node());
      return {middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], size: Math.hypot(a[0] - b[0], a[1] - b[1])};
    };
    svg.on("touchstart.pinch touchmove.pinch", () => {
      if (d3.event.touches.length !== 2) return;
      d3.event.preventDefault();
      const now = grip();
      start = start ?? now;
      pinch = {k: now.size / start.size, from: start.middle, to: now.middle};
      marks.attr("transform", `translate(${pinch.to}) scale(${pinch.k}) translate(${pinch.from.map((v) => -v)})`);
    }).on("touchend.pinch touchcancel.pinch", () => {
      if (pinch) done(pinch);
      start = pinch = null;
    });
  }

  /// A drawing of pieces that the pointer, a finger and the arrow keys pick. at: the piece under a point, or null;
  /// next: the piece that a key (dx, dy) goes to from one, which is null at first; show: says what is picked, null: nothing.
  function picks(svg, at, next, show) {
    let picked = null;
    const pick = (piece) => { picked = piece; show(piece); };
    svg.attr("tabindex", 0).style("touch-action", "pan-y");
    svg.on("mousemove touchstart", () => pick(at(...(d3.event.touches ? d3.touches(svg.node())[0] : d3.mouse(svg.node())))))
      .on("mouseleave blur", () => pick(null))
      .on("keydown", () => {
        const dx = {ArrowRight: 1, ArrowLeft: -1}[d3.event.key] ?? 0, dy = {ArrowUp: 1, ArrowDown: -1}[d3.event.key] ?? 0;
        if (d3.event.key === "Escape") return pick(null);
        if (!dx && !dy) return;
        d3.event.preventDefault();
        pick(next(picked, dx, dy));
      });
  }
  /// Around what is picked.
  function outline(svg) {
    const box = svg.append("rect").attr("class", "aid picked").attr("fill", "none").attr("stroke", "var(--ink)").attr("stroke-width", 2).attr("display", "none").attr("pointer-events", "none");
    return (rect) => box.attr("display", rect ? null : "none").attr("x", rect?.x).attr("y", rect?.y).attr("width", rect?.width).attr("height", rect?.height);
  }

  function drawMap(element, plot) {
    const root = d3.select(element), n = plot.zones.length;
    const entries = [..."sfbo"].filter((z) => plot.zones.some((text) => text.includes(z))).map((z) => ({label: zones[z][0], mark: areaMark(zones[z][1], "var(--axis)")}));
    head(root, plot, () => [["step", ...plot.edges.map((r) => `to ${number(r)}`)], ...plot.zones.map((zone, k) => [k, ...zone.split("").map((z) => zones[z][0])])],
      () => standalone(element, draw, entries, plot.title));
    legendOf(root, entries);
    const area = root.append("div"), tip = tooltip(root);
    function draw() {
      const {width, height} = sizeOf(element);
      const margin = {left: 62, right: plot.marks ? 26 : 16, top: 10, bottom: 42};
      area.selectAll("*").remove();
      const svg = canvas(area, plot, width, height, margin).attr("class", "canvas");
      const x = d3.scaleLinear().domain([0, 1]).range([margin.left, width - margin.right]);
      const y = d3.scaleLinear().domain([0, plot.edges[plot.edges.length - 1] ?? 1]).range([height - margin.bottom, margin.top]);
      const step = (width - margin.left - margin.right) / n;
      plot.zones.forEach((text, k) => {
        for (let i = 0, begin = 0; i < text.length; ++i) {
          if (text[i + 1] === text[i]) continue;
          const inner = begin ? plot.edges[begin - 1] : 0;
          if (text[i] !== "o") svg.append("rect").attr("x", margin.left + k * step).attr("width", step + 0.3).attr("y", y(plot.edges[i])).attr("height", y(inner) - y(plot.edges[i])).attr("fill", zones[text[i]][1]).attr("shape-rendering", "crispEdges");
          begin = i + 1;
        }
      });
      axes(svg, x, y, width, height, margin, plot);
      svg.selectAll(".tick line").attr("stroke-opacity", 0.25);
      for (const mark of plot.marks ?? []) {
        // Seen on dark zones and on light ones.
        svg.append("line").attr("x1", margin.left).attr("x2", width - margin.right).attr("y1", y(mark.x)).attr("y2", y(mark.x)).attr("stroke", "var(--axis)").attr("stroke-width", 1.5).attr("stroke-dasharray", "6 4");
        rich(svg.append("text").attr("class", "name").attr("x", width - margin.right + 6).attr("y", y(mark.x) + 4).style("font-weight", 600), mark.name);
      }
      const frame = outline(svg), m = plot.edges.length, middle = (i) => (plot.edges[i] + (i ? plot.edges[i - 1] : 0)) / 2;
      const within = (v, end) => Math.min(end - 1, Math.max(0, v));
      const stride = [Math.max(1, Math.round(n / 48)), Math.max(1, Math.round(m / 32))];
      picks(svg, (px, py) => {
        const k = Math.floor(x.invert(px) * n), r = y.invert(py), i = plot.edges.findIndex((edge) => r <= edge);
        return k < 0 || k >= n || r < 0 || i < 0 ? null : {k, i};
      }, (p, dx, dy) => (p ? {k: within(p.k + dx * stride[0], n), i: within(p.i + dy * stride[1], m)} : {k: 0, i: 0}), (p) => {
        if (!p) { frame(null); return tip.hide(); }
        const top = y(plot.edges[p.i]), bottom = y(p.i ? plot.edges[p.i - 1] : 0);
        frame({x: margin.left + p.k * step, y: top, width: Math.max(2, step), height: Math.max(2, bottom - top)});
        tip.show([zones[plot.zones[p.k][p.i]][0], `${flat(plot.x_label)}: ${number(p.k / n)}`, `${flat(plot.y_label)}: ${number(middle(p.i))}`], margin.left + p.k * step, top, width);
      });
    }
    return draw;
  }

  function drawBars(element, plot) {
    const root = d3.select(element);
    const entries = plot.sources.map((label, k) => ({label, mark: areaMark(colour(k), null)}));
    head(root, plot, () => [["quantity", ...plot.sources], ...plot.rows.map((row) => [row.label, ...row.shares])], () => standalone(element, draw, entries, plot.title));
    legendOf(root, entries);
    const area = root.append("div"), tip = tooltip(root);
    function draw() {
      const {width} = sizeOf(element), narrow = width < 480, line = narrow ? 48 : 34;
      const margin = {left: narrow ? 12 : 190, right: 20, top: 6, bottom: 42}, height = margin.top + margin.bottom + line * plot.rows.length;
      area.selectAll("*").remove();
      const svg = canvas(area, plot, width, height, margin).attr("class", "canvas");
      const ends = plot.rows.flatMap((row) => { let at = row.start; const steps = row.shares.map((share) => (at += share)); return [row.start, ...steps, at - row.bar, at + row.bar]; });
      const x = d3.scaleLinear().domain([1.05 * Math.min(0, d3.min(ends)), 1.05 * Math.max(plot.limit, d3.max(ends))]).range([margin.left, width - margin.right]);
      svg.append("g").attr("transform", `translate(0,${height - margin.bottom})`).call(ticks(d3.axisBottom(x).tickSizeInner(-(height - margin.top - margin.bottom)).tickPadding(7), x, width / 110));
      svg.append("line").attr("x1", x(plot.limit)).attr("x2", x(plot.limit)).attr("y1", margin.top).attr("y2", height - margin.bottom).attr("stroke", "var(--ink)").attr("stroke-dasharray", "4 3");
      const pieces = [];
      plot.rows.forEach((row, k) => {
        const top = margin.top + k * line + (narrow ? 22 : 8);
        svg.append("text").attr("class", "name").attr("x", narrow ? margin.left : margin.left - 8).attr("y", narrow ? top - 6 : top + 14).attr("text-anchor", narrow ? "start" : "end").text(row.label);
        let sum = row.start;
        row.shares.forEach((share, source) => {
          const piece = {k, row, source, share, x: Math.min(x(sum), x(sum + share)), y: top, width: Math.abs(x(sum + share) - x(sum)), height: 18};
          svg.append("rect").attr("x", piece.x).attr("width", piece.width).attr("y", top).attr("height", piece.height).attr("fill", colour(source));
          if (share) pieces.push(piece);
          sum += share;
        });
        if (row.bar) svg.append("line").attr("x1", x(sum - row.bar)).attr("x2", x(sum + row.bar)).attr("y1", top + 9).attr("y2", top + 9).attr("stroke", "var(--ink)").attr("stroke-width", 2);
      });
      // A finger is wider than most shares.
      const apart = (v, low, size) => Math.max(low - v, 0, v - low - size), reach = 16;
      const nearest = (px, py) => {
        const far = (p) => Math.hypot(apart(px, p.x, p.width), apart(py, p.y, p.height));
        const best = pieces[d3.scan(pieces, (a, b) => far(a) - far(b))];
        return best && far(best) <= reach ? best : null;
      };
      const frame = outline(svg);
      picks(svg, nearest, (p, dx, dy) => {
        if (!p) return pieces[0] ?? null;
        if (dx) return pieces[Math.min(pieces.length - 1, Math.max(0, pieces.indexOf(p) + dx))];
        return pieces.find((q) => q.k === p.k - dy) ?? p;
      }, (p) => {
        frame(p);
        if (!p) return tip.hide();
        tip.show([p.row.label, `${plot.sources[p.source]}: ${number(p.share)} ${plot.of_what}`], p.x + p.width / 2, p.y, width);
      });
    }
    return draw;
  }

  const kinds = {map: drawMap, bars: drawBars};
  const {header, main, plots} = shownPage(JSON.parse(document.getElementById("data").textContent));
  document.querySelector("header").innerHTML = header;
  document.querySelector("main").innerHTML = main;
  const draws = new Map();
  const observer = new ResizeObserver((entries) => entries.forEach(({target, contentRect}) => {
    const known = draws.get(target);
    if (contentRect.width && Math.abs(known.width - contentRect.width) > 1 && !window.matchMedia("print").matches) {
      known.width = contentRect.width;
      known.draw();
    }
  }));
  for (const element of document.querySelectorAll("[data-plot]")) {
    const plot = plots[element.dataset.plot];
    const known = {draw: (kinds[plot.kind] ?? drawSeries)(element, plot), width: element.clientWidth};
    known.draw();
    draws.set(element, known);
    observer.observe(element);
  }
  // A finger does not leave a plot as a pointer does: it touches elsewhere.
  document.addEventListener("touchstart", ({target}) => {
    for (const svg of document.querySelectorAll("[data-plot] svg.canvas")) if (!svg.contains(target)) svg.dispatchEvent(new MouseEvent("mouseleave"));
  }, {passive: true});
  // What is folded is printed all the same.
  const folded = [];
  function drawAll(onPaper) {
    place = onPaper ? "paper" : "screen";
    draws.forEach(({draw}) => draw());
  }
  window.addEventListener("beforeprint", () => {
    document.querySelectorAll("details:not([open]):not(.long)").forEach((details) => { details.open = true; folded.push(details); });
    drawAll(true);
  });
  window.addEventListener("afterprint", () => {
    for (const details of folded.splice(0)) details.open = false;
    drawAll(false);
  });
  document.documentElement.dataset.plotsDrawn = document.querySelectorAll("[data-plot] svg.canvas").length;
})();
