// Calls put off until things have been quiet for a while.

export interface Debounced {
  (): void;
  /** Call at once if a call is due. */
  flush(): void;
}

/** Put off a call until `wait` milliseconds have passed without another one. */
export function debounce(wait: number, action: () => void): Debounced {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const run = () => {
    timer = undefined;
    action();
  };
  const call = () => {
    clearTimeout(timer);
    timer = setTimeout(run, wait);
  };
  const flush = () => {
    if (timer === undefined) return;
    clearTimeout(timer);
    run();
  };
  return Object.assign(call, { flush });
}
