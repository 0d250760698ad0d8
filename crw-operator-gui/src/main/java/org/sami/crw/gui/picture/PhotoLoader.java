package org.sami.crw.gui.picture;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.sami.picture.photo.Photo;
import org.sami.picture.photo.PhotoReader;
import org.sami.ui.EventThread;

/** Reads pictures on a separate thread, and caches the latest that were shown, up to a number of pixels. On the event thread. */
final class PhotoLoader implements AutoCloseable {
    private static final long MOST_PIXELS = 24_000_000;
    private static final int IDLE_S = 10;

    private final Runnable read;
    private final ThreadPoolExecutor reader;
    private final Map<Wanted, Photo> kept =
            new LinkedHashMap<>(16, 0.75f, true); // the one that was shown last is the last
    private final Set<Wanted> reading = new HashSet<>();
    private boolean closed;

    private record Wanted(Path file, int widthPx, int heightPx) {}

    /**
     * A loader without pictures.
     *
     * @param read is called on the event thread when a picture has been read
     */
    PhotoLoader(Runnable read) {
        this.read = read;
        reader = new ThreadPoolExecutor(1, 1, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
            Thread thread = new Thread(work, "pictures");
            thread.setDaemon(true);
            return thread;
        });
        reader.allowCoreThreadTimeOut(true);
    }

    /** A picture that fits into a box of pixels; empty while it is being read. */
    Optional<Photo> photo(Path file, int widthPx, int heightPx) {
        Wanted wanted = new Wanted(file, step(widthPx), step(heightPx));
        Optional<Photo> here = Optional.ofNullable(kept.get(wanted));
        if (here.isEmpty() && !closed && reading.add(wanted)) {
            reader.execute(() -> {
                Photo photo = PhotoReader.read(file, wanted.widthPx(), wanted.heightPx());
                EventThread.later(() -> keep(wanted, photo));
            });
        }
        return here;
    }

    /** Rounds sizes down to steps, so that a picture is not read again for each pixel by which a panel grows. */
    private static int step(int px) {
        int step = px < 64 ? 1 : px < 512 ? 32 : 256;
        return px / step * step;
    }

    private void keep(Wanted wanted, Photo photo) {
        reading.remove(wanted);
        kept.put(wanted, photo);
        long pixels = kept.values().stream().mapToLong(PhotoLoader::pixels).sum();
        Iterator<Photo> oldest = kept.values().iterator();
        while (pixels > MOST_PIXELS && kept.size() > 1) {
            pixels -= pixels(oldest.next());
            oldest.remove();
        }
        read.run();
    }

    private static long pixels(Photo photo) {
        return photo.image()
                .map(image -> (long) image.getWidth() * image.getHeight())
                .orElse(1L);
    }

    @Override
    public void close() {
        closed = true;
        reader.shutdownNow();
    }
}
