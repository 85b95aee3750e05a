// Makes the .vsix:  node package.mjs SERVER FILE.vsix [TARGET ROOT]
// TARGET: linux-x64, or linux-arm64 with the ROOT into which its libraries are unpacked (scripts/arm64.sh).
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { install } from './install.mjs';

const [server, file] = process.argv.slice(2, 4).map((path) => resolve(path));
const [target = 'linux-x64', root] = process.argv.slice(4);
const manifest = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8'));
const run = (...args) => execFileSync(process.execPath, args, { cwd: import.meta.dirname, stdio: ['ignore', 'inherit', 'inherit'] });

install();
run('node_modules/typescript/bin/tsc', '--noEmit');
run('build.mjs', '--server', server, '--target', target, ...(root ? ['--root', resolve(root)] : []));
mkdirSync(dirname(file), { recursive: true });
// There is no public address yet; with one in package.json, vsce checks the links of the README against it.
const unpublished = manifest.repository ? [] : ['--allow-missing-repository'];
run('node_modules/@vscode/vsce/vsce', 'package', '--no-dependencies', ...unpublished,
  '--skip-license', '--target', target, '--out', file);
