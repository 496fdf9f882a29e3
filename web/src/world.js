// The scene of the replay: terrain, what has been worked so far, planned lines, the way driven, the
// machine. Frame D (x east, y north, z up from the lowest ground) inside glTF's y-up root.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { rowAt, unpack } from './data.js';
import { createMachine } from './machine.js';
import { createWorkedGround } from './worked_ground.js';

const kSky = '#dfe8ee';

// As the program's pictures stretch gentle relief.
function usualHeights([low, high], size) {
  const relief = high - low;
  if (relief < 0.002 * size) return 1;
  return Math.min(Math.max(Math.floor((0.1 * size) / relief), 1), 3);
}

// The way driven so far.
function createTrack({ poses }, base) {
  const count = poses.x_m.length;
  const places = new Float32Array(3 * count);
  for (let i = 0; i < count; ++i)
    places.set([poses.x_m[i], poses.y_m[i], poses.z_m[i] - base + 0.15], 3 * i);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setDrawRange(0, 0);
  const line = new Line(
    geometry,
    new LineBasicMaterial({ color: '#1c1410', transparent: true, opacity: 0.5 }),
  );
  line.frustumCulled = false;
  return { line, until: (row) => geometry.setDrawRange(0, row + 1) };
}

function light(scene, size) {
  scene.add(new HemisphereLight('#ffffff', '#9a8f7c', 1.6));
  const sun = new DirectionalLight('#fff4e2', 2.2);
  sun.position.set(-size, 1.1 * size, -0.6 * size);
  scene.add(sun);
}

// The stretch is of the ground alone: what stands on it keeps its shape, the block its thickness.
function createStretch(root, track) {
  const ground = new Group();
  const standing = [];
  for (const child of [...root.children]) {
    if (child.name === 'obstacles') {
      for (const one of child.children) standing.push({ one, foot: one.position.z });
    } else if (child.name !== 'vehicle') {
      ground.add(child);
    }
  }
  ground.add(track.line);
  root.add(ground);
  const sides = ground.getObjectByName('block').geometry.attributes.position;
  const depths = Array.from({ length: sides.count }, (_, i) => sides.getZ(i));
  return (factor) => {
    ground.scale.z = factor;
    for (const { one, foot } of standing) one.position.z = factor * foot;
    depths.forEach((z, i) => z < 0 && sides.setZ(i, z / factor));
    sides.needsUpdate = true;
  };
}

// Lines are thin on every screen; they must not hide the ground.
function softLines(root) {
  for (const [name, opacity] of [
    ['passes', 0.4],
    ['turns', 0.55],
  ]) {
    const lines = root.getObjectByName(name);
    if (!lines) continue;
    lines.material.transparent = true;
    lines.material.opacity = opacity;
  }
}

// Lambert shading is enough, and quick in software.
function plainMaterials(root) {
  root.traverse((object) => {
    if (!object.isMesh) return;
    if (!object.geometry.attributes.normal) object.geometry.computeVertexNormals();
    object.material = new MeshLambertMaterial({ vertexColors: true });
  });
}

export async function createWorld(canvas, run) {
  if (!document.createElement('canvas').getContext('webgl2')) throw new Error('no WebGL 2');
  const { data, series, moment } = run;
  const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.setClearColor(new Color(kSky));
  const gltf = await new GLTFLoader().parseAsync(unpack(data.scene.glb).buffer, '');
  const root = gltf.scene.getObjectByName('scene');
  plainMaterials(gltf.scene);
  const scene = new Scene();
  scene.add(gltf.scene);
  const [x0, y0, x1, y1] = data.relief.extent_m;
  const size = Math.max(x1 - x0, y1 - y0);
  light(scene, size);

  const ground = createWorkedGround(renderer, data, root.getObjectByName('terrain'));
  const track = createTrack(series, data.scene.base_m);
  const stretch = createStretch(root, track);
  softLines(root);
  const machine = createMachine(root.getObjectByName('vehicle'), run);

  const camera = new PerspectiveCamera(32, 1, 0.5, 20 * size);
  const orbit = new OrbitControls(camera, canvas);
  orbit.maxPolarAngle = 0.49 * Math.PI;
  const usual = usualHeights(data.field.height_m, size);
  const world = { usual, heights: usual, following: false };
  let wanted = false;

  const render = () => {
    wanted = false;
    orbit.update();
    machine.mark(camera, !world.following);
    renderer.render(scene, camera);
  };
  const ask = () => {
    if (wanted) return;
    wanted = true;
    requestAnimationFrame(render);
  };
  const middle = () =>
    new Vector3(
      0.5 * (x0 + x1),
      0.5 * world.heights * (data.field.height_m[1] - data.field.height_m[0]),
      -0.5 * (y0 + y1),
    );
  const show = (time) => {
    const row = rowAt(series.poses.time_s, time);
    ground.until(time);
    track.until(row);
    const before = machine.place(new Vector3());
    machine.show(time, row, world.heights);
    if (world.following) {
      const moved = machine.place(new Vector3()).sub(before);
      camera.position.add(moved);
      orbit.target.add(moved);
    }
    ask();
  };

  world.look = (what) => {
    world.following = what === 'machine';
    if (world.following) {
      const at = machine.place(new Vector3());
      const reach = 3.2 * data.vehicle.length_m + 1.4 * data.vehicle.working_width_m;
      orbit.target.copy(at);
      camera.position.copy(at).add(new Vector3(-0.66, 0.5, 0.56).multiplyScalar(reach));
    } else {
      // With the field's long side across.
      const tall = y1 - y0 > x1 - x0;
      const [across, along] = tall ? [y1 - y0, x1 - x0] : [x1 - x0, y1 - y0];
      const reach = 1.38 * Math.max(along, across / Math.min(camera.aspect, 1.7));
      const turned = ([x, y, z]) => (tall ? new Vector3(-z, y, x) : new Vector3(x, y, z));
      orbit.target.copy(middle()).add(turned([0, 0, 0.07 * across]));
      camera.position.copy(middle()).add(turned([-0.14, 0.9, 1.18]).multiplyScalar(reach));
    }
    ask();
  };
  world.stretch = (factor) => {
    world.heights = factor;
    stretch(factor);
    show(moment.time ?? 0);
  };
  world.begin = () => {
    const resize = () => {
      const { clientWidth, clientHeight } = canvas;
      if (!clientWidth || !clientHeight) return;
      renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      renderer.setSize(clientWidth, clientHeight, false);
      camera.aspect = clientWidth / clientHeight;
      camera.updateProjectionMatrix();
      ask();
    };
    new ResizeObserver(resize).observe(canvas);
    resize();
    world.stretch(world.heights);
    world.look('field');
    orbit.addEventListener('change', ask);
    moment.watch(show);
  };
  return world;
}
