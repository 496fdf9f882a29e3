// The machine of the replay: its place and attitude, wheels turned and steered as in the run, the
// implement up or down, and an arrow above it that is seen from far.
import {
  BufferAttribute,
  CircleGeometry,
  ConeGeometry,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from 'three';

const spins = [
  'wheel_angle_rear_left_rad',
  'wheel_angle_rear_right_rad',
  'wheel_angle_front_left_rad',
  'wheel_angle_front_right_rad',
];

// Between two rows; angles may pass +-pi.
function between(column, row, share, angle) {
  const from = column[row];
  let change = (column[row + 1] ?? from) - from;
  if (angle) change -= 2 * Math.PI * Math.round(change / (2 * Math.PI));
  return from + share * change;
}

// As vehicle_models/vehicle.h steers: every wheel square to the line from the circle's centre.
function steerOf(vehicle, steer, [x, y]) {
  if (vehicle.steering === 'skid') return 0;
  const length =
    vehicle.steering === 'four_wheel' ? 0.5 * vehicle.wheelbase_m : vehicle.wheelbase_m;
  const curvature = Math.tan(steer) / length;
  return Math.atan2(curvature * x, 1 - curvature * y);
}

// Soft, under the machine: without it the machine seems to float.
function shadow({ length_m: length, width_m: width }) {
  const geometry = new CircleGeometry(1, 40);
  const shades = new Float32Array(4 * geometry.attributes.position.count);
  shades[3] = 0.6; // the middle; the rim is clear
  geometry.setAttribute('color', new BufferAttribute(shades, 4));
  const material = new MeshBasicMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
  });
  const mesh = new Mesh(geometry, material);
  mesh.scale.set(0.72 * length, 0.95 * width, 1);
  mesh.position.set(0.25 * length, 0, 0.08);
  return mesh;
}

export function createMachine(node, { data, series }) {
  const { poses } = series;
  const { vehicle, scene } = data;
  const wheels = spins.map((_, i) => node.getObjectByName(`wheel_${i}`));
  const implement = node.getObjectByName('implement');
  const states = ['up', 'down'].map((name) => implement?.getObjectByName(name));
  const arrow = new Mesh(
    new ConeGeometry(0.5, 1.4, 20).rotateX(-Math.PI / 2),
    new MeshBasicMaterial({ color: '#a51528' }),
  );
  arrow.renderOrder = 1;
  node.add(arrow, shadow(vehicle));
  node.rotation.order = 'ZYX';
  for (const wheel of wheels) if (wheel) wheel.rotation.order = 'ZYX';

  return {
    // The heights of the ground are stretched, so the attitude is, too.
    show(time, row, heights) {
      const next = Math.min(row + 1, series.count - 1);
      const gap = poses.time_s[next] - poses.time_s[row];
      const share = gap > 0 ? Math.min((time - poses.time_s[row]) / gap, 1) : 0;
      const at = (name, angle) => between(poses[name], row, share, angle);
      const stretched = (angle) => Math.atan(heights * Math.tan(angle));
      node.position.set(at('x_m'), at('y_m'), heights * (at('z_m') - scene.base_m));
      node.rotation.set(
        stretched(at('roll_rad', true)),
        -stretched(at('pitch_rad', true)),
        at('yaw_rad', true),
      );
      const steer = at('steer_rad');
      wheels.forEach((wheel, i) => {
        if (wheel)
          wheel.rotation.set(0, at(spins[i]), steerOf(vehicle, steer, vehicle.wheels_B[i]));
      });
      const down = poses.implement_down[row] > 0.5;
      if (states[0]) states[0].visible = !down;
      if (states[1]) states[1].visible = down;
      if (implement) implement.rotation.z = at('hitch_angle_rad', true);
    },
    place: (into) => node.getWorldPosition(into),
    // The arrow keeps its size on the screen.
    mark(camera, visible) {
      arrow.visible = visible;
      const away = node.getWorldPosition(new Vector3()).distanceTo(camera.position);
      const size = 0.02 * away;
      arrow.scale.setScalar(size);
      arrow.position.z = vehicle.length_m * 0.7 + size;
    },
  };
}
