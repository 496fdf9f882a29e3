// The field from above: relief, coverage, planned and driven path, coloured by what one likes to see.
import L from 'leaflet';
import 'leaflet/dist/leaflet.css';
import { rowAt, worst } from './data.js';
import { el } from './dom.js';
import { short } from './format.js';
import { ground, ink, kinds, paper, viridis } from './palette.js';

const kBins = 14;
const kReach = 28; // px within which a pointer finds the track

const at = (x, y) => L.latLng(y, x);
const boundsOf = ([x0, y0, x1, y1]) => L.latLngBounds(at(x0, y0), at(x1, y1));
const ringOf = (ring) => ring.map(([x, y]) => at(x, y));

const views = [
  { key: 'coverage', label: 'Coverage' },
  { key: 'kind', label: 'Movements' },
  { key: 'energy_wh_per_m', label: 'Energy per metre', unit: 'Wh/m' },
  { key: 'battery_power_w', label: 'Power', unit: 'W' },
  { key: 'speed_mps', label: 'Speed', unit: 'm/s', signed: true },
  { key: 'slip', label: 'Slip', unit: '%', factor: 100 },
  { key: 'load_transfer_ratio', label: 'Load transfer', unit: '', magnitude: true },
  { key: 'cross_track_error_m', label: 'Tracking error', unit: 'cm', factor: 100, magnitude: true },
  { key: 'soc', label: 'State of charge', unit: '%', factor: 100 },
  { key: 'ground_m', label: 'Elevation', unit: 'm' },
];

// One value a row, and the range its colours span: the outermost percent is beyond it.
function valuesOf(view, series) {
  const envelope = series.envelopes[view.key];
  const factor = view.factor ?? 1;
  const values = Array.from(envelope.low, (_, i) => {
    const value = worst(envelope, i) * factor;
    return view.magnitude ? Math.abs(value) : value;
  });
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  const low = sorted[Math.floor(0.01 * (sorted.length - 1))] ?? 0;
  const high = sorted[Math.ceil(0.99 * (sorted.length - 1))] ?? 1;
  return { values, low, high: high > low ? high : low + 1e-6 };
}

// Pieces of the track whose rows share a colour: [colour, lines].
function piecesBy(series, colourOf) {
  const { x_m: x, y_m: y } = series.poses;
  const pieces = new Map();
  let line = null;
  let colour = null;
  for (let i = 0; i < series.count; ++i) {
    const now = colourOf(i);
    line?.push(at(x[i], y[i]));
    if (now === colour && line) continue;
    colour = now;
    line = [at(x[i], y[i])];
    if (!pieces.has(colour)) pieces.set(colour, []);
    pieces.get(colour).push(line);
  }
  return pieces;
}

function swatches(items) {
  return el(
    'ul',
    { class: 'swatches' },
    items.map(([colour, label]) =>
      el('li', {}, el('span', { style: `background:${colour}` }), label),
    ),
  );
}

function scale({ low, high }, view) {
  const stops = Array.from({ length: 9 }, (_, i) => viridis(i / 8)).join(',');
  return el(
    'div',
    { class: 'scale' },
    el('span', {}, short(low)),
    el('span', {
      class: 'ramp',
      style: `background:linear-gradient(to right,${stops})`,
      role: 'img',
      'aria-label': 'Colours from low to high',
    }),
    el('span', {}, `${short(high)} ${view.unit}`),
  );
}

// Lines of one view of the driven path, and its legend.
function layerOf(view, { data, series }, canvas) {
  const line = (lines, color, weight) =>
    L.polyline(lines, { color, weight, renderer: canvas, interactive: false, lineCap: 'butt' });
  if (view.key === 'coverage') {
    const layers = [...piecesBy(series, () => ink)].map(([colour, lines]) =>
      line(lines, colour, 0.8),
    );
    layers.unshift(
      L.imageOverlay(data.coverage.url, boundsOf(data.coverage.extent_m), {
        opacity: 0.85,
        alt: 'Ground by times worked',
        className: 'coverage-image',
      }),
    );
    const items = [
      ['once', 'once'],
      ['twice', 'twice'],
      ['more', '3+ times'],
      ['missed', 'missed'],
    ];
    return { layers, legend: swatches(items.map(([key, label]) => [ground[key], label])) };
  }
  if (view.key === 'kind') {
    const kindOf = (i) => data.segment_kinds[Math.round(series.poses.segment[i])];
    const layers = [...piecesBy(series, kindOf)].map(([kind, lines]) =>
      line(lines, kinds[kind] ?? ink, 2.5),
    );
    const seen = Object.keys(kinds).filter((kind) => data.segment_kinds.includes(kind));
    return { layers, legend: swatches(seen.map((kind) => [kinds[kind], kind])) };
  }
  const range = valuesOf(view, series);
  const bin = (i) => {
    const share = (range.values[i] - range.low) / (range.high - range.low);
    return Number.isFinite(share)
      ? viridis(Math.round(Math.min(Math.max(share, 0), 1) * kBins) / kBins)
      : '#999999';
  };
  const layers = [...piecesBy(series, bin)].map(([colour, lines]) => line(lines, colour, 3));
  return { layers, legend: scale(range, view) };
}

