// The same energy as a flow: from where it came, through the movements, to its causes. What a
// movement won back (downhill, slowing down) enters beside the battery, so that each balances.
import { chart, textStyle, tooltip } from './charts.js';
import { el } from './dom.js';
import { energy as energyText } from './format.js';
import { causeColour, ink, kinds as kindColours } from './palette.js';

function flows({ kinds, causes, small, all }) {
  const links = [];
  const nodes = new Map();
  const node = (name, color, depth) =>
    nodes.set(name, { name, depth, itemStyle: { color, borderWidth: 0 } });
  const link = (source, target, value) => {
    if (value > 1e-4 * all) links.push({ source, target, value });
  };
  node('battery', '#1c3878', 0);
  for (const kind of kinds) {
    node(kind.kind, kindColours[kind.kind], 1);
    link('battery', kind.kind, kind.total);
    let other = 0;
    for (const cause of [...causes, ...small]) {
      const wh = kind.causes.get(cause);
      if (wh < -1e-3 * all) {
        node(`${cause}, won back`, causeColour(cause), 0);
        link(`${cause}, won back`, kind.kind, -wh);
      } else if (small.includes(cause)) {
        other += Math.max(wh, 0);
      } else if (wh > 0) {
        node(cause, causeColour(cause), 2);
        link(kind.kind, cause, wh);
      }
    }
    node('other', causeColour('other'), 2);
    link(kind.kind, 'other', other);
  }
  const used = new Set(links.flatMap(({ source, target }) => [source, target]));
  return { links, nodes: [...nodes.values()].filter(({ name }) => used.has(name)) };
}

export function energyFlow(read) {
  const { links, nodes } = flows(read);
  if (!links.length) return el('p', {}, 'There is no energy to show.');
  const label = links
    .map(({ source, target, value }) => `${source} to ${target} ${energyText(value)}`)
    .join('; ');
  return chart(
    `Flow of energy: ${label}`,
    (width) => (width < 500 ? 460 : 400),
    (width) => ({
      tooltip: { ...tooltip, trigger: 'item', valueFormatter: (wh) => energyText(wh) },
      series: [
        {
          type: 'sankey',
          left: 2,
          right: width < 500 ? 158 : 215,
          top: 8,
          bottom: 8,
          nodeWidth: 12,
          nodeGap: width < 500 ? 12 : 14,
          nodeAlign: 'left',
          draggable: false,
          emphasis: { focus: 'adjacency' },
          data: nodes,
          links,
          lineStyle: { color: 'target', opacity: 0.38 },
          label: {
            ...textStyle,
            color: ink,
            formatter: ({ name, value }) => (width < 500 ? name : `${name}  ${energyText(value)}`),
          },
        },
      ],
    }),
  ).box;
}
