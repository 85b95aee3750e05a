// Live results in the Testing view: what is shown, when, and how much at once. A fake VS Code notes it.
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { mock } from 'node:test';
import { equal } from '../expect.mjs';
import { extension, need } from '../extension.mjs';

const [esbuild] = need('esbuild');
const folder = mkdtempSync(join(tmpdir(), 'proskill-live-'));
const kProgram = 'file:///p.proskill';
const kProperties = 1000;

async function built() {
  writeFileSync(join(folder, 'vscode.mjs'), 'export class TestRunRequest {}\n');
  const outfile = join(folder, 'live_results.mjs');
  await esbuild.build({ entryPoints: [join(extension, 'src/testing/live_results.ts')], outfile, bundle: true, format: 'esm', platform: 'node', alias: { vscode: join(folder, 'vscode.mjs') } });
  return (await import(outfile)).LiveResults;
}

/** The view with one program of many properties, and what it has shown. */
class World {
  batches = [];
  runs = { begun: 0, ended: 0 };
  invalidated = 0;
  saved = 0;
  /** in milliseconds */
  now = 0;
  typingUntil = 0;

  constructor(LiveResults, count = kProperties) {
    this.names = Array.from({ length: count }, (_, i) => `p${i}`);
    this.item = { id: kProgram };
    const controller = {
      items: new Map([[kProgram, this.item]]),
      createTestRun: () => (++this.runs.begun, { end: () => ++this.runs.ended }),
      invalidateTestResults: () => ++this.invalidated,
    };
    this.live = new LiveResults(controller, { get: () => this.program }, this, {
      itemsOf: () => new Map(this.names.map((name) => [name, { name }])),
      show: (run, items, verdicts) => this.batches.push(verdicts.map(({ name, verdict }) => `${name} ${verdict}`)),
      save: () => ++this.saved,
    });
  }

  /** Milliseconds until the user no longer counts as typing. */
  get rest() {
    return Math.max(Math.min(this.typingUntil, 1e9) - this.now, 0);
  }

  /** Verdicts as the server sends them; properties are good but those that are named. */
  send(bad, more) {
    this.batches = [];
    this.program = { program: kProgram, state: 'done', stale: false, ...more,
      verdicts: this.names.map((name) => ({ name, verdict: bad.includes(name) ? 'violated' : 'holds', good: !bad.includes(name), severity: 'error' })) };
    this.live.take(this.program);
  }

  /** The results that these verdicts show. */
  async verified(bad = [], more = {}) {
    this.send(bad, more);
    await this.pass(10_000);
    equal('runs that have not ended', this.runs.begun - this.runs.ended, 0);
    return this.batches.flat();
  }

  edited(state = 'waiting') {
    this.program = { ...this.program, state, stale: state !== 'off' };
    this.live.edited(this.item);
  }

  /** Milliseconds, in steps in which promises go on. */
  async pass(milliseconds) {
    for (let passed = 0; passed < milliseconds; passed += 10) {
      this.now += 10;
      mock.timers.tick(10);
      await Promise.resolve();
    }
  }
}

const checks = {
  async 'all results are shown once, some at a time'(world) {
    const shown = await world.verified(['p7']);
    equal('results', shown.length, kProperties);
    equal('a bad one', shown.includes('p7 violated'), true);
    equal('at once', Math.max(...world.batches.map((it) => it.length)) <= 25, true);
    equal('runs', world.runs.begun, 1);
    equal('saved', world.saved, 1);
  },

  async 'after an edit only what has changed is shown'(world) {
    await world.verified(['p7']);
    world.edited();
    equal('results', await world.verified(['p8']), ['p7 holds', 'p8 violated']);
    world.edited();
    equal('results of the same verdicts', await world.verified(['p8']), []);
    equal('outdated', world.invalidated, 0);
  },

  async 'results become outdated if no verification follows, and all are shown again'(world) {
    await world.verified();
    world.edited('errors');
    await world.pass(4000);
    equal('outdated soon', world.invalidated, 0);
    world.edited('errors');
    await world.pass(4000);
    equal('outdated while the user types', world.invalidated, 0);
    await world.pass(2000);
    equal('outdated', world.invalidated, 1);
    world.edited('errors');
    await world.pass(10_000);
    equal('outdated twice', world.invalidated, 1);
    equal('results', (await world.verified()).length, kProperties);
  },

  async 'without live verification they are outdated at once'(world) {
    await world.verified();
    world.edited('off');
    equal('outdated', world.invalidated, 1);
  },

  async 'a run of the user counts'(world) {
    await world.verified(['p1', 'p2'], { state: 'off' });
    world.live.ran(kProgram, world.program.verdicts.slice(0, 900));
    equal('results of the others', (await world.verified(['p1', 'p2'])).length, 100);
  },

  async 'an edit ends the showing of former verdicts'(world) {
    world.send([], {});
    await world.pass(100);
    world.edited();
    const shown = world.batches.flat().length;
    equal('some are shown', shown > 0 && shown < kProperties, true);
    await world.pass(1000);
    equal('and no more', world.batches.flat().length, shown);
    equal('the others', (await world.verified(['p0'])).length, kProperties - shown + 1);
  },

  async 'many results wait until the user stops typing, and a few do not'(world) {
    await world.verified();
    world.typingUntil = Infinity;
    equal('a few', await world.verified(['p1', 'p2']), ['p1 violated', 'p2 violated']);
    world.typingUntil = world.now + 2000;
    world.send(world.names.slice(0, 500), {});
    await world.pass(1900);
    equal('results while the user types', world.batches.length, 0);
    await world.pass(3000);
    equal('results', world.batches.flat().length, 498);
    world.send([], {});
    await world.pass(200);
    world.typingUntil = world.now + 2000;
    const shown = world.batches.flat().length;
    await world.pass(1900);
    equal('results after the first key', world.batches.flat().length, shown);
    equal('runs that have not ended', world.runs.begun - world.runs.ended, 0);
    await world.pass(5000);
    equal('all of them', world.batches.flat().length, 500);
  },

  async 'each run of a small program shows all of its results, for the counts above the tree'(LiveWorld) {
    const world = new World(LiveWorld.live.constructor, 60);
    await world.verified(['p7']);
    world.edited();
    const shown = await world.verified(['p8']);
    equal('what has changed, first', shown.slice(0, 2), ['p7 holds', 'p8 violated']);
    equal('results', new Set(shown).size, 60);
    equal('runs', world.runs.begun, 2);
    world.edited();
    equal('without a change', await world.verified(['p8']), []);
  },

  async 'VS Code forgets old runs, so all results are shown again in time'(LiveWorld) {
    const world = new World(LiveWorld.live.constructor, 140);
    await world.verified();
    let again = 0;
    for (let i = 0; i < 128 && !again; ++i) {
      world.edited();
      if ((await world.verified([`p${i % 140}`])).length >= 140) again = i;
    }
    equal('shown again before the 128th run', again > 30, true);
  },
};

try {
  const LiveResults = await built();
  mock.timers.enable({ apis: ['setTimeout'] });
  for (const [name, check] of Object.entries(checks)) {
    const world = new World(LiveResults);
    await check(world);
    world.live.dispose();
    console.log(`ok      ${name}`);
  }
} finally {
  rmSync(folder, { recursive: true });
}
