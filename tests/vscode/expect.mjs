/** Polls until the condition is true. */
export async function expect(what, ask, timeout = 90_000) {
  const end = Date.now() + timeout;
  let last;
  do {
    try {
      last = undefined;
      const found = await ask();
      if (found) return found;
    } catch (error) {
      last = error;
    }
    await new Promise((resolve) => setTimeout(resolve, 60));
  } while (Date.now() < end);
  throw new Error(`not seen: ${what}${last ? ` (${last.message})` : ''}`);
}

export function equal(what, found, wanted) {
  const [left, right] = [found, wanted].map((value) => JSON.stringify(value));
  if (left !== right) throw new Error(`${what}: ${left}, where ${right} was expected`);
}
