// The moment of the run that everything on the page shows: one time, many watchers.
export function createMoment(end) {
  const watchers = [];
  let time = null;
  return {
    end,
    get time() {
      return time;
    },
    // `source` is told to the watchers so that nobody answers itself.
    set(value, source) {
      time = Math.min(Math.max(value, 0), end);
      for (const watcher of watchers) watcher(time, source);
    },
    watch(watcher) {
      watchers.push(watcher);
    },
  };
}
