// What is wrong with the plots of a page on a telephone, as JSON: node touch.js PAGE.html PROFILE_FOLDER [FIRST_PLOTS]
// Chromium is told to be one: 390 pixels, fingers; its protocol is spoken through a pipe. Fingers are events of the
// browser, which makes scrolling and clicks of them as it does of those of a person.
"use strict";
const {spawn} = require("child_process");
const [page, profile, most] = process.argv.slice(2);
const screen = {width: 390, height: 844};
const browser = spawn("chromium", ["--headless=new", "--no-sandbox", "--disable-gpu", `--user-data-dir=${profile}`, "--remote-debugging-pipe"],
  {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});

const waiting = new Map(), problems = [];
let buffer = "", number = 0, session;
browser.stdio[4].on("data", (data) => {
  const messages = (buffer + data).split("\0");
  buffer = messages.pop();
  for (const message of messages.map((text) => JSON.parse(text))) {
    const key = message.id ?? message.method;
    waiting.get(key)?.(message.result ?? message.params ?? message);
    waiting.delete(key);
  }
});
const arrives = (key) => new Promise((resolve) => waiting.set(key, resolve));
function send(method, params = {}) {
  browser.stdio[3].write(JSON.stringify({id: ++number, method, params, ...(session && {sessionId: session})}) + "\0");
  return arrives(number);
}
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const look = async (script) => (await send("Runtime.evaluate", {expression: `(() => { ${script} })()`, returnByValue: true})).result.value;
const complain = (text) => problems.push(text);

const touch = (type, ...fingers) => send("Input.dispatchTouchEvent", {type, touchPoints: fingers.map(([x, y], id) => ({x, y, id}))});
async function tap(finger) {
  await touch("touchStart", finger);
  await touch("touchEnd");
  await pause(100);
}
async function drag(paths, n = 12) {
  const at = (s) => paths.map(([[x0, y0], [x1, y1]]) => [x0 + s * (x1 - x0), y0 + s * (y1 - y0)]);
  await touch("touchStart", ...at(0));
  for (let k = 1; k <= n; ++k) {
    await touch("touchMove", ...at(k / n));
    await pause(16);
  }
  await pause(150);  // held still, or the page would roll on
  await touch("touchMove", ...at(1));
  await touch("touchEnd");
  await pause(150);
}
const canvas = (k) => `const svg = document.querySelectorAll("[data-plot] svg.canvas")[${k}], plot = svg.closest("[data-plot]"), tip = plot.querySelector(".tip");`;
const told = (k) => look(`${canvas(k)} const box = tip.getBoundingClientRect(); return {text: tip.hidden ? "" : tip.innerText, left: box.left, right: box.right};`);
const ticks = (k) => look(`${canvas(k)} return [...svg.querySelectorAll(".tick text")].map((tick) => tick.textContent).join(" ");`);
/// A place where a pointer finds something, and what that is; the pointer then leaves.
const found = (k) => look(`${canvas(k)} const {left, top, width, height} = svg.getBoundingClientRect();
  for (const u of [0.3, 0.5, 0.7, 0.15, 0.85]) for (let v = 0.1; v < 0.9; v += 0.05) {
    const x = Math.round(left + u * width), y = Math.round(top + v * height);
    svg.dispatchEvent(new MouseEvent("mousemove", {clientX: x, clientY: y}));
    const text = tip.hidden ? "" : tip.innerText;
    svg.dispatchEvent(new MouseEvent("mouseleave"));
    if (text) return {place: [x, y], text};
  }
  return null;`);
/// In the middle of the screen.
async function box(k, part = "svg") {
  await look(`${canvas(k)} ${part}.scrollIntoView({block: "center", behavior: "instant"});`);
  await pause(30);
  return look(`${canvas(k)} const {left, top, width, height} = ${part}.getBoundingClientRect(); return {left, top, width, height};`);
}

