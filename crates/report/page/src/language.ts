// Texts in the page's language: an object of English ones and one of Chinese ones with the same keys.

/** Which of both to take. */
export function texts<T>(english: T, chinese: T): T {
  return document.documentElement.lang.startsWith("zh") ? chinese : english;
}
