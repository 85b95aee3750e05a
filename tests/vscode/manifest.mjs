// What the extension promises in its package.json, it has, says and carries:  node manifest.mjs
// Commands and settings are described, there and in docs/vscode.md; every command that is named anywhere is
// there; every file that is named is in the .vsix.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { extension, need, read, tree } from './extension.mjs';

const [vsce] = need('@vscode/vsce');
const manifest = JSON.parse(read('package.json'));
const { contributes } = manifest;
const manual = readFileSync(join(tree, 'docs/vscode.md'), 'utf8');
const complaints = [];
const wanted = (condition, words) => condition || complaints.push(words);

/** Whether it begins and ends like a sentence. */
const isSentence = (text) => /^[A-Z`].*\.$/s.test(text ?? '');

function commands() {
  const registered = new Set([...read('src/extension.ts').matchAll(/command\('([\w.]+)'/g)].map(([, name]) => name));
  const titles = new Set();
  for (const { command, title, category } of contributes.commands) {
    wanted(/^[A-Z]/.test(title) && category === 'ProSkill', `${command} has no title, or not the category of the others`);
    wanted(!titles.has(title), `two commands are called "${title}"`);
    wanted(registered.has(command), `${command} does nothing: src/extension.ts does not register it`);
    wanted(manual.includes(`**${title}**`), `docs/vscode.md does not name the command "${title}"`);
    titles.add(title);
  }
  return new Set(contributes.commands.map(({ command }) => command));
}

/** Commands that VS Code looks up: in menus, keys and the walkthrough; lenses have their own test. */
function mentions(known) {
  const text = JSON.stringify([contributes.menus, contributes.keybindings, contributes.walkthroughs]);
  const named = [...text.matchAll(/(?:command:|onCommand:|"command":")(proskill\.\w+)/g)].map(([, name]) => name);
  wanted(named.length > contributes.commands.length, 'the mentions of commands are not found');
  for (const name of new Set(named)) wanted(known.has(name), `${name} is in a menu, a key or the walkthrough, and is no command`);
}

/** The manual's row of a setting. In a row with several, those after the first show their last word only: `.megabytes`. */
function rowOf(name) {
  return manual.split('\n').filter((line) => line.startsWith('| `proskill.')).find((row) => {
    const [first, ...others] = [...row.split('|')[1].matchAll(/`([\w.]+)`/g)].map(([, shown]) => shown);
    return [first, ...others.map((word) => first.replace(/\.\w+$/, word))].includes(name);
  });
}

function settings() {
  const all = contributes.configuration.flatMap(({ properties }) => Object.entries(properties));
  for (const [name, { type, markdownDescription, default: usual, scope }] of all) {
    wanted(isSentence(markdownDescription), `${name} is not described by a sentence`);
    wanted(type && scope && usual !== undefined, `${name} has no type, no scope or no default`);
    const row = rowOf(name);
    wanted(row, `docs/vscode.md does not have the setting ${name}`);
    wanted(!row || usual === '' || row.includes(`\`${usual}\``), `docs/vscode.md has another default of ${name} than ${usual}`);
  }
  for (const [, name] of manual.matchAll(/`(proskill\.[a-z]+\.\w+)`/g))
    wanted(all.some(([known]) => known === name), `docs/vscode.md has the setting ${name}, which there is not`);
  return all.length;
}

function debuggers() {
  for (const { configurationAttributes, configurationSnippets } of contributes.debuggers) {
    for (const [name, { type, description }] of Object.entries(configurationAttributes.launch.properties))
      wanted(type && isSentence(description), `"${name}" of launch.json is not described by a sentence`);
    for (const { label, description } of configurationSnippets) wanted(isSentence(description), `"${label}" is not described by a sentence`);
  }
}

/** Every path in package.json, and the pictures and pages in those. */
function filesNamed() {
  const named = [];
  const walk = (value) => {
    if (typeof value === 'string' && /^(\.\/)?[\w./-]+\.(js|json|svg|png|md)$/.test(value) && value !== '.proskill.json') named.push(posix.normalize(value));
    else if (value && typeof value === 'object') Object.entries(value).forEach(([key, inner]) => key === 'fileMatch' || walk(inner));
  };
  walk({ main: manifest.main, icon: manifest.icon, contributes });
  return [...new Set(named)];
}

async function files() {
  execFileSync(process.execPath, [join(extension, 'build.mjs')], { stdio: 'pipe' });
  const carried = new Set(await vsce.listFiles({ cwd: extension, packageManager: vsce.PackageManager.None }));
  const named = [...filesNamed(), 'panel/panel.js', 'panel/panel.css', 'dist/licences.txt', 'README.md', 'CHANGELOG.md', 'LICENSE', 'package.json'];
  for (const file of named) wanted(carried.has(file), `${file} is not in the .vsix`);
  for (const file of carried)
    wanted(!/^(src|node_modules|\.)|\.mjs$|\.map$|tsconfig/.test(file), `${file} has no place in the .vsix`);
  return named.length;
}

/** Where the sources are, and where problems are reported: none before there is a public address, else all, beginning with it; the README says which. */
function addresses() {
  const { repository, bugs, homepage } = manifest;
  const known = [repository?.url, bugs?.url, homepage].filter(Boolean);
  wanted(known.length === 0 || known.length === 3, 'package.json has some of repository, bugs and homepage, but not all');
  for (const address of known) wanted(/^https:\/\/(?!.*(localhost|example))/.test(address), `${address} is not a public address`);
  wanted(/no public address/.test(read('README.md')) === (known.length === 0), 'README.md and package.json disagree on whether there is a public address');
}

/** What the marketplace shows and requires. */
function metadata() {
  const { publisher, displayName, description, version, license, categories, keywords, icon, galleryBanner, pricing, engines } = manifest;
  for (const [name, value] of Object.entries({ publisher, displayName, version, license, icon, pricing, engine: engines?.vscode }))
    wanted(typeof value === 'string' && value !== '', `package.json has no ${name}`);
  wanted(description?.length > 40 && description.length < 200, 'the description is not a sentence that a list can show');
  wanted(categories?.length > 0 && keywords?.length > 3 && keywords.length <= 30, 'categories or keywords are missing, or more than 30');
  wanted(/^#[0-9a-f]{6}$/.test(galleryBanner?.color ?? '') && /^(dark|light)$/.test(galleryBanner?.theme ?? ''), 'the banner has no colour, or no theme');
  const picture = readFileSync(join(extension, icon));
  wanted(picture.readUInt32BE(16) >= 128 && picture.readUInt32BE(20) >= 128, 'the icon is smaller than 128 by 128');
  for (const [file, words] of [['README.md', '# ProSkill'], ['CHANGELOG.md', '# Changelog'], ['LICENSE', 'MIT']])
    wanted(read(file).includes(words), `${file} does not say ${words}`);
  wanted(!/!\[[^\]]*\]\((?!https:)/.test(read('README.md')), 'README.md shows a picture that the marketplace cannot find');
}

function walkthroughs() {
  for (const { steps } of contributes.walkthroughs)
    for (const { id, title, description, media } of steps)
      wanted(title && description && (media.markdown || media.altText), `the walkthrough's step "${id}" lacks words`);
}

const known = commands();
mentions(known);
const count = settings();
debuggers();
walkthroughs();
const named = await files();
addresses();
metadata();
for (const complaint of complaints) console.log(complaint);
console.log(`${known.size} commands, ${count} settings, ${named} files, ${complaints.length} complaints`);
process.exit(complaints.length ? 1 : 0);
