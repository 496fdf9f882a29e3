// Colours that people with colour-blindness tell apart, as in the program's pictures.
export const ink = '#1c2024';
export const softInk = '#545a60';
export const rule = '#d9dbd8';
export const paper = '#fcfcfa';

export const grades = { PASS: '#00664f', WARN: '#855200', FAIL: '#a51528' };
export const gradeSigns = { PASS: '✓', WARN: '!', FAIL: '✕' };

// Ground by times worked, light to dark, and missed.
export const ground = {
  once: '#bae2be',
  twice: '#419ebe',
  more: '#1c3878',
  missed: '#d55e00',
  outside: '#8c8680',
};

// Paul Tol's muted scheme.
const muted = [
  '#332288',
  '#88ccee',
  '#44aa99',
  '#117733',
  '#999933',
  '#ddcc77',
  '#cc6677',
  '#882255',
  '#aa4499',
];
const causes = {
  draft: muted[0],
  'implement shaft and lift': muted[1],
  'drivetrain loss': muted[2],
  'motor loss': muted[3],
  'battery loss': muted[4],
  'rolling resistance': muted[5],
  slip: muted[6],
  'lateral scrub': muted[7],
  auxiliary: muted[8],
  inverter: '#5b8c5a',
  brake: '#b05a3c',
  steering: '#7a6aa8',
  grade: '#6b8fb5',
  other: '#a8abad',
};
export const causeColour = (cause) => causes[cause] ?? causes.other;

export const kinds = {
  swath: '#117733',
  'headland pass': '#88ccee',
  turn: '#cc6677',
  'U-turn': '#882255',
  transit: '#ddcc77',
};

const viridisNodes = [
  [68, 1, 84],
  [71, 44, 122],
  [59, 81, 139],
  [44, 113, 142],
  [33, 144, 141],
  [39, 173, 129],
  [92, 200, 99],
  [170, 220, 50],
  [253, 231, 37],
];
// From dark violet (0) over green to yellow (1).
export function viridis(share) {
  const u = Math.min(Math.max(share, 0), 1) * (viridisNodes.length - 1);
  const i = Math.min(Math.floor(u), viridisNodes.length - 2);
  const mixed = viridisNodes[i].map((from, k) =>
    Math.round(from + (u - i) * (viridisNodes[i + 1][k] - from)),
  );
  return `rgb(${mixed.join(',')})`;
}
