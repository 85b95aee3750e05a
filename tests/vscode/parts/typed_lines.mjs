// Lines typed ahead of the server: what is requested and edited, and when. A fake VS Code types, moves carets and saves.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { mock } from 'node:test';
import { equal } from '../expect.mjs';
import { extension, need } from '../extension.mjs';

const [esbuild] = need('esbuild');
const folder = mkdtempSync(join(tmpdir(), 'proskill-typed-'));
const kManual = 1;
const kAfterDelay = 2;
const kUndo = 1;

const at = (line, character = 0) => ({ line, character });

/** Everything that was promised so far has happened. */
const settled = () => new Promise((resolve) => setImmediate(resolve));

const event = () => {
  const listeners = new Set();
  const on = (listener) => (listeners.add(listener), { dispose: () => listeners.delete(listener) });
  return { on, fire: (value) => [...listeners].forEach((listener) => listener(value)) };
};

/** One text in an editor; the answers of its server come when a test gives them. */
class World {
  events = { change: event(), close: event(), save: event(), selection: event() };
  asked = [];
  edits = [];
  isOn = true;
  selections = [];

  constructor(TypedLines, lines) {
    this.lines = lines;
    this.document = {
      uri: 'untitled:p', languageId: 'proskill',
      lineAt: (line) => ({ isEmptyOrWhitespace: !this.lines[line].trim() }),
    };
    this.editors = [{
      document: this.document, world: this,
      get selections() { return this.world.selections; },
      edit: async (build, stops) => {
        const edits = [];
        build({ replace: (range, text) => edits.push({ ...range, text }) });
        this.edits.push({ edits, stops });
        return true;
      },
    }];
    globalThis.world = this;
    this.typed = new TypedLines(() => ({ sendRequest: (type, params) => this.ask({ method: type.method, ...params }) }));
  }

  ask(request) {
    return new Promise((answer, fail) => this.asked.push({ request, answer, fail }));
  }

  /** The requests that nobody has answered. */
  get open() {
    return this.asked.map(({ request }) => request.lines ?? `${request.ch} ${request.position.line}:${request.position.character}`);
  }

  /** A character was typed, and VS Code asks for on-type edits: those that the test gives. */
  async type(ch, position, edits, token = { isCancellationRequested: false }) {
    const made = this.typed.middleware(this.document, position, ch, {}, token, async () => edits);
    await made;
    await settled();
  }

  /** The answer came too late. */
  typeAhead(ch, position) {
    return this.type(ch, position, undefined, { isCancellationRequested: true });
  }

  async caret(...lines) {
    this.selections = lines.map((line) => ({ active: at(line) }));
    this.events.selection.fire({ textEditor: { document: this.document } });
    await settled();
  }

  async change(start, end, text, reason) {
    this.events.change.fire({ document: this.document, reason, contentChanges: [{ range: { start, end }, rangeOffset: 0, text }] });
    await settled();
  }

  async answer(edits) {
    this.asked.shift().answer(edits);
    await settled();
  }

  async save(reason) {
    this.events.save.fire({ document: this.document, reason });
    await settled();
  }
}

const edit = (line) => ({ range: { start: at(line), end: at(line) }, newText: '  ' });

/** Enter at the end of line 1, while the server is busy; the caret is in line 2 then. */
async function ahead(world) {
  world.selections = [{ active: at(2) }];
  await world.typeAhead('\n', at(2));
}

