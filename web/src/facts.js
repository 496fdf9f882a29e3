// Field and vehicle.
import { el, section } from './dom.js';
import { area, capital, degrees, distance, energy, percent, power } from './format.js';

const list = (title, items) =>
  el(
    'div',
    {},
    el('h3', {}, title),
    el(
      'dl',
      { class: 'facts' },
      items
        .filter((item) => item[1])
        .map(([name, value]) => el('div', {}, el('dt', {}, name), el('dd', {}, value))),
    ),
  );

function obstacles(field) {
  const counts = new Map();
  for (const { kind } of field.obstacles) counts.set(kind, (counts.get(kind) ?? 0) + 1);
  return [...counts].map(([kind, count]) => `${count} × ${kind}`).join(', ');
}

function boundaryLength(ring) {
  return ring.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    return sum + Math.hypot(nextX - x, nextY - y);
  }, 0);
}

function fieldFacts({ data }) {
  const { field, metrics } = data;
  const frame = metrics?.frame;
  const [low, high] = field.height_m;
  return [
    ['Area', area(field.area_m2)],
    ['Boundary', distance(boundaryLength(field.boundary))],
    ['Holes', field.holes.length ? String(field.holes.length) : null],
    ['Obstacles', obstacles(field)],
    ['Terrain', field.terrain_is_file ? field.terrain : `generated: ${field.terrain}`],
    ['Relief', `${(high - low).toFixed(1)} m`],
    [
      'Slope',
      field.slope_95 == null
        ? null
        : `median ${percent(field.slope_median)}, 95th percentile ${percent(field.slope_95)}`,
    ],
    ['Soil', field.soil],
    [
      'Place',
      frame
        ? `lon ${frame.longitude_deg.toFixed(5)}, lat ${frame.latitude_deg.toFixed(5)}`
        : 'local metres, no place on the earth',
    ],
  ];
}

function vehicleFacts({ vehicle }) {
  const drawn = vehicle.trailed ? 'trailed' : 'mounted';
  return [
    ['Vehicle', vehicle.name],
    ['What it is', vehicle.description],
    ['Mass with implement', `${Math.round(vehicle.mass_kg)} kg`],
    [
      'Size',
      `${vehicle.length_m.toFixed(2)} × ${vehicle.width_m.toFixed(2)} m, wheelbase ${vehicle.wheelbase_m.toFixed(2)} m`,
    ],
    [
      'Turning radius',
      `${vehicle.turning_radius_m.toFixed(2)} m, ${vehicle.steering.replace('_', '-')} steering`,
    ],
    [
      'Implement',
      vehicle.implement && `${vehicle.implement}, ${vehicle.working_width_m} m, ${drawn}`,
    ],
    ['Working speed', `${vehicle.work_speed_mps} m/s`],
    ['Motor', power(vehicle.motor_power_w)],
    ['Battery', `${energy(vehicle.battery_wh)}, empty at ${percent(vehicle.empty_soc, 0)}`],
    [
      'Tips at rest on',
      `${degrees(vehicle.side_tip_rad)} side slope, ${degrees(vehicle.nose_up_tip_rad)} nose up`,
    ],
  ];
}

export function facts(run) {
  return section(
    'facts',
    'Field and vehicle',
    el(
      'div',
      { class: 'columns' },
      list('Field', fieldFacts(run)),
      list(capital('vehicle'), vehicleFacts(run.data)),
    ),
  );
}
