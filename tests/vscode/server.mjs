// The server that the extension carries runs on other computers: it needs nothing of them but the C library, and what
// it draws does not depend on their fonts.   node server.mjs PROSKILL
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { carry } from '../../vscode-extension/server.mjs';
import { equal } from './expect.mjs';
import { tree } from './extension.mjs';

const kSystem = /\/(ld-linux-x86-64|libc|libm)\.so/;
const kNearlyEverywhere = /\/lib(stdc\+\+|gcc_s|expat)\.so/;
/** That of Ubuntu 22.04. */
const kNewest = 35;

if (spawnSync('dpkg-query', ['--version']).status !== 0) {
  console.log('skipped: the extension is packed on Debian and the like alone; there is no dpkg');
  process.exit(77);
}
const proskill = resolve(process.argv[2]);
const folder = mkdtempSync(join(tmpdir(), 'proskill-carried-'));
const carried = join(folder, 'proskill');
const pictures = [['body', 'drone', 'uav_mission'], ['sv', 'drone', 'flight_status'], ['skill', 'lift', 'open_doors']];

function draw(program, [kind, example, name], env = {}) {
  const file = join(tree, 'examples', example, `${example}.proskill`);
  const { stdout, stderr, status } = spawnSync(program, ['graph', '--kind', kind, '--name', name, '--format', 'svg', file],
    { encoding: 'utf8', env: { PATH: '/nowhere', ...env }, maxBuffer: 1 << 26 });
  equal(`the end of ${program} drawing ${name}: ${stderr.split('\n')[0]}`, status, 0);
  return { stdout, stderr };
}

/** The files that the loader has opened. */
const loaded = (stderr) => [...new Set([...stderr.matchAll(/calling init: (\S+)/g)].map(([, path]) => path))];

function checkLoaded(picture, env, system) {
  const { stderr } = draw(carried, picture, { LD_DEBUG: 'files', ...env });
  const files = loaded(stderr);
  const layout = picture[2] === 'flight_status' ? 'neato' : 'dot';
  equal(`Graphviz's ${layout} is loaded`, files.some((path) => path.includes(`libgvplugin_${layout}_layout`)), true);
  equal('libraries of this computer', files.filter((path) => !path.startsWith(folder) && !system.some((it) => it.test(path))), []);
}

function newestVersion(file) {
  const versions = execFileSync('objdump', ['-T', file], { encoding: 'utf8' }).matchAll(/GLIBC_2\.(\d+)/g);
  return Math.max(...[...versions].map(([, minor]) => Number(minor)));
}

try {
  carry(proskill, folder);
  for (const picture of pictures) {
    equal(`the picture of ${picture[2]}`, draw(carried, picture).stdout === draw(proskill, picture).stdout, true);
    checkLoaded(picture, {}, [kSystem, kNearlyEverywhere]);
    checkLoaded(picture, { LD_LIBRARY_PATH: join(folder, 'fallback') }, [kSystem]);
  }
  const libraries = ['lib', 'lib/graphviz'].flatMap((part) => readdirSync(join(folder, part)).filter((name) => name.includes('.so')).map((name) => join(folder, part, name)));
  const newest = Math.max(...[carried, ...libraries].map(newestVersion));
  equal(`glibc 2.${newest} is enough for Ubuntu 22.04`, newest <= kNewest, true);
  console.log(`${libraries.length} libraries are carried; glibc 2.${newest} is needed`);
} finally {
  rmSync(folder, { recursive: true });
}
