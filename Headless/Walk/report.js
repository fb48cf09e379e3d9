// Steps through the chart's page as a reader does: report.sh puts this behind the page's own script and reads what it finds.
(() => {
  "use strict";
  const faults = [], fault = text => faults.push(text);
  const tip = document.getElementById("tip"), buttons = [...document.querySelectorAll("#controls button[data-toggle]")];
  const count = selector => document.querySelectorAll(selector).length;
  const middle = element => {
    const box = element.getBoundingClientRect();
    return { clientX: box.left + box.width / 2, clientY: box.top + box.height / 2, bubbles: true };
  };
  const key = name => new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true });

  function isTipInside(where) {
    const box = tip.getBoundingClientRect();
    if (tip.hidden) fault(`${where}: no tip`);
    else if (box.left < 0 || box.right > window.innerWidth || box.top < 0 || box.bottom > window.innerHeight) fault(`${where}: the tip leaves the window`);
  }

  function panels() {
    const hosts = [...document.querySelectorAll("figure.panel > div")];
    if (hosts.length === 0) fault("no panel");
    for (const host of hosts) {
      const where = host.getAttribute("aria-label").split(":")[0];
      host.scrollIntoView({ block: "center", behavior: "instant" });
      for (const mark of host.querySelectorAll(".point, .failed")) {
        mark.dispatchEvent(new PointerEvent("pointermove", middle(mark)));
        isTipInside(where);
        for (const word of ["κ = R/dx", "Particles", "Seeds"])
          if (!tip.textContent.includes(word)) fault(`${where}: a tip without ${word}`);
        if (host.querySelector(".ring").getAttribute("visibility") !== "visible") fault(`${where}: no ring`);
      }
      host.dispatchEvent(new PointerEvent("pointerleave", {}));
      if (!tip.hidden) fault(`${where}: the tip stays`);
      if (host.querySelectorAll(".point, .failed").length > 1) keyboard(host, where);
    }
  }

  function keyboard(host, where) {
    host.focus();
    if (document.activeElement !== host) fault(`${where}: Tab does not reach it`);
    const said = ["Home", "ArrowRight", "End", "ArrowLeft"].map(name => {
      host.dispatchEvent(key(name));
      isTipInside(`${where}, ${name}`);
      return tip.textContent + host.querySelector(".ring").getAttribute("cx");
    });
    if (said[0] === said[1] || said[2] === said[3]) fault(`${where}: the arrow keys stay on a point`);
    host.dispatchEvent(key("Escape"));
    if (!tip.hidden) fault(`${where}: Escape leaves the tip`);
  }

  function curves() {
    for (const plot of document.querySelectorAll("figure.curves [role=group]")) {
      const where = plot.getAttribute("aria-label").split(":")[0];
      plot.scrollIntoView({ block: "center", behavior: "instant" });
      plot.dispatchEvent(new PointerEvent("pointermove", middle(plot)));
      isTipInside(where);
      if (tip.querySelectorAll("dd").length === 0) fault(`${where}: no values`);
      plot.dispatchEvent(key("End"));
      isTipInside(where);
      plot.dispatchEvent(new PointerEvent("pointerleave", {}));
      for (const line of plot.querySelectorAll(".curve, path.reference"))
        if (!line.getAttribute("d")) fault(`${where}: a curve without points`);
    }
  }

  function toggles() {
    const drawn = () => count("figure.panel .point, figure.panel .failed, figure.panel .bar, figure.panel path.front, figure.panel .sweep, figure.panel .fit, figure .curve");
    const all = drawn();
    for (const button of buttons) {
      const name = button.textContent;
      button.click();
      if (button.getAttribute("aria-pressed") !== "false") fault(`${name}: still pressed`);
      if (drawn() >= all && !(name === "bars of the seeds" && count("figure.panel .bar") === 0)) fault(`${name}: hides nothing`);
      const [kind, index] = button.dataset.toggle.split(" ");
      if (kind === "method" && count(`.point[fill="var(--method-${index})"]`) > 0) fault(`${name}: its points stay`);
      button.click();
      if (drawn() !== all) fault(`${name}: does not come back`);
    }
  }

  function scheme() {
    const button = document.getElementById("scheme"), ground = () => getComputedStyle(document.body).backgroundColor, start = ground();
    button.click();
    const light = ground();
    button.click();
    const dark = ground();
    button.click();
    if (light === dark) fault("light and dark are alike");
    if (ground() !== start) fault("the system's colours do not come back");
  }

  // What is cut off at an edge, or wider than the window.
  function layout() {
    if (document.documentElement.scrollWidth > window.innerWidth) fault(`the page is ${document.documentElement.scrollWidth} px wide in a window of ${window.innerWidth}`);
    for (const text of document.querySelectorAll("figure svg.plot text")) {
      const box = text.getBoundingClientRect(), frame = text.ownerSVGElement.getBoundingClientRect();
      if (box.left < frame.left - 1 || box.right > frame.right + 1 || box.top < frame.top - 1 || box.bottom > frame.bottom + 1)
        fault(`'${text.textContent}' is cut off in ${text.closest("[aria-label]").getAttribute("aria-label").split(":")[0]}`);
    }
    for (const host of document.querySelectorAll("figure.panel svg")) {
      const marks = [...host.querySelectorAll("text:not(.label)")].map(t => [t.textContent, t.getBoundingClientRect()]);
      marks.forEach(([a, p], i) => marks.slice(i + 1).forEach(([b, q]) => {
        if (p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom) fault(`'${a}' and '${b}' overlap in ${host.parentElement.getAttribute("aria-label").split(":")[0]}`);
      }));
    }
  }

  try {
    layout();
    panels();
    curves();
    toggles();
    scheme();
  } catch (error) {
    fault(`the walk stopped: ${error}`);
  }
  faults.push(...(window.walkErrors ?? []).map(e => `the page's script: ${e}`));
  window.scrollTo(0, 0);
  window.parent.postMessage(`${window.innerWidth} px: ${count("figure.panel")} panels, ${count(".point, .failed")} marks, ${count("figure.curves")} pictures of curves, ${buttons.length} switches; ` +
    (faults.length === 0 ? "no fault" : `${faults.length} faults: ${[...new Set(faults)].join("; ")}`), "*");
})();
