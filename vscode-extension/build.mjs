// Bundles the extension into dist/, and adds the other files of the .vsix.
//   node build.mjs [--server PROGRAM [--target linux-arm64 --root FOLDER]]
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as esbuild from 'esbuild';
import { carry } from './server.mjs';

const here = import.meta.dirname;
const tree = join(here, '..');
const put = (from, to) => {
  mkdirSync(join(here, to, '..'), { recursive: true });
  copyFileSync(from, join(here, to));
};

/** The licence of each bundled package, as the licences require. */
function licencesOf(sources) {
  const packages = new Set(sources.map((source) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(source)?.[0]).filter(Boolean));
  return [...packages].sort().map((folder) => {
    const { name, version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((it) => /^licen[cs]e/i.test(it));
    if (!file) throw new Error(`${name} has no licence that could be carried on`);
    return `${name} ${version}\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
  }).join(`\n${'-'.repeat(80)}\n\n`);
}

const { metafile } = await esbuild.build({
  entryPoints: [join(here, 'src/extension.ts')],
  outfile: join(here, 'dist/extension.js'),
  bundle: true, platform: 'node', format: 'cjs', target: 'node18', external: ['vscode'],
  minify: true, legalComments: 'none', metafile: true,
});
writeFileSync(join(here, 'dist/licences.txt'), licencesOf(Object.keys(metafile.inputs)));

for (const file of ['panel.js', 'panel.css']) put(join(tree, 'panel/dist', file), `panel/${file}`);
put(join(tree, 'docs/proskill.schema.json'), 'schemas/proskill.schema.json');
put(join(tree, 'docs/platform.schema.json'), 'schemas/platform.schema.json');
put(join(tree, 'LICENSE'), 'LICENSE');
// links to the manual do not work within the .vsix
writeFileSync(join(here, 'CHANGELOG.md'),
  readFileSync(join(tree, 'CHANGELOG.md'), 'utf8').replace(/\[([^\]]*)\]\((?!https?:)[^)]*\)/g, '$1'));

const option = (name) => {
  const at = process.argv.indexOf(name);
  return at > 0 ? process.argv[at + 1] : null;
};
const server = option('--server');
const target = option('--target') ?? 'linux-x64';
if (server) {
  rmSync(join(here, 'server'), { recursive: true, force: true });
  carry(server, join(here, 'server', target), target, option('--root'));
  put(join(tree, 'docs/diagnostics.md'), `server/${target}/docs/diagnostics.md`);
} else if (!existsSync(join(here, 'server'))) {
  console.log('without a server; it will be looked for in the path');
}