const checks = {
  async 'a line is indented once the caret has left it, without an undo of its own'(world) {
    await ahead(world);
    equal('left', world.open, [[1]]);
    await world.answer([edit(1)]);
    equal('made', world.edits.map(({ edits, stops }) => [edits.map(({ text }) => text), stops]), [[['  '], { undoStopBefore: false, undoStopAfter: false }]]);
    equal('below the caret', world.open, []);
    await world.caret(3);
    equal('left, too', world.open, [[2]]);
  },
  async 'a key asks nothing while another request is under way'(world) {
    await ahead(world);
    for (let key = 0; key < 5; ++key) {
      await world.change(at(2, key), at(2, key), 'x');
      await world.caret(2);
    }
    equal('requests', world.open, [[1]]);
  },
  async 'edits that VS Code is about to make come first'(world) {
    world.selections = [{ active: at(2) }];
    await world.type('\n', at(2), [edit(2)]);
    equal('before', world.open, []);
    await world.change(at(2), at(2), '  ');
    equal('after', world.open, [[1]]);
  },
  async 'edits that VS Code does not make are not awaited for long'(world) {
    world.selections = [{ active: at(2) }];
    await world.type('\n', at(2), [edit(2)]);
    mock.timers.tick(1000);
    await settled();
    equal('requests', world.open, [[1]]);
  },
  async 'what the server has answered is not requested again'(world) {
    world.selections = [{ active: at(2) }];
    await world.type('\n', at(2), []);
    await world.type(')', at(2, 4), []);
    equal('the line above', world.open, []);
    await world.caret(3);
    equal('the line that was typed, not its parenthesis', world.open, [[2]]);
  },
  async 'nothing is edited after an undo'(world) {
    await ahead(world);
    await world.change(at(2), at(2, 3), '', kUndo);
    await world.answer([edit(1)]);
    equal('edits', world.edits, []);
    await world.caret(3);
    equal('requests', world.open, []);
  },
  async 'a line to which the caret has come back is indented later'(world) {
    await ahead(world);
    await world.caret(1);
    await world.answer([edit(1)]);
    equal('edits', world.edits, []);
    equal('the line that was left meanwhile', world.open, [[2]]);
    await world.answer([]);
    await world.caret(3);
    equal('left again', world.open, [[1]]);
    await world.answer([edit(1)]);
    equal('made', world.edits.length, 1);
  },
  async 'the lines of all carets stay as they are'(world) {
    await ahead(world);
    await world.answer([]);
    await world.caret(3, 2);
    equal('requests', world.open, []);
  },
  async 'the caret of another editor counts, too'(world) {
    world.editors.push({ document: world.document, selections: [{ active: at(1) }] });
    await ahead(world);
    equal('requests', world.open, []);
    world.editors.pop();
    await world.caret(2);
    equal('after it is closed', world.open, [[1]]);
  },
  async 'a text that the user has saved stays as it was saved'(world) {
    await ahead(world);
    await world.save(kManual);
    await world.answer([edit(1)]);
    await world.caret(3);
    equal('edits', world.edits, []);
    equal('requests', world.open, []);
  },
  async 'a text that was saved by itself does not'(world) {
    await ahead(world);
    await world.save(kAfterDelay);
    await world.answer([edit(1)]);
    equal('edits', world.edits.length, 1);
  },
  async 'nothing is requested once formatting on type is off'(world) {
    world.selections = [{ active: at(1) }, { active: at(2) }];
    await world.typeAhead('\n', at(2));
    world.isOn = false;
    await world.caret(3);
    equal('requests', world.open, []);
  },
  async 'a text that nobody sees waits'(world) {
    const [editor] = world.editors.splice(0);
    await ahead(world);
    equal('requests', world.open, []);
    world.editors.push(editor);
    await world.caret(2);
    equal('in view', world.open, [[1]]);
  },
  async 'a line is asked for again if its server has gone'(world) {
    await ahead(world);
    world.asked.shift().fail(new Error('gone'));
    await settled();
    equal('requests', world.open, []);
    await world.caret(2);
    equal('after the next event', world.open, [[1]]);
  },
  async 'lines keep their places when others are inserted or replaced'(world) {
    await ahead(world);
    await world.change(at(0), at(0), '\r\n\r\n');
    await world.answer([edit(1)]);
    equal('edits for a text of before', world.edits, []);
    equal('requests', world.open, [[3, 4]]);
    await world.change(at(0), at(6), '');
    await world.answer([edit(3)]);
    equal('edits after these lines are gone', world.edits, []);
  },
  async 'a text that is closed is forgotten'(world) {
    await ahead(world);
    world.events.close.fire(world.document);
    await world.answer([edit(1)]);
    await world.caret(3);
    equal('edits', world.edits, []);
    equal('requests', world.open, []);
  },
};

async function built() {
  const modules = {
    vscode: `const of = (name) => (listener) => world.events[name].on(listener);
      export const workspace = { onDidChangeTextDocument: of('change'), onDidCloseTextDocument: of('close'), onWillSaveTextDocument: of('save'),
        getConfiguration: () => ({ get: () => world.isOn }) };
      export const window = { onDidChangeTextEditorSelection: of('selection'), get visibleTextEditors() { return world.editors; } };
      export class Range { constructor(...at) { this.at = at; } }
      export const TextDocumentSaveReason = { Manual: ${kManual} };
      export const Disposable = { from: (...all) => ({ dispose: () => all.forEach((it) => it.dispose()) }) };`,
    client: `class Type { constructor(method) { this.method = method; } }
      export { Type as RequestType, Type as NotificationType };
      export const DocumentOnTypeFormattingRequest = { type: new Type('textDocument/onTypeFormatting') };`,
  };
  for (const [name, text] of Object.entries(modules)) writeFileSync(join(folder, `${name}.mjs`), text);
  const outfile = join(folder, 'typed_lines.mjs');
  const alias = { vscode: join(folder, 'vscode.mjs'), 'vscode-languageclient/node': join(folder, 'client.mjs') };
  await esbuild.build({ entryPoints: [join(extension, 'src/writing/typed_lines.ts')], outfile, bundle: true, format: 'esm', platform: 'node', alias });
  return (await import(outfile)).TypedLines;
}

try {
  const TypedLines = await built();
  mock.timers.enable({ apis: ['setTimeout'] });
  for (const [name, check] of Object.entries(checks)) {
    const world = new World(TypedLines, ['(defskill m', ':body', '((f)', '(g)', '(h)', '(i)', '']);
    await check(world);
    world.typed.dispose();
    console.log(`ok      ${name}`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