/// A tap says what the pointer says there, within the screen, and a tap elsewhere ends that.
async function tapWherePointerFinds(k, name) {
  await box(k);
  const hovered = await found(k);
  if (!hovered) return complain(`${name}: the pointer finds nothing`);
  await tap(hovered.place);
  const tapped = await told(k);
  if (tapped.text !== hovered.text) complain(`${name}: a tap says "${tapped.text}", the pointer "${hovered.text}"`);
  if (tapped.left < 0 || tapped.right > screen.width) complain(`${name}: what a tap says goes from ${tapped.left} to ${tapped.right}`);
  await tap([4, 4]);
  if ((await told(k)).text) complain(`${name}: goes on after a tap elsewhere`);
}

async function scrollOver(k, name) {
  const {left, top, width, height} = await box(k);
  const from = [left + width / 2, top + height / 2], before = await look("return scrollY;");
  await drag([[from, [from[0], from[1] - 200]]]);
  if (await look("return scrollY;") < before + 100) complain(`${name}: the page does not scroll under a finger`);
}

/// Two fingers apart by a factor of three magnify; the button shows the whole again.
async function magnify(k, name) {
  const {left, top, width, height} = await box(k);
  const middle = [left + 0.55 * width, top + 0.45 * height], whole = await ticks(k);
  const finger = (sign) => [20, 60].map((d) => [middle[0] + sign * d, middle[1] + sign * d / 2]);
  await drag([finger(-1), finger(1)]);
  if (await ticks(k) === whole) return complain(`${name}: two fingers do not magnify it`);
  const button = await box(k, 'plot.querySelector(".whole")');
  await tap([button.left + button.width / 2, button.top + button.height / 2]);
  if (await ticks(k) !== whole) complain(`${name}: a tap on the button does not show the whole`);
}

async function slide(k, name) {
  const shown = () => look(`${canvas(k)} return plot.querySelector("output").textContent;`);
  const {left, top, width, height} = await box(k, 'plot.querySelector("input")'), y = top + height / 2;
  const before = await shown();
  await drag([[[left + 0.9 * width, y], [left + 0.2 * width, y]]]);
  const after = await shown();
  if (before === after) complain(`${name}: the slider does not follow a finger`);
}

async function examine() {
  const {targetInfos} = await send("Target.getTargets");
  session = (await send("Target.attachToTarget", {targetId: targetInfos.find((t) => t.type === "page").targetId, flatten: true})).sessionId;
  await send("Page.enable");
  await send("Emulation.setDeviceMetricsOverride", {...screen, deviceScaleFactor: 1, mobile: true});
  await send("Emulation.setTouchEmulationEnabled", {enabled: true, maxTouchPoints: 2});
  const loaded = arrives("Page.loadEventFired");
  await send("Page.navigate", {url: `file://${page}`});
  await loaded;
  await pause(500);
  await look('document.querySelectorAll("details").forEach((details) => { details.open = true; });');
  const plots = await look(`return [...document.querySelectorAll("[data-plot] svg.canvas")].map((svg) => ({name: svg.getAttribute("aria-label"),
    slides: !!svg.closest("[data-plot]").querySelector("input"), magnifies: !!svg.closest("[data-plot]").querySelector(".whole")}));`);
  for (const [k, {name, slides, magnifies}] of plots.slice(0, most).entries()) {
    await tapWherePointerFinds(k, name);
    if (k + 1 < plots.length) await scrollOver(k, name);
    if (magnifies) await magnify(k, name);
    if (slides) await slide(k, name);
  }
  const small = await look(`return [...document.querySelectorAll(".plot button, .plot input")].filter((e) => e.offsetHeight > 0 && e.offsetHeight < 24).length;`);
  if (small) complain(`${small} buttons are less than 24 pixels high`);
  const count = (key) => plots.filter((plot) => plot[key]).length;
  console.log(JSON.stringify({plots: plots.length, magnified: count("magnifies"), slid: count("slides"), problems}));
}

examine().catch((error) => console.log(JSON.stringify({problems: [String(error)]}))).finally(() => browser.kill());
