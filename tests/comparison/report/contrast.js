// Appended to a report that has been drawn: what is harder to see than WCAG 2.1 AA allows, in an attribute of its body.
// Text: 4.5 to its background, 3 if it is large (24 px, or 18.66 px and bold). Lines and areas of figures: 3 to theirs;
// but for grids, and areas and bars that are faint because a line beside them says the same.
addEventListener("load", () => setTimeout(() => {
  const parsed = (text) => (text.match(/[\d.]+/g) || []).map(Number);
  const luminance = (rgb) => {
    const [r, g, b] = rgb.map((x) => (x / 255 <= 0.03928 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ratio = (a, b) => {
    const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
    return (high + 0.05) / (low + 0.05);
  };
  const over = (colour, alpha, below) => colour.map((x, i) => alpha * x + (1 - alpha) * below[i]);
  const background = (element) => {
    if (!element) return [255, 255, 255];
    const [r, g, b, alpha = 1] = parsed(getComputedStyle(element).backgroundColor);
    return r === undefined || alpha === 0 ? background(element.parentElement) : over([r, g, b], alpha, background(element.parentElement));
  };
  const opacity = (element) => (element ? Number(getComputedStyle(element).opacity) * opacity(element.parentElement) : 1);
  const seen = (element) => element.getClientRects().length > 0 && getComputedStyle(element).visibility === "visible";
  const failures = new Set();
  const counts = {texts: 0, marks: 0};
  const examine = (element, paint, alpha, least, kind) => {
    const [r, g, b, own = 1] = parsed(paint);
    if (r === undefined) return;
    const behind = background(element.parentElement && kind === "marks" ? element.parentElement : element);
    const found = ratio(over([r, g, b], own * alpha * opacity(element), behind), behind);
    ++counts[kind];
    if (found < least) failures.add(`${kind} ${element.tagName}.${element.getAttribute("class") || ""} ${paint} on ${behind}: ${found.toFixed(2)} of ${least}`);
  };
  for (const details of document.querySelectorAll("details")) details.open = true;
  for (const element of document.body.querySelectorAll("*")) {
    const own = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent.trim());
    if (!own || !seen(element) || ["SCRIPT", "STYLE"].includes(element.tagName)) continue;
    const style = getComputedStyle(element), size = parseFloat(style.fontSize);
    const large = size >= 24 || (size >= 18.66 && Number(style.fontWeight) >= 700);
    examine(element, element instanceof SVGElement ? style.fill : style.color, 1, large ? 3 : 4.5, "texts");
  }
  for (const element of document.querySelectorAll(".plot svg :is(path, line, rect, circle, polyline), .sketch :is(line, polyline, polygon)")) {
    if (element.closest(".tick, defs, [aria-pressed='false']") || !seen(element)) continue;
    const style = getComputedStyle(element), faint = 0.5;
    const alphas = {stroke: Number(style.strokeOpacity), fill: Number(style.fillOpacity)};
    const painted = ["stroke", "fill"].filter((way) => style[way] !== "none" && alphas[way] * opacity(element) > faint);
    if (painted.length === 0) continue;
    // A shape with an outline is seen by it.
    const way = painted[0];
    examine(element, style[way], alphas[way], 3, "marks");
  }
  document.body.dataset.contrast = JSON.stringify({...counts, failures: [...failures]});
}, 300));
