// The extension looks for an installed `proskill` on the path, but never in what is opened with it.
import { chmodSync, mkdirSync, mkdtempSync, realpathSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { equal } from './expect.mjs';
import { extension, need } from './extension.mjs';

const [esbuild] = need('esbuild');
const folder = realpathSync(mkdtempSync(join(tmpdir(), 'proskill-path-')));

function program(...place) {
  const file = join(folder, ...place);
  mkdirSync(join(file, '..'), { recursive: true });
  writeFileSync(file, '#!/bin/sh\n');
  chmodSync(file, 0o755);
  return file;
}

try {
  const built = join(folder, 'find_program.mjs');
  await esbuild.build({ entryPoints: [join(extension, 'src/find_program.ts')], outfile: built, format: 'esm', platform: 'node' });
  const { findOnPath } = await import(built);
  const found = (...path) => findOnPath('proskill', path.join(':'), [join(folder, 'work')]);
  const installed = program('usr', 'bin', 'proskill');
  program('work', 'proskill');
  program('work', 'bin', 'proskill');
  mkdirSync(join(folder, 'links'));
  symlinkSync(join(folder, 'work', 'proskill'), join(folder, 'links', 'proskill'));
  symlinkSync(join(folder, 'work'), join(folder, 'opened'));
  mkdirSync(join(folder, 'empty', 'proskill'), { recursive: true });
  const bin = join(folder, 'usr', 'bin');
  equal('what is installed', found(bin), installed);
  equal('behind the workspace', found(join(folder, 'work'), join(folder, 'work', 'bin'), bin), installed);
  equal('behind a link to the workspace', found(join(folder, 'opened'), join(folder, 'links'), bin), installed);
  equal('behind a folder of that name', found(join(folder, 'empty'), bin), installed);
  process.chdir(join(folder, 'work'));
  equal('behind relative entries', found('', '.', 'bin', bin), installed);
  equal('in the workspace alone', found('.', '', join(folder, 'work')), undefined);
  equal('a folder whose name only begins as the workspace', findOnPath('proskill', bin, [join(folder, 'usr', 'b')]), installed);
  console.log('only what is installed is started');
} finally {
  rmSync(folder, { recursive: true });
}
