// The parts of ECharts that the page uses, and how its charts look.
import { BarChart, CustomChart, LineChart, SankeyChart, ScatterChart } from 'echarts/charts';
import {
  AriaComponent,
  AxisPointerComponent,
  DataZoomComponent,
  GridComponent,
  LegendComponent,
  MarkLineComponent,
  TitleComponent,
  TooltipComponent,
} from 'echarts/components';
import * as echarts from 'echarts/core';
import { CanvasRenderer, SVGRenderer } from 'echarts/renderers';
import { el } from './dom.js';
import { ink, rule, softInk } from './palette.js';

echarts.use([
  AriaComponent,
  AxisPointerComponent,
  BarChart,
  CanvasRenderer,
  CustomChart,
  DataZoomComponent,
  GridComponent,
  LegendComponent,
  LineChart,
  MarkLineComponent,
  SankeyChart,
  ScatterChart,
  SVGRenderer,
  TitleComponent,
  TooltipComponent,
]);

// By name, because labels are measured on a canvas, which inherits nothing.
const font = { fontFamily: 'Inter, system-ui, sans-serif', fontSize: 12, color: softInk };
export const textStyle = font;
export const axisLine = { lineStyle: { color: rule } };
export const axis = {
  axisLine,
  axisTick: { show: false },
  axisLabel: { ...font },
  nameTextStyle: { ...font },
  splitLine: { lineStyle: { color: '#ebecea' } },
};
export const tooltip = {
  backgroundColor: '#ffffff',
  borderColor: rule,
  textStyle: { ...font, color: ink },
  confine: true,
};

// The categories of a chart of bars on its y axis, whose labels have that width on a page so wide.
export const categories = (names, width) => ({
  type: 'category',
  ...axis,
  data: names,
  axisLabel: { ...font, color: ink, width: width < 500 ? 122 : 190, overflow: 'truncate' },
});

// Intervals across the bars of a chart whose categories stand on its y axis: [category, low, high].
export const whiskers = (intervals) => ({
  type: 'custom',
  silent: true,
  z: 5,
  data: intervals.filter(Boolean),
  encode: { x: [1, 2], y: 0 },
  renderItem: (_, api) => {
    const kCap = 4;
    const [low, y] = api.coord([api.value(1), api.value(0)]);
    const [high] = api.coord([api.value(2), api.value(0)]);
    const line = (x1, y1, x2, y2) => ({
      type: 'line',
      shape: { x1, y1, x2, y2 },
      style: { stroke: ink, lineWidth: 1.5 },
    });
    return {
      type: 'group',
      children: [
        line(low, y, high, y),
        line(low, y - kCap, low, y + kCap),
        line(high, y - kCap, high, y + kCap),
      ],
    };
  },
});

const kPaperWidth = 680; // px that an A4 page is wide
const charts = [];

// A box with a chart in it, described by `label` to those who cannot see it. `draw(width)` gives the
// options for a width in pixels; the chart is made when it comes near the screen, and drawn again
// when its width changes. SVG prints sharply, canvas bears long series.
export function chart(label, height, draw, { renderer = 'svg' } = {}) {
  const box = el('div', { class: 'chart', role: 'img', 'aria-label': label });
  const made = { box, instance: null, near: false };
  const waiting = [];
  let drawn = 0;

  made.fit = (width) => {
    if (!width || width === drawn) return;
    box.style.height = `${typeof height === 'function' ? height(width) : height}px`;
    if (!made.near) return;
    drawn = width;
    const size = { width, height: parseFloat(box.style.height) };
    if (made.instance) {
      made.instance.resize(size);
    } else {
      const devicePixelRatio = Math.max(2, window.devicePixelRatio);
      made.instance = echarts.init(box, null, { renderer, devicePixelRatio, ...size });
      for (const then of waiting) then(made.instance);
    }
    made.instance.setOption({ animation: false, textStyle: font, ...draw(width) }, true);
  };
  made.fitBox = () => made.fit(Math.round(box.clientWidth));
  made.redraw = () => {
    drawn = 0;
    made.fitBox();
  };
  // Calls `then` with the instance as soon as there is one.
  made.ready = (then) => (made.instance ? then(made.instance) : waiting.push(then));
  new ResizeObserver(made.fitBox).observe(box);
  new IntersectionObserver(
    ([entry], observer) => {
      if (!entry.isIntersecting) return;
      observer.disconnect();
      made.near = true;
      made.fitBox();
    },
    { rootMargin: '700px' },
  ).observe(box);
  charts.push(made);
  return made;
}

// All of them, as wide as paper is.
window.addEventListener('beforeprint', () => {
  for (const one of charts) {
    one.near = true;
    one.box.style.width = `${kPaperWidth}px`;
    one.fit(kPaperWidth);
  }
});
window.addEventListener('afterprint', () => {
  for (const one of charts) {
    one.box.style.width = '';
    one.fitBox();
  }
});
