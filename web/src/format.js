// Numbers as people read them, each with its unit.
const NONE = '–';

export function fixed(value, decimals) {
  // + 0 turns -0 into 0.
  return Number.isFinite(value) ? (Number(value.toFixed(decimals)) + 0).toFixed(decimals) : NONE;
}

// About three significant digits: "0.052", "1.3", "412".
export function short(value) {
  if (!Number.isFinite(value)) return NONE;
  const size = Math.abs(value);
  if (size >= 100) return Math.round(value).toLocaleString('en');
  if (size >= 10) return value.toFixed(1);
  if (size >= 1) return value.toFixed(2);
  return Number(value.toPrecision(2)).toString();
}

// For the ticks of axes: no more digits than the number needs.
export const tick = (value) => Number(value.toPrecision(6)).toLocaleString('en');

export const percent = (ratio, decimals = 1) =>
  Number.isFinite(ratio) ? `${(100 * ratio).toFixed(decimals)} %` : NONE;

// From 1000 Wh on in kWh.
export function energy(wh) {
  if (!Number.isFinite(wh)) return NONE;
  if (Math.abs(wh) >= 1000) return `${(wh / 1000).toFixed(2)} kWh`;
  return `${wh.toFixed(Math.abs(wh) < 10 ? 2 : 1)} Wh`;
}

export function power(w) {
  if (!Number.isFinite(w)) return NONE;
  return Math.abs(w) >= 10000 ? `${(w / 1000).toFixed(1)} kW` : `${Math.round(w)} W`;
}

export function distance(m) {
  if (!Number.isFinite(m)) return NONE;
  return m >= 10000 ? `${(m / 1000).toFixed(2)} km` : `${m.toFixed(m < 100 ? 1 : 0)} m`;
}

export function area(m2) {
  if (!Number.isFinite(m2)) return NONE;
  return m2 >= 1000 ? `${(m2 / 10000).toFixed(3)} ha` : `${m2.toFixed(m2 < 10 ? 1 : 0)} m²`;
}

// "45 s", "3 min 20 s", "1 h 02 min".
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return NONE;
  const whole = Math.round(seconds);
  const two = (n) => String(n).padStart(2, '0');
  if (whole < 60) return `${whole} s`;
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${two(whole % 60)} s`;
  return `${Math.floor(whole / 3600)} h ${two(Math.floor((whole % 3600) / 60))} min`;
}

// "0:03:20", for axes and clocks.
export function clock(seconds) {
  const whole = Math.max(0, Math.round(seconds));
  const two = (n) => String(n).padStart(2, '0');
  return `${Math.floor(whole / 3600)}:${two(Math.floor((whole % 3600) / 60))}:${two(whole % 60)}`;
}

export const degrees = (rad) =>
  Number.isFinite(rad) ? `${((rad * 180) / Math.PI).toFixed(0)}°` : NONE;
export const place = ([x, y]) => `x ${x.toFixed(1)}, y ${y.toFixed(1)} m`;
export const capital = (text) => text.charAt(0).toUpperCase() + text.slice(1);