function fixedLayers({ data }, canvas) {
  const { field } = data;
  const outline = { color: ink, weight: 2, fill: false, interactive: false, renderer: canvas };
  const layers = [
    L.imageOverlay(data.relief.url, boundsOf(data.relief.extent_m), {
      alt: 'Relief of the ground',
    }),
    L.polygon(ringOf(field.boundary), outline),
  ];
  for (const hole of field.holes)
    layers.push(
      L.polygon(ringOf(hole), { ...outline, fill: true, fillColor: '#d5d3cc', fillOpacity: 0.9 }),
    );
  for (const { kind, at: from, to, radius_m: radius } of field.obstacles) {
    const mark = {
      color: ink,
      weight: 1,
      fillColor: kind === 'tree' ? '#265c2c' : '#6f6a64',
      fillOpacity: 1,
      interactive: false,
      renderer: canvas,
    };
    const line = from[0] !== to[0] || from[1] !== to[1];
    layers.push(
      line
        ? L.polyline([at(...from), at(...to)], { ...mark, weight: 4, color: '#6f6a64' })
        : L.circle(at(...from), { ...mark, radius: Math.max(radius, 0.6) }),
    );
  }
  return layers;
}

// The machine: an arrow that points where it heads.
function machine() {
  const arrow =
    '<svg viewBox="-12 -12 24 24" width="30" height="30" aria-hidden="true"><path d="M11 0 L-8 8 L-4 0 L-8 -8 Z" fill="#a51528" stroke="#fcfcfa" stroke-width="1.6"/></svg>';
  return L.marker(at(0, 0), {
    icon: L.divIcon({ className: 'machine', html: arrow, iconSize: [30, 30] }),
    interactive: false,
    keyboard: false,
  });
}

// Row whose place is nearest, undefined beyond kReach.
function nearest(map, series, latlng) {
  const { x_m: x, y_m: y } = series.poses;
  const reach = kReach / map.getZoomScale(map.getZoom(), 0);
  let best;
  let least = reach * reach;
  for (let i = 0; i < series.count; ++i) {
    const d = (x[i] - latlng.lng) ** 2 + (y[i] - latlng.lat) ** 2;
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

function reasonMarks({ data, moment }) {
  const reasons = data.metrics?.verdict?.reasons ?? [];
  return reasons
    .map((reason, i) => ({ ...reason, number: i + 1 }))
    .filter(({ x_m: x }) => Number.isFinite(x))
    .map(({ x_m: x, y_m: y, number, grade, text, time_s: time }) => {
      const icon = L.divIcon({
        className: `reason-mark ${grade.toLowerCase()}`,
        html: String(number),
        iconSize: [22, 22],
      });
      const mark = L.marker(at(x, y), { icon, title: text, alt: `Reason ${number}: ${text}` });
      return time == null ? mark : mark.on('click', () => moment.set(time, 'link'));
    });
}

export function trackMap(run) {
  const { data, series, moment } = run;
  const box = el('div', {
    class: 'map',
    role: 'application',
    'aria-label': 'Map of the field with the driven path',
  });
  const legend = el('div', { class: 'legend' });
  const marker = machine();
  const known = views.filter(
    ({ key }) => key === 'coverage' || key === 'kind' || series.envelopes[key],
  );
  let shown = L.layerGroup();

  const show = (key) => {
    const view = known.find((candidate) => candidate.key === key);
    const { layers, legend: content } = layerOf(view, run, canvas);
    shown.clearLayers();
    for (const layer of layers) shown.addLayer(layer);
    legend.replaceChildren(content);
    box.dataset.view = key;
  };
  const follow = (time) => {
    const i = rowAt(series.poses.time_s, time);
    marker.setLatLng(at(series.poses.x_m[i], series.poses.y_m[i]));
    const arrow = marker.getElement()?.firstElementChild;
    if (arrow) arrow.style.transform = `rotate(${-series.poses.yaw_rad[i]}rad)`;
    box.dataset.row = i;
  };

  const map = L.map(box, {
    crs: L.CRS.Simple,
    minZoom: -6,
    maxZoom: 6,
    zoomSnap: 0,
    attributionControl: false,
    scrollWheelZoom: false,
    dragging: !L.Browser.mobile,
    preferCanvas: true,
  });
  const canvas = L.canvas({ padding: 0.3 });
  L.control.scale({ imperial: false, maxWidth: 120 }).addTo(map);
  map.fitBounds(boundsOf(data.relief.extent_m));
  for (const layer of fixedLayers(run, canvas)) layer.addTo(map);
  shown.addTo(map);
  marker.addTo(map);
  for (const mark of reasonMarks(run)) mark.addTo(map);
  show('coverage');
  follow(0);
  const pick = ({ latlng }) => {
    const row = nearest(map, series, latlng);
    if (row !== undefined) moment.set(series.poses.time_s[row], 'map');
  };
  map.on('mousemove click', pick);
  moment.watch(follow);
  const [west, south, east, north] = data.relief.extent_m;
  box.style.aspectRatio = Math.min(Math.max((east - west) / (north - south), 0.9), 2.4);
  // Paper keeps the map as it is on the screen: its lines cannot be drawn again in time.
  window.addEventListener('beforeprint', () => {
    const { width, height } = box.getBoundingClientRect();
    Object.assign(box.style, { width: `${width}px`, height: `${height}px`, maxHeight: 'none' });
  });
  window.addEventListener('afterprint', () => {
    Object.assign(box.style, { width: '', height: '', maxHeight: '' });
  });
  let fitted = 0;
  new ResizeObserver(() => {
    map.invalidateSize({ animate: false });
    if (Math.abs(box.clientWidth - fitted) < 2) return;
    fitted = box.clientWidth;
    map.fitBounds(boundsOf(data.relief.extent_m), { animate: false });
  }).observe(box);

  const select = el(
    'select',
    { onchange: () => show(select.value) },
    known.map(({ key, label }) => el('option', { value: key }, label)),
  );
  const bar = el('div', { class: 'map-bar' }, el('label', {}, 'Show ', select), legend);
  box.style.background = paper;
  return [bar, box];
}
