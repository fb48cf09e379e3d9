// Plots of the measurement: lines of points, dashed where they are estimates.

const data = JSON.parse(document.getElementById("data").textContent);

function linearAxis(values) {
  const high = Math.max(...values, 1e-9) * 1.08;
  return { low: 0, high };
}

function draw(host, plot) {
  const width = Math.max(280, Math.floor(host.clientWidth)), height = Math.round(Math.min(440, Math.max(290, 0.55 * width)));
  const left = 58, right = width - 14, top = 14, bottom = height - 42;
  const points = plot.lines.flatMap(l => l.points);
  const xs = points.map(p => p[0]), ys = points.map(p => p[1]);
  const x = plot.log ? logAxis(xs, 0, 0) : linearAxis(xs), y = plot.log ? logAxis(ys, 0, 0) : linearAxis(ys);
  const part = (v, axis) => plot.log ? Math.log(v / axis.low) / Math.log(axis.high / axis.low) : (v - axis.low) / (axis.high - axis.low);
  const at = p => [left + (right - left) * part(p[0], x), bottom - (bottom - top) * part(p[1], y)];
  const ticks = (axis, most) => plot.log ? logTicks(axis, most) : linearTicks(axis.low, axis.high, most / 2);
  const image = svg("svg", { class: "plot", viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": plot.title });
  for (const tick of ticks(x, (right - left) / 48)) {
    const [place] = at([tick, y.high]);
    image.append(svg("line", { class: "grid", x1: place, x2: place, y1: top, y2: bottom }),
      svg("text", { x: place, y: bottom + 15, "text-anchor": "middle" }, compact(tick)));
  }
  for (const tick of ticks(y, (bottom - top) / 24)) {
    const [, place] = at([x.high, tick]);
    image.append(svg("line", { class: "grid", x1: left, x2: right, y1: place, y2: place }),
      svg("text", { x: left - 6, y: place + 4, "text-anchor": "end" }, compact(tick)));
  }
  image.append(svg("rect", { class: "frame", x: left, y: top, width: right - left, height: bottom - top }),
    svg("text", { class: "title", x: (left + right) / 2, y: bottom + 34, "text-anchor": "middle" }, plot.x));
  plot.lines.forEach(line => {
    const stroke = colour(line.colour);
    image.append(svg("path", { class: line.estimate ? "estimate" : "sweep", fill: "none", stroke, "stroke-width": 2, d: path(line.points.map(at)) }));
    for (const p of line.points) {
      const [cx, cy] = at(p), dot = svg("circle", { class: "point", cx, cy, r: line.points.length > 20 ? 1.5 : 4, fill: stroke });
      dot.addEventListener("pointermove", e => showTip(line.name, [[plot.x, digits(p[0])], [plot.y, closely(p[1])]], e.clientX, e.clientY));
      dot.addEventListener("pointerleave", hideTip);
      image.append(dot);
    }
  });
  const legend = html("div", { class: "legend" }, ...plot.lines.map(line =>
    html("span", {}, svg("svg", { width: 26, height: 10, "aria-hidden": "true" },
      svg("path", { d: "M0 5H24", stroke: colour(line.colour), class: line.estimate ? "estimate" : undefined, "stroke-width": 2 })), " ", line.name)));
  host.replaceChildren(html("p", {}, html("strong", {}, plot.y)), image, legend);
}

function drawAll() {
  for (const host of document.querySelectorAll("[data-plot]")) {
    const plot = data[host.dataset.plot];
    if (plot.lines.length > 0) draw(host, plot);
    else host.replaceChildren(html("p", {}, "Nothing was measured."));
  }
}

drawAll();
window.addEventListener("resize", drawAll);
