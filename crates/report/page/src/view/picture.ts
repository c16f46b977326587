// A PNG of what is seen, with its bar and caption.
import { drawOverlay, type Overlay, wrapped } from "./overlay";
import { words } from "./words";

/** Saves the canvas, which has just been drawn, with what is written over it and a caption below. */
export function savePicture(canvas: HTMLCanvasElement, over: Overlay, caption: string[]): Promise<Blob | null> {
  const fine = canvas.width / over.width;
  const picture = document.createElement("canvas");
  const pen = picture.getContext("2d")!;
  const font = '12px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
  pen.font = font;
  const lines = caption.flatMap((line) => wrapped(pen, line, over.width - 24));
  picture.width = canvas.width;
  picture.height = canvas.height + Math.round((lines.length * 17 + 16) * fine);
  pen.fillStyle = over.paper;
  pen.fillRect(0, 0, picture.width, picture.height);
  pen.drawImage(canvas, 0, 0);
  pen.scale(fine, fine);
  drawOverlay(pen, over);
  pen.font = font;
  pen.fillStyle = over.ink;
  lines.forEach((line, i) => pen.fillText(line, 12, over.height + 14 + 17 * i));
  return new Promise((done) => picture.toBlob(done, "image/png"));
}

/** Hands a picture to the browser to be kept. */
export function keep(blob: Blob) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = words.pictureName;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
