// A layer of readings on the map: an image of coloured cells, or lines of equal value.
import * as L from './leaflet/leaflet-src.esm.js';
import type {Contour, Layer} from './protocol.js';

/** The colours of the operator's window, from the least to the greatest value. */
const SCALE = [[0x3B, 0x0F, 0x70], [0x8C, 0x29, 0x81], [0xDE, 0x49, 0x68], [0xFE, 0x9F, 0x6D], [0xFC, 0xFD, 0xBF]];
const OPACITY = 0.7;

/** The colour of a part of the way from least to greatest. @param part 0 to 1 @returns red, green, blue */
export function colorOf(part: number): number[] {
  const at = Math.min(SCALE.length - 2, Math.floor(part * (SCALE.length - 1)));
  const rest = part * (SCALE.length - 1) - at;
  return SCALE[at].map((low, i) => Math.round(low + rest * (SCALE[at + 1][i] - low)));
}

export class Field {
  layer: L.LayerGroup;

  /** @param map of Leaflet */
  constructor(map: L.Map) {
    map.createPane('readings').style.zIndex = '350'; // below areas and ways
    this.layer = L.layerGroup().addTo(map);
  }

  /** Draws a layer in place of the one before. @param shown as the session's server gives it */
  show(shown: Layer | null) {
    this.layer.clearLayers();
    if (!shown) {
      return;
    }
    if (shown.contours) {
      this.contours(shown, shown.contours);
    } else {
      L.imageOverlay(Field.image(shown), [[shown.south, shown.west], [shown.north, shown.east]], {pane: 'readings', opacity: OPACITY, className: 'field-image', interactive: false}).addTo(this.layer);
    }
  }

  contours(shown: Layer, contours: Contour[]) {
    for (const one of contours) {
      const part = shown.greatest > shown.least ? (one.value - shown.least) / (shown.greatest - shown.least) : 0.5;
      L.polyline(one.segments, {color: 'rgb(' + colorOf(part).join() + ')', weight: 3, interactive: false}).addTo(this.layer);
    }
  }

  /** The cells as an image, a pixel each; 0 is clear. */
  static image(shown: Layer) {
    const cells = Uint8Array.from(atob(shown.cells), (sign) => sign.charCodeAt(0));
    const canvas = document.createElement('canvas');
    canvas.width = shown.columns;
    canvas.height = cells.length / shown.columns;
    const context = canvas.getContext('2d') as CanvasRenderingContext2D;
    const pixels = context.createImageData(canvas.width, canvas.height);
    cells.forEach((cell, at) => cell > 0 && pixels.data.set([...colorOf((cell - 1) / 254), 255], 4 * at));
    context.putImageData(pixels, 0, 0);
    return canvas.toDataURL();
  }
}
