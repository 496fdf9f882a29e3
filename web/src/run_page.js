// The page of a run: its sections in order.
import { assumptions } from './assumptions.js';
import { coverage } from './coverage.js';
import { readSeries } from './data.js';
import { driveMoments } from './drive_moments.js';
import { energy } from './energy.js';
import { facts } from './facts.js';
import { header } from './header.js';
import { judged } from './judged.js';
import { createMoment } from './moment.js';
import { replay } from './replay.js';
import { reproduce } from './reproduce.js';
import { timeUse } from './time_use.js';
import { turns } from './turns.js';

export function runPage(data, pictures) {
  const series = readSeries(data.series);
  const end = series.count ? series.poses.time_s[series.count - 1] : 0;
  const run = { data, series, pictures, moment: createMoment(end) };
  return [
    header(run),
    judged(run),
    replay(run),
    facts(run),
    coverage(run),
    driveMoments(run),
    energy(run),
    timeUse(run),
    turns(run),
    assumptions(run),
    reproduce(run),
  ];
}
