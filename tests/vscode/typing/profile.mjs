// What the browser does meanwhile, as a trace of Chromium.
const kFile = process.env.PROSKILL_TYPE_PROFILE;
const kCategories = ['toplevel', 'devtools.timeline', 'blink.user_timing', 'disabled-by-default-v8.cpu_profiler'];

/** Runs `action`, with a profile if one is wanted. */
export async function profiled(page, action) {
  if (!kFile) return action();
  const browser = page.context().browser();
  await browser.startTracing(page, { path: kFile, categories: kCategories });
  try {
    await action();
  } finally {
    await browser.stopTracing();
  }
  return undefined;
}
