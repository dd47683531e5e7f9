// Shows the frames of a run. What it shows stands in the page, in #film: places of the discs as bytes,
// the energies, and the words of the language.
"use strict";
{
  const film = JSON.parse(document.getElementById("film").textContent);
  const places = Uint8Array.from(atob(film.places), (letter) => letter.charCodeAt(0));
  const discs = places.length / film.bytes / film.frames;
  const words = film.words;

  const [picture, energies, play, back, forth, moment, clock, pace, rate, now] =
    ["discs", "energies", "play", "back", "forth", "moment", "clock", "pace", "rate", "now"]
      .map((id) => document.getElementById(id));

  // Without times, each frame is a unit of time.
  const times = film.times ?? Array.from({ length: film.frames }, (_, k) => k);
  const begin = times[0];
  const end = times[times.length - 1];

  let frame = 0; // the one that is shown
  let time = begin; // s, which moves on between two frames
  let timer = null; // while it plays
  let before = 0; // ms, when the time was last moved

  /** The place of a disc in a frame, m, and its speed, 0 to 1; nothing if it is not in the picture. */
  function discAt(k, disc) {
    const at = (k * discs + disc) * film.bytes;
    const speed = places[at + 4];
    if (speed === film.absent) return null;
    const metres = (low, high) => ((low + 256 * high) / film.scale) * film.width;
    return {
      x: film.corner[0] + metres(places[at], places[at + 1]),
      y: film.corner[1] + metres(places[at + 2], places[at + 3]),
      radius: film.radii.length === 1 ? film.radii[0] : film.radii[disc],
      speed: speed / film.top,
    };
  }

  /** The number of the last moment that is not after `t`. */
  function lastBefore(moments, t) {
    let k = 0;
    while (k + 1 < moments.length && moments[k + 1] <= t) k += 1;
    return k;
  }

  /** A canvas as sharp as the screen, so high for its width; its brush draws in CSS pixels. */
  function brushOf(canvas, heightOverWidth) {
    const width = canvas.clientWidth;
    const height = Math.round(width * heightOverWidth);
    const sharp = window.devicePixelRatio || 1;
    const pixels = [Math.round(width * sharp), Math.round(height * sharp)];
    if (canvas.width !== pixels[0] || canvas.height !== pixels[1]) {
      [canvas.width, canvas.height] = pixels;
      canvas.style.height = `${height}px`;
    }
    const brush = canvas.getContext("2d");
    brush.setTransform(sharp, 0, 0, sharp, 0, 0);
    brush.clearRect(0, 0, width, height);
    return { brush, width, height };
  }

  function drawDiscs() {
    const { brush, width, height } = brushOf(picture, 1);
    const pixels = width / film.width; // of a metre
    const left = (x) => (x - film.corner[0]) * pixels;
    const top = (y) => height - (y - film.corner[1]) * pixels;
    if (film.side !== null) {
      brush.strokeStyle = "#111";
      brush.strokeRect(left(0), top(film.side), film.side * pixels, film.side * pixels);
    }
    for (let disc = 0; disc < discs; disc += 1) {
      const seen = discAt(frame, disc);
      if (seen === null) continue;
      const shade = Math.round(seen.speed * (film.shades.length - 1));
      brush.fillStyle = film.fastest === null ? film.plain : film.shades[shade];
      brush.beginPath();
      brush.arc(left(seen.x), top(seen.y), Math.max(seen.radius * pixels, film.least), 0, 2 * Math.PI);
      brush.fill();
    }
  }

  /** Where the curves lie: energies that grow without end are drawn by the powers of ten of their sizes. */
  function energyScale() {
    const { curves, isLog, unit } = film.energies;
    const atStart = curves.reduce((sum, curve) => sum + Math.abs(curve.values[0]), 0);
    const height = (value) => (isLog ? Math.log10(Math.max(Math.abs(value) / atStart, 1e-3)) : value);
    const values = curves.flatMap((curve) => curve.values);
    const high = values.map(height).reduce((most, value) => Math.max(most, value), 0);
    const low = values.map(height).reduce((least, value) => Math.min(least, value), 0);
    const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    return { height, low, span: high - low || 1, label: `${shown(largest)} ${unit}` };
  }

  const scale = film.energies === null ? null : energyScale();

  /** A number of three digits. */
  function shown(value) {
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(1);
    return String(Number(value.toPrecision(3)));
  }

  function drawEnergies() {
    const { brush, width, height } = brushOf(energies, 0.62);
    const moments = film.energies.times;
    const [first, last] = [moments[0], moments[moments.length - 1]];
    const left = (t) => 1 + ((t - first) / (last - first || 1)) * (width - 2);
    const top = (value) => {
      const share = (scale.height(value) - scale.low) / scale.span;
      return height - 18 - share * (height - 36);
    };
    brush.font = "12px Helvetica, Arial, sans-serif";
    brush.fillStyle = "#555";
    brush.textAlign = "left";
    brush.fillText(scale.label, 2, 12);
    brush.fillText(`${shown(first)} s`, 2, height - 4);
    brush.textAlign = "right";
    brush.fillText(`${shown(last)} s`, width - 2, height - 4);
    brush.strokeStyle = "#bbb";
    const ground = top(film.energies.isLog ? 1e-300 : 0);
    brush.lineWidth = 1;
    brush.strokeRect(1, ground, width - 2, 0);
    for (const curve of film.energies.curves) {
      brush.strokeStyle = curve.colour;
      brush.lineWidth = 1.5;
      brush.beginPath();
      curve.values.forEach((value, k) => brush.lineTo(left(moments[k]), top(value)));
      brush.stroke();
    }
    const cursor = left(Math.min(Math.max(times[frame], first), last));
    brush.strokeStyle = "#111";
    brush.lineWidth = 1;
    brush.strokeRect(cursor, 16, 0, height - 34);
    const k = lastBefore(moments, times[frame]);
    now.querySelectorAll("dd").forEach((cell, which) => {
      const value = film.energies.curves[which].values[k];
      cell.textContent = `${shown(value)} ${film.energies.unit}`;
    });
  }

  function draw() {
    drawDiscs();
    if (energies !== null) drawEnergies();
    moment.value = frame;
    const said = film.times === null ? words.frame : words.clock;
    clock.textContent = said.replace("{}", film.times === null ? frame : times[frame].toPrecision(4));
    play.textContent = timer === null ? words.play : words.pause;
  }

  /** Run seconds that pass in a second at the pace chosen. */
  function runSeconds() {
    return ((end - begin) / film.length) * Number(pace.value);
  }

  function sayRate() {
    rate.textContent = film.times === null ? "" : words.rate.replace("{}", shown(runSeconds()));
  }

  function goTo(k) {
    frame = Math.min(Math.max(k, 0), film.frames - 1);
    time = times[frame];
    draw();
  }

  function stop() {
    clearInterval(timer);
    timer = null;
    draw();
  }

  function start() {
    if (timer !== null) return;
    if (frame === film.frames - 1) goTo(0);
    before = performance.now();
    timer = setInterval(tick, 16); // ms
    draw();
  }

  function tick() {
    const at = performance.now();
    time += ((at - before) / 1000) * runSeconds();
    before = at;
    const next = lastBefore(times, time);
    if (next !== frame) {
      frame = next;
      draw();
    }
    if (frame === film.frames - 1) stop();
  }

  const toggle = () => (timer === null ? start() : stop());
  const stepBy = (frames) => {
    stop();
    goTo(frame + frames);
  };

  play.addEventListener("click", toggle);
  back.addEventListener("click", () => stepBy(-1));
  forth.addEventListener("click", () => stepBy(1));
  moment.addEventListener("input", () => stepBy(Number(moment.value) - frame));
  pace.addEventListener("change", sayRate);
  window.addEventListener("resize", draw);
  document.addEventListener("keydown", (event) => {
    const isElsewhere = event.target.closest("[contenteditable], select, summary, a");
    if (isElsewhere || event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === " " && event.target.closest("button")) return; // the button's own key
    const keys = {
      " ": toggle,
      ArrowLeft: () => stepBy(-1),
      ArrowRight: () => stepBy(1),
      Home: () => stepBy(-film.frames),
      End: () => stepBy(film.frames),
    };
    const act = keys[event.key];
    if (act === undefined) return;
    event.preventDefault();
    act();
  });

  sayRate();
  goTo(0);
  const isCalm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (film.begins && !isCalm) start();
}
