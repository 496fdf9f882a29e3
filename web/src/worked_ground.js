// The colours of the terrain: the field, and what the implement has worked until a moment. Its
// strips are drawn from above into a texture, each pass adding to it, which the ground then wears:
// nothing lies on the ground that could sink into it.
import {
  AddEquation,
  BufferAttribute,
  BufferGeometry,
  Color,
  CustomBlending,
  DoubleSide,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  MeshBasicMaterial,
  OneFactor,
  OrthographicCamera,
  Scene,
  Shape,
  ShapeGeometry,
  Vector2,
  Vector4,
  WebGLRenderTarget,
} from 'three';
import { floats, rowAt } from './data.js';

const kSide = 3072; // texels along the longer side
const kPass = 1 / 5; // what a pass adds to red; the field is blue
const colours = {
  meadow: '#9eb076',
  field: '#ccba86',
  once: '#8c6c4e',
  twice: '#5f4836',
  more: '#3c2d24',
};

function fieldMesh({ boundary, holes }) {
  const shape = new Shape();
  boundary.forEach(([x, y], i) => (i ? shape.lineTo(x, y) : shape.moveTo(x, y)));
  shape.holes = holes.map((ring) => {
    const hole = new Shape();
    ring.forEach(([x, y], i) => (i ? hole.lineTo(x, y) : hole.moveTo(x, y)));
    return hole;
  });
  return new Mesh(
    new ShapeGeometry(shape),
    new MeshBasicMaterial({
      color: new Color().setRGB(0, 0, 1),
      side: DoubleSide,
      toneMapped: false,
    }),
  );
}

// Two triangles between each footprint and the one it is joined to. `times[k]` is when the k-th
// pair is done.
function stripMesh(json) {
  const columns = Object.fromEntries(
    Object.entries(json).map(([name, column]) => [name, floats(column)]),
  );
  const {
    left_x_m: lx,
    left_y_m: ly,
    right_x_m: rx,
    right_y_m: ry,
    time_s: time,
    starts_strip: starts,
  } = columns;
  const corners = [];
  const times = [];
  for (let i = 1; i < lx.length; ++i) {
    if (starts[i]) continue;
    const [a, b, c, d] = [
      [lx[i - 1], ly[i - 1], 0],
      [rx[i - 1], ry[i - 1], 0],
      [rx[i], ry[i], 0],
      [lx[i], ly[i], 0],
    ];
    corners.push(...a, ...b, ...c, ...a, ...c, ...d);
    times.push(time[i]);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  const material = new MeshBasicMaterial({
    color: new Color().setRGB(kPass, 0, 0),
    side: DoubleSide,
    toneMapped: false,
    depthTest: false,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return { mesh, times };
}

// Teaches the terrain's material to wear the texture.
function wear(material, texture, extent, texel) {
  material.vertexColors = false;
  material.onBeforeCompile = (shader) => {
    shader.uniforms.worked = { value: texture };
    shader.uniforms.extent = { value: extent };
    shader.uniforms.texel = { value: texel };
    for (const [name, colour] of Object.entries(colours))
      shader.uniforms[name] = { value: new Color(colour) };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec2 vGround;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nvGround = position.xy;');
    shader.fragmentShader = shader.fragmentShader
      .replace(
        '#include <common>',
        `#include <common>
         varying vec2 vGround;
         uniform sampler2D worked;
         uniform vec4 extent;
         uniform vec2 texel;
         uniform vec3 meadow, field, once, twice, more;
         vec2 groundAt(vec2 offset) {
           return texture2D(worked, (vGround - extent.xy) / extent.zw + offset * texel).rb;
         }
         // Of a texel and its neighbours: strips that meet within a hair leave no specks.
         float median(float a, float b, float c, float d, float e) {
           float f = max(min(a, b), min(c, d));
           float g = min(max(a, b), max(c, d));
           return max(min(e, f), min(max(e, f), g));
         }`,
      )
      .replace(
        '#include <color_fragment>',
        `vec2 ground = groundAt(vec2(0.0));
         float passes = median(groundAt(vec2(-1.0, 0.0)).x, groundAt(vec2(1.0, 0.0)).x,
             groundAt(vec2(0.0, -1.0)).x, groundAt(vec2(0.0, 1.0)).x, ground.x) / ${kPass.toFixed(3)};
         vec3 soil = mix(meadow, field, ground.y);
         soil = mix(soil, once, clamp(passes, 0.0, 1.0));
         soil = mix(soil, twice, clamp(passes - 1.0, 0.0, 1.0));
         soil = mix(soil, more, clamp(passes - 2.0, 0.0, 1.0));
         diffuseColor.rgb = soil;`,
      );
  };
}

export function createWorkedGround(renderer, data, terrain) {
  const [x0, y0, x1, y1] = data.relief.extent_m;
  const texelsPerMetre =
    Math.min(kSide, renderer.capabilities.maxTextureSize) / Math.max(x1 - x0, y1 - y0);
  const target = new WebGLRenderTarget(
    Math.ceil(texelsPerMetre * (x1 - x0)),
    Math.ceil(texelsPerMetre * (y1 - y0)),
    {
      depthBuffer: false,
      generateMipmaps: true,
      minFilter: LinearMipmapLinearFilter,
      magFilter: LinearFilter,
    },
  );
  target.texture.anisotropy = renderer.capabilities.getMaxAnisotropy();
  const texel = new Vector2(1 / target.width, 1 / target.height);
  wear(terrain.material, target.texture, new Vector4(x0, y0, x1 - x0, y1 - y0), texel);
  const camera = new OrthographicCamera(x0, x1, y1, y0, -1, 1);
  const field = new Scene();
  field.add(fieldMesh(data.field));
  const { mesh, times } = stripMesh(data.footprints);
  const strips = new Scene();
  strips.add(mesh);
  let drawn = -1;

  return {
    until(time) {
      const pairs = times.length && time >= times[0] ? rowAt(times, time) + 1 : 0;
      if (pairs === drawn) return;
      const clear = renderer.getClearColor(new Color());
      renderer.setRenderTarget(target);
      renderer.autoClear = false;
      if (pairs < drawn || drawn < 0) {
        drawn = 0;
        renderer.setClearColor('#000000', 0);
        renderer.clear();
        renderer.render(field, camera);
      }
      mesh.geometry.setDrawRange(6 * drawn, 6 * (pairs - drawn));
      renderer.render(strips, camera);
      renderer.autoClear = true;
      renderer.setClearColor(clear, 1);
      renderer.setRenderTarget(null);
      drawn = pairs;
    },
  };
}
