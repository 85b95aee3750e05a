// Positions in a text before and after edits: marks of the Testing view and the caret in an automaton follow them.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { equal } from '../expect.mjs';
import { extension, need } from '../extension.mjs';

const [esbuild] = need('esbuild');
const folder = mkdtempSync(join(tmpdir(), 'proskill-edits-'));
const kUri = 'file:///p.proskill';

const at = (line, character) => ({ line, character });

/** The text of an editor, of which every edit is noted. */
class Text {
  version = 1;

  constructor(Edits, text) {
    this.edits = new Edits();
    this.text = text;
  }

  offset({ line, character }) {
    return this.text.split('\n').slice(0, line).reduce((sum, it) => sum + it.length + 1, 0) + character;
  }

  place(offset) {
    const lines = this.text.slice(0, offset).split('\n');
    return at(lines.length - 1, lines.at(-1).length);
  }

  replace(from, to, text) {
    const rangeOffset = this.offset(from);
    this.edits.note({ document: { uri: kUri, version: ++this.version }, contentChanges: [{ range: { start: from, end: to }, rangeOffset, text }] });
    this.text = this.text.slice(0, rangeOffset) + text + this.text.slice(this.offset(to));
  }
}

/** Where each letter of the older text is now, if it is still there; and back. */
function compare(text, letters, before) {
  for (const letter of letters) {
    const now = text.text.indexOf(letter);
    if (now < 0) continue;
    equal(`${letter} now`, text.edits.now(kUri, before.get(letter)), text.place(now));
    equal(`${letter} formerly`, text.edits.former({ uri: kUri, range: { start: text.place(now) } }).range.start, before.get(letter));
  }
}

const checks = {
  'inserted lines move what follows'(text) {
    text.replace(at(0, 1), at(0, 1), '1\n2\n3');
  },
  'removed lines move what follows'(text) {
    text.replace(at(0, 1), at(2, 0), '');
  },
  'an edit within a line moves the rest of the line'(text) {
    text.replace(at(1, 0), at(1, 1), '123');
  },
  'edits add up'(text) {
    text.replace(at(2, 1), at(2, 1), '\n');
    text.replace(at(0, 0), at(0, 0), '1\n');
    text.replace(at(1, 1), at(1, 2), '2\n3');
    text.replace(at(4, 0), at(4, 1), '');
  },
};

try {
  const outfile = join(folder, 'edits.mjs');
  await esbuild.build({ entryPoints: [join(extension, 'src/writing/edits.ts')], outfile, bundle: true, format: 'esm', platform: 'node' });
  const { Edits } = await import(outfile);
  for (const [name, edit] of Object.entries(checks)) {
    const text = new Text(Edits, 'abc\ndef\nghi\njkl\n');
    const letters = [...'abcdefghijkl'];
    const before = new Map(letters.map((letter) => [letter, text.place(text.text.indexOf(letter))]));
    edit(text);
    compare(text, letters, before);
    text.edits.forgetAll(kUri);
    equal('after the text was read again', text.edits.now(kUri, at(3, 2)), at(3, 2));
    console.log(`ok      ${name}`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
