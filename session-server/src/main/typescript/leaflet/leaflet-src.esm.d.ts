// What this page uses of Leaflet 1.9.4 (the library brings no types): https://leafletjs.com/reference.html

export type Point2 = [number, number];

export interface LatLng {
  lat: number;
  lng: number;
}

export interface LatLngBounds {
  pad(ratio: number): LatLngBounds;
  contains(other: LatLngBounds): boolean;
}

export interface Point {
  readonly x: number;
  readonly y: number;
  distanceTo(other: Point): number;
}

export interface LeafletMouseEvent {
  latlng: LatLng;
  originalEvent: MouseEvent;
}

export interface MapOptions {
  zoomControl?: boolean;
  attributionControl?: boolean;
  doubleClickZoom?: boolean;
  maxZoom?: number;
  preferCanvas?: boolean;
}

export interface Map {
  setView(center: Point2, zoom: number): this;
  fitBounds(bounds: LatLngBounds, options: {maxZoom?: number, animate?: boolean}): this;
  getBounds(): LatLngBounds;
  getContainer(): HTMLElement;
  createPane(name: string): HTMLElement;
  invalidateSize(): this;
  mouseEventToLatLng(event: MouseEvent): LatLng;
  latLngToContainerPoint(at: Point2): Point;
  on(type: 'click', heard: (event: LeafletMouseEvent) => void): this;
  on(type: 'dragstart' | 'zoomend', heard: () => void): this;
}

export interface Layer {
  addTo(place: Map | LayerGroup): this;
  remove(): this;
  bindTooltip(content: HTMLElement, options: {permanent?: boolean, direction?: 'top' | 'center', offset?: Point2, className?: string}): this;
}

export interface LayerGroup extends Layer {
  addLayer(layer: Layer): this;
  removeLayer(layer: Layer): this;
  clearLayers(): this;
  getLayers(): Layer[];
}

export interface Icon {
  readonly options: object;
}

export interface Marker extends Layer {
  setLatLng(at: Point2): this;
  getLatLng(): LatLng;
  getElement(): HTMLElement | undefined;
  setIcon(icon: Icon): this;
  on(type: 'click', heard: (event: LeafletMouseEvent) => void): this;
  on(type: 'dragstart' | 'drag' | 'dragend', heard: () => void): this;
}

export interface MarkerOptions {
  icon: Icon;
  keyboard?: boolean;
  draggable?: boolean;
  autoPan?: boolean;
  zIndexOffset?: number;
}

export interface PathOptions {
  color?: string;
  weight?: number;
  dashArray?: string;
  fill?: boolean;
  fillOpacity?: number;
  interactive?: boolean;
}

export interface Control {
  addTo(map: Map): this;
  remove(): this;
}

export interface AttributionControl extends Control {
  addAttribution(html: string): this;
}

export const control: {
  zoom(options: {position: 'topright'}): Control;
  scale(options: {position: 'topright', imperial: boolean}): Control;
  attribution(options: {prefix: false}): AttributionControl;
};

export function map(id: string, options: MapOptions): Map;
export function latLngBounds(points: Point2[]): LatLngBounds;
export function layerGroup(): LayerGroup;
export function tileLayer(address: string, options: {minNativeZoom?: number, maxNativeZoom?: number, maxZoom?: number, crossOrigin?: boolean}): Layer;
export function imageOverlay(address: string, corners: [Point2, Point2], options: {pane?: string, opacity?: number, className?: string, interactive?: boolean}): Layer;
export function divIcon(options: {className?: string, iconSize?: Point2, html?: HTMLElement}): Icon;
export function marker(at: Point2, options: MarkerOptions): Marker;
export function circleMarker(at: Point2, options: PathOptions & {radius: number}): Layer;
export function polyline(points: Point2[] | Point2[][], options: PathOptions): Layer;
export function polygon(rings: Point2[][], options: PathOptions): Layer;
