// Keeps the page's own files, so that it opens and says "last seen" where the base cannot be reached.
const FILES = ['./', 'page.js', 'page.css', 'dom.js', 'bases.js', 'link.js', 'chart.js', 'decisions.js', 'drawing.js', 'driving.js', 'field.js', 'fields.js', 'handles.js', 'panels.js', 'phases.js', 'pictures.js', 'readings.js', 'icon.svg', 'manifest.webmanifest', 'leaflet/leaflet-src.esm.js', 'leaflet/leaflet.css'];
/** What a service worker is told; types of workers and of pages exclude one another, and the page has many. */
interface WorkerEvent extends Event {
  waitUntil(done: Promise<unknown>): void;
}

interface FetchOfPage extends WorkerEvent {
  request: Request;
  respondWith(answer: Promise<Response>): void;
}

interface WorkerScope {
  addEventListener(name: 'install' | 'activate', heard: (event: WorkerEvent) => void): void;
  addEventListener(name: 'fetch', heard: (event: FetchOfPage) => void): void;
}

/** Tiles of the map are many, and each panorama has pictures: neither is kept. */
const PAGE = new Set(FILES.map((file) => new URL(file, self.location.href).href));
const worker = self as unknown as WorkerScope;
const CACHE = 'sami-session-5';

worker.addEventListener('install', (event) => event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(FILES))));
worker.addEventListener('activate', (event) =>
  event.waitUntil(caches.keys().then((names) => Promise.all(names.filter((name) => name !== CACHE).map((name) => caches.delete(name))))));
worker.addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET' || !PAGE.has(event.request.url)) {
    return;
  }
  event.respondWith(
    fetch(event.request)
      .then((answer) => {
        if (answer.ok) {
          const kept = answer.clone();
          event.waitUntil(caches.open(CACHE).then((cache) => cache.put(event.request, kept)));
        }
        return answer;
      })
      .catch(() => caches.match(event.request).then((kept) => kept ?? Response.error())));
});
