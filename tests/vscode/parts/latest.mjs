// Actions of which only the newest is taken: an editor that follows steps ends at the last one.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { equal } from '../expect.mjs';
import { extension, need } from '../extension.mjs';

const [esbuild] = need('esbuild');
const folder = mkdtempSync(join(tmpdir(), 'proskill-latest-'));

try {
  const outfile = join(folder, 'latest.mjs');
  await esbuild.build({ entryPoints: [join(extension, 'src/latest.ts')], outfile, format: 'esm', platform: 'node' });
  const { Latest } = await import(outfile);
  const latest = new Latest();
  const begun = [];
  const gates = new Map();
  const action = (name) => () => new Promise((resolve, reject) => gates.set(begun.push(name) && name, { resolve, reject }));
  const whole = latest.take(action('first'));
  for (const name of ['second', 'third', 'fourth']) void latest.take(action(name));
  equal('in work', begun, ['first']);
  gates.get('first').reject(new Error('its file is gone'));
  await Promise.resolve().then(() => undefined).then(() => undefined);
  equal('in work after that', begun, ['first', 'fourth']);
  gates.get('fourth').resolve();
  equal('the failure', await whole.then(() => undefined, ({ message }) => message), 'its file is gone');
  void latest.take(action('fifth'));
  equal('a later one', begun, ['first', 'fourth', 'fifth']);
  console.log('the newest action is taken');
} finally {
  rmSync(folder, { recursive: true });
}
