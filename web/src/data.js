// What the program wrote into the page (evaluate/report_data.h, evaluate/packed_bytes.h), decoded.
import { unzlibSync } from 'three/addons/libs/fflate.module.js';

export function readData() {
  return JSON.parse(document.getElementById('report').textContent);
}

function bytes(base64) {
  const text = atob(base64);
  const array = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) array[i] = text.charCodeAt(i);
  return array;
}

export const unpack = (text) => unzlibSync(bytes(text));

export function floats(text) {
  const planes = unpack(text);
  const count = planes.length / 4;
  const bits = new Uint32Array(count);
  for (let i = 0, now = 0; i < count; ++i) {
    now += planes[i];
    for (let byte = 1; byte < 4; ++byte) now += planes[byte * count + i] << (8 * byte);
    bits[i] = now |= 0;
  }
  return new Float32Array(bits.buffer);
}

// Columns by name: poses have one value a row, envelopes a low and a high one, and `worst` is the
// one farther from zero.
export function readSeries(json) {
  const poses = {};
  for (const [name, column] of Object.entries(json.poses ?? {})) poses[name] = floats(column);
  const envelopes = {};
  for (const [name, column] of Object.entries(json.envelopes ?? {})) {
    const low = floats(column.low);
    const high = column.high ? floats(column.high) : low;
    envelopes[name] = { low, high };
  }
  return { count: json.count ?? 0, poses, envelopes };
}

export function worst({ low, high }, i) {
  return Math.abs(high[i]) >= Math.abs(low[i]) ? high[i] : low[i];
}

// Index of the last row whose time is at most `time`.
export function rowAt(times, time) {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}
