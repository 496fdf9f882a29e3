// Bundles src/ to report.js and report.css in the folder named on the command line.
import { build } from 'esbuild';
import { readFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, 'dist');

// What the page says is not modelled is what docs/physics.md says.
async function notModelled() {
  const text = await readFile(join(here, '../docs/physics.md'), 'utf8');
  const section = text.match(/^## Not modelled\n([\s\S]*?)(?=^## |(?![\s\S]))/m);
  if (!section) throw new Error('docs/physics.md has no section "Not modelled"');
  return section[1].replace(/\s+/g, ' ').replaceAll('`', '').trim();
}

await build({
  entryPoints: { report: join(here, 'src/main.js') },
  outdir: folder,
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'utf8',
  loader: { '.woff2': 'dataurl', '.png': 'dataurl' },
  define: { NOT_MODELLED: JSON.stringify(await notModelled()) },
  legalComments: 'inline',
  logLevel: 'warning',
});
