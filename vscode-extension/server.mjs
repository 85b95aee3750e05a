// What the .vsix carries: the server, and the libraries that other computers may not have.
//   linux-x64/proskill   (or linux-arm64)
//             lib/       libraries; the program finds them by its RPATH
//             lib/graphviz/  Graphviz's own plugins, which it looks for beside libgvc
//             fallback/  libraries that nearly every computer has, most in a version that fits it better
//             licences/  of each package that a library is from
import { execFileSync } from 'node:child_process';
import { chmodSync, copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';

/** The C library has to be that of the computer. */
const kSystem = /^(linux-vdso|ld-linux|lib(c|m|dl|pthread|rt|resolv)\.so)/;
const kTriple = { 'linux-x64': 'x86_64-linux-gnu', 'linux-arm64': 'aarch64-linux-gnu' };
const kFallback = /^lib(stdc\+\+|gcc_s|expat)\.so/;
/** SVG and DOT, and the two layouts that the pictures use. The panel makes PNGs. */
const kPlugins = ['core', 'dot_layout', 'neato_layout'];

const run = (...command) => execFileSync(command[0], command.slice(1), { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });

/** The libraries and licences of a target: on this system, or where scripts/arm64.sh has unpacked them. */
class Native {
  strip = 'strip';

  /** The libraries that the loader would load: names and paths. */
  librariesOf(file) {
    const out = run('ldd', file);
    if (/not found/.test(out)) throw new Error(`${file} lacks a library:\n${out}`);
    return [...out.matchAll(/^\s*(\S+) => (\S+)/gm)].map(([, name, path]) => ({ name, path }));
  }

  /** The licence under which the package is redistributed. */
  licence(file) {
    for (const path of [realpathSync(file), file, file.replace(/^\/usr/, '')]) {
      try {
        const name = run('dpkg-query', '--search', path).split(':')[0];
        return { name, path: `/usr/share/doc/${name}/copyright` };
      } catch {
        // the package may know the file under another name
      }
    }
    throw new Error(`the licence of ${file} is not known: the extension is packed on Debian or something like it`);
  }
}

class Unpacked {
  constructor(root, triple) {
    this.root = root;
    this.strip = `${triple}-strip`;
    this.folders = [`usr/lib/${triple}`, `lib/${triple}`].map((folder) => join(root, folder)).filter(existsSync);
    this.packages = new Map(readFileSync(join(root, 'files'), 'utf8').trim().split('\n').map((line) => line.split('\t')));
  }

  /** All dependencies of a file, transitively. */
  librariesOf(file, known = new Map()) {
    for (const [, name] of run('readelf', '--dynamic', '--wide', file).matchAll(/\(NEEDED\).*\[(.*)\]/g)) {
      if (known.has(name)) continue;
      const folder = this.folders.find((it) => existsSync(join(it, name)));
      if (!folder && kSystem.test(name)) continue;
      if (!folder) throw new Error(`${file} lacks ${name}`);
      known.set(name, join(folder, name));
      this.librariesOf(join(folder, name), known);
    }
    return [...known].map(([name, path]) => ({ name, path }));
  }

  licence(file) {
    const places = [file, realpathSync(file)].map((path) => path.slice(this.root.length));
    const name = places.flatMap((path) => [path, path.replace(/^\/usr/, ''), `/usr${path}`]).map((path) => this.packages.get(path)).find(Boolean);
    if (!name) throw new Error(`the licence of ${file} is not known`);
    return { name, path: join(this.root, 'usr/share/doc', name, 'copyright') };
  }
}

/** The part of Graphviz's list of plugins about those that are included. */
function configuration(folder) {
  const name = readdirSync(folder).find((it) => /^config\d/.test(it));
  if (!name) throw new Error(`${folder} has no list of Graphviz's plugins; as root: dot -c`);
  const blocks = readFileSync(join(folder, name), 'utf8').split(/^(?=libgvplugin_)/m).slice(1);
  return { name, text: blocks.filter((it) => kPlugins.some((plugin) => it.startsWith(`libgvplugin_${plugin}.`))).join('') };
}

function put(from, to, strip) {
  copyFileSync(from, to);
  chmodSync(to, 0o755);
  run(strip, to);
}

/** Fills a folder with the program and its dependencies. `root`: where the libraries of another architecture are unpacked. */
export function carry(program, folder, target = 'linux-x64', root = null) {
  rmSync(folder, { recursive: true, force: true });
  for (const part of ['lib/graphviz', 'fallback', 'licences']) mkdirSync(join(folder, part), { recursive: true });
  const system = root ? new Unpacked(root, kTriple[target]) : new Native();
  const needed = new Map(system.librariesOf(program).map((it) => [it.name, it.path]));
  const graphviz = join(dirname(needed.get([...needed.keys()].find((name) => name.startsWith('libgvc.')))), 'graphviz');
  for (const plugin of kPlugins) {
    const name = readdirSync(graphviz).find((it) => new RegExp(`^libgvplugin_${plugin}\\.so\\.\\d+$`).test(it));
    put(join(graphviz, name), join(folder, 'lib/graphviz', name), system.strip);
    for (const it of system.librariesOf(join(graphviz, name))) needed.set(it.name, it.path);
  }
  // It lists the plugins and their features, which are the same for each architecture. Making it requires running a program, so this system's is
  // used.
  const { name, text } = configuration(root ? `/usr/lib/${kTriple['linux-x64']}/graphviz` : graphviz);
  writeFileSync(join(folder, 'lib/graphviz', name), text);
  put(program, join(folder, 'proskill'), system.strip);
  for (const [library, path] of needed) {
    if (kSystem.test(library)) continue;
    put(path, join(folder, kFallback.test(library) ? 'fallback' : 'lib', basename(library)), system.strip);
    const licence = system.licence(path);
    copyFileSync(licence.path, join(folder, 'licences', licence.name));
  }
}
