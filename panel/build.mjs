// Makes dist/, which is committed so that building the C++ program needs no npm.
//   node build.mjs            dist/panel.js, dist/panel.css, dist/hashes.json
//   node build.mjs --tests    build/test/*.mjs, for `node --test`
//   node build.mjs --out DIR  the bundle into DIR, for the check that dist/ is what the sources give
import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as esbuild from 'esbuild';

const root = import.meta.dirname;
const at = process.argv.indexOf('--out');
const out = at > 0 ? process.argv[at + 1] : join(root, 'dist');

if (process.argv.includes('--tests')) {
  await esbuild.build({
    entryPoints: readdirSync(join(root, 'test')).filter((name) => name.endsWith('.test.ts'))
      .map((name) => join(root, 'test', name)),
    outdir: join(root, 'build/test'), outExtension: { '.js': '.mjs' },
    bundle: true, platform: 'node', format: 'esm', sourcemap: 'inline',
  });
} else {
  mkdirSync(out, { recursive: true });
  await esbuild.build({
    entryPoints: { panel: join(root, 'src/main.ts') },
    outdir: out, bundle: true, format: 'iife', target: ['chrome110', 'firefox115', 'safari16'],
    minify: true, charset: 'utf8', legalComments: 'none',
  });
  if (/<\/script|<!--/i.test(readFileSync(join(out, 'panel.js'), 'utf8')))
    throw new Error('the bundle would end the script element that holds it');
  // a report contains its script and style; its policy refers to them by these hashes
  const hash = (name) => 'sha256-' + createHash('sha256').update(readFileSync(join(out, name))).digest('base64');
  writeFileSync(join(out, 'hashes.json'),
    JSON.stringify({ script: hash('panel.js'), style: hash('panel.css') }, null, 2) + '\n');
}
