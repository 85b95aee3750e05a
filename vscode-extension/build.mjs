// Bundles the extension into dist/, and puts beside it what the .vsix carries.
//   node build.mjs [--server PROGRAM]
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import * as esbuild from 'esbuild';
import { carry } from './server.mjs';

const here = import.meta.dirname;
const tree = join(here, '..');
const put = (from, to) => {
  mkdirSync(join(here, to, '..'), { recursive: true });
  copyFileSync(from, join(here, to));
};

await esbuild.build({
  entryPoints: [join(here, 'src/extension.ts')],
  outfile: join(here, 'dist/extension.js'),
  bundle: true, platform: 'node', format: 'cjs', target: 'node18', external: ['vscode'],
  minify: true, legalComments: 'linked',
});

for (const file of ['panel.js', 'panel.css']) put(join(tree, 'panel/dist', file), `panel/${file}`);
put(join(tree, 'docs/proskill.schema.json'), 'schemas/proskill.schema.json');
put(join(tree, 'LICENSE'), 'LICENSE');
// Links to the manual lead nowhere within the .vsix.
writeFileSync(join(here, 'CHANGELOG.md'),
  readFileSync(join(tree, 'CHANGELOG.md'), 'utf8').replace(/\[([^\]]*)\]\((?!https?:)[^)]*\)/g, '$1'));

const at = process.argv.indexOf('--server');
if (at > 0) {
  carry(process.argv[at + 1], join(here, 'server/linux-x64'));
} else if (!existsSync(join(here, 'server'))) {
  console.log('without a server; it will be looked for in the path');
}
