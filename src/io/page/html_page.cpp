// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
#include "io/page/html_page.h"

namespace pcl_msf::io {

const char* const kPageStyle = R"css(
:root { --ink: #1c2430; --soft: #5b6675; --line: #d8dee6; --hue: #1f6fb5; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1320px; padding: 24px; color: var(--ink);
  font: 15px/1.45 system-ui, sans-serif; background: #fff; }
h1 { font-size: 26px; margin: 0 0 16px; }
h2 { font-size: 19px; margin: 40px 0 12px; padding-top: 16px;
  border-top: 1px solid var(--line); }
nav a { margin-right: 14px; color: var(--hue); text-decoration: none; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 4px 10px; border-bottom: 1px solid var(--line); text-align: left;
  white-space: nowrap; }
td.number, th.number { text-align: right; }
table.sortable th { cursor: pointer; }
th[data-order="1"]::after { content: " \25B2"; }
th[data-order="-1"]::after { content: " \25BC"; }
.entry { display: flex; flex-wrap: wrap; gap: 24px; align-items: flex-start; }
figure { margin: 0; }
figcaption { color: var(--soft); font-size: 13px; }
.comparison { width: 600px; max-width: 100%; }
.stack { position: relative; background: #000; line-height: 0; }
.stack img { width: 100%; }
.stack img.after { position: absolute; left: 0; top: 0; height: 100%;
  clip-path: inset(0 0 0 50%); }
.stack.flicker img.after { clip-path: none; animation: flicker 1s steps(1) infinite; }
@keyframes flicker { 0% { opacity: 0; } 50% { opacity: 1; } }
.comparison input { width: 100%; margin: 6px 0 0; }
.thumbnails { display: flex; flex-wrap: wrap; gap: 12px; margin-top: 16px; }
.thumbnails figure { width: 238px; }
.thumbnails img { width: 100%; display: block; border: 1px solid var(--line); }
svg text { font: 12px system-ui, sans-serif; fill: var(--ink); }
.plot { margin-top: 12px; }
select, button { font: inherit; }
)css";

const char* const kPageScript = R"js(
"use strict";
const number = text => text.trim() === "" ? NaN : Number(text);
document.querySelectorAll(".comparison").forEach(box => {
  const stack = box.querySelector(".stack"), after = stack.querySelector(".after");
  const slider = box.querySelector("input"), button = box.querySelector("button");
  const show = () => { after.style.clipPath = "inset(0 0 0 " + slider.value + "%)"; };
  slider.hidden = button.hidden = false;
  slider.addEventListener("input", () => { stack.classList.remove("flicker"); show(); });
  button.addEventListener("click", () => {
    after.style.clipPath = "";
    if (!stack.classList.toggle("flicker")) show();
  });
});
document.querySelectorAll("table.sortable").forEach(table => {
  const body = table.tBodies[0];
  table.querySelectorAll("th").forEach((head, column) => {
    head.addEventListener("click", () => {
      const order = head.dataset.order === "1" ? -1 : 1;
      table.querySelectorAll("th").forEach(other => delete other.dataset.order);
      head.dataset.order = order;
      if (columns.includes(column)) choice.value = column;
      const rows = [...body.rows];
      rows.sort((a, b) => {
        const x = a.cells[column].textContent, y = b.cells[column].textContent;
        const difference = number(x) - number(y);
        return order * (isNaN(difference) ? x.localeCompare(y) : difference);
      });
      rows.forEach(row => body.append(row));
      draw();
    });
  });
  const texts = column => [...body.rows].map(row => row.cells[column].textContent);
  const varies = column => new Set(texts(column)).size > 1;
  const names = [...table.rows[0].cells].filter(
    head => !head.classList.contains("number")).map(head => head.cellIndex);
  const telling = names.some(varies) ? names.filter(varies) : [names[0] ?? 0];
  const columns = [...table.querySelectorAll("th.number")].map(head => head.cellIndex);
  if (columns.length === 0) return;
  const measured = columns.filter(varies).find(
    column => texts(column).some(text => !Number.isInteger(number(text))))
    ?? columns.find(varies) ?? columns[0];
  const plot = document.createElement("div");
  plot.className = "plot";
  const choice = document.createElement("select");
  columns.forEach(column => {
    const option = document.createElement("option");
    option.value = column;
    option.textContent = table.rows[0].cells[column].textContent;
    option.selected = column === measured;
    choice.append(option);
  });
  const picture = document.createElement("div");
  plot.append("Plot: ", choice, picture);
  table.parentElement.after(plot);
  choice.addEventListener("change", draw);
  function element(name, attributes, text) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
    if (text !== undefined) made.textContent = text;
    return made;
  }
  function draw() {
    const column = Number(choice.value), step = 22, left = 260, width = 820;
    const bars = [...body.rows].map(row => [
      telling.map(column => row.cells[column].textContent).join(" "),
      number(row.cells[column].textContent)]);
    const known = bars.map(bar => bar[1]).filter(value => isFinite(value));
    const most = Math.max(...known.map(Math.abs), 1e-12);
    const svg = element("svg", { width: width, height: step * bars.length + 4 });
    bars.forEach(([name, value], row) => {
      const y = row * step;
      const label = name.length > 38 ? name.slice(0, 37) + "\u2026" : name;
      svg.append(element("text", { x: left - 8, y: y + 16, "text-anchor": "end" }, label));
      if (!isFinite(value)) return;
      const length = Math.abs(value) / most * (width - left - 90);
      svg.append(element("rect", { x: left, y: y + 3, width: Math.max(length, 1),
        height: step - 6, fill: value < 0 ? "#c0504d" : "#1f6fb5" }));
      svg.append(element("text", { x: left + length + 6, y: y + 16 }, String(value)));
    });
    picture.replaceChildren(svg);
  }
  draw();
});
)js";

} // namespace pcl_msf::io
