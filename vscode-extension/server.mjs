// What the .vsix carries: the server, and the libraries that other computers may not have.
//   linux-x64/proskill
//             lib/       libraries; the program finds them by its RPATH
//             lib/graphviz/  Graphviz's own plugins, which it looks for beside libgvc
//             fallback/  libraries that nearly every computer has, most in a version that fits it better
//             licences/  of each package that a library is from
import { execFileSync } from 'node:child_process';
import { chmodSync, copyFileSync, mkdirSync, readFileSync, readdirSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';

/** The C library has to be the computer's own. */
const kSystem = /^(linux-vdso|ld-linux|lib(c|m|dl|pthread|rt|resolv)\.so)/;
const kFallback = /^lib(stdc\+\+|gcc_s|expat)\.so/;
/** SVG and DOT, and the two ways to place nodes that the pictures use. PNGs are made by the panel. */
const kPlugins = ['core', 'dot_layout', 'neato_layout'];

const run = (...command) => execFileSync(command[0], command.slice(1), { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** What the loader would load for a program or a library: names and paths. */
function librariesOf(file) {
  const out = run('ldd', file);
  if (/not found/.test(out)) throw new Error(`${file} lacks a library:\n${out}`);
  return [...out.matchAll(/^\s*(\S+) => (\S+)/gm)].map(([, name, path]) => ({ name, path }));
}

/** Of the list of Graphviz's plugins, the part about those that are carried. */
function configuration(folder) {
  const name = readdirSync(folder).find((it) => /^config\d/.test(it));
  if (!name) throw new Error(`${folder} has no list of Graphviz's plugins; as root: dot -c`);
  const blocks = readFileSync(join(folder, name), 'utf8').split(/^(?=libgvplugin_)/m).slice(1);
  return { name, text: blocks.filter((it) => kPlugins.some((plugin) => it.startsWith(`libgvplugin_${plugin}.`))).join('') };
}

/** The package's licence, by which it is carried on. */
function licence(file, to) {
  const paths = [realpathSync(file), file, file.replace(/^\/usr/, '')];
  for (const path of paths) {
    try {
      const name = run('dpkg-query', '--search', path).split(':')[0];
      copyFileSync(`/usr/share/doc/${name}/copyright`, join(to, name));
      return;
    } catch {
      // The package may know the file by another of its names.
    }
  }
  throw new Error(`the licence of ${file} is not known: the extension is packed on Debian or something like it`);
}

function put(from, to) {
  copyFileSync(from, to);
  chmodSync(to, 0o755);
  run('strip', to);
}

/** Fills a folder with the program and what it needs. */
export function carry(program, folder) {
  rmSync(folder, { recursive: true, force: true });
  for (const part of ['lib/graphviz', 'fallback', 'licences']) mkdirSync(join(folder, part), { recursive: true });
  const needed = new Map(librariesOf(program).map((it) => [it.name, it.path]));
  const graphviz = join(dirname(needed.get([...needed.keys()].find((name) => name.startsWith('libgvc.')))), 'graphviz');
  for (const plugin of kPlugins) {
    const name = readdirSync(graphviz).find((it) => new RegExp(`^libgvplugin_${plugin}\\.so\\.\\d+$`).test(it));
    put(join(graphviz, name), join(folder, 'lib/graphviz', name));
    for (const it of librariesOf(join(graphviz, name))) needed.set(it.name, it.path);
  }
  const { name, text } = configuration(graphviz);
  writeFileSync(join(folder, 'lib/graphviz', name), text);
  put(program, join(folder, 'proskill'));
  for (const [library, path] of needed) {
    if (kSystem.test(library)) continue;
    put(path, join(folder, kFallback.test(library) ? 'fallback' : 'lib', basename(library)));
    licence(path, join(folder, 'licences'));
  }
}
