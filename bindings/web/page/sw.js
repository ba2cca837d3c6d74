// sw.js: keeps the files of this version, so that the page opens without a network. build.py fills in both names.
const kept = "muslin-VERSION";
self.addEventListener("install", (event) => {
    self.skipWaiting();
    event.waitUntil(caches.open(kept).then((cache) => cache.addAll(["./", ...FILES])));
});
self.addEventListener("activate", (event) => {
    const ours = (name) => name.startsWith("muslin-") && name !== kept;
    const old = (names) => Promise.all(names.filter(ours).map((name) => caches.delete(name)));
    event.waitUntil(
        caches
            .keys()
            .then(old)
            .then(() => self.clients.claim()),
    );
});
self.addEventListener("fetch", (event) => {
    event.respondWith(
        caches.match(event.request, { ignoreSearch: true }).then((found) => found ?? fetch(event.request)),
    );
});
