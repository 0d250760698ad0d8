package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.jxmapviewer.viewer.Tile;
import org.jxmapviewer.viewer.TileFactory;
import org.jxmapviewer.viewer.TileFactoryInfo;
import org.sami.ui.EventThread;
import org.sami.ui.look.SemanticColor;

/**
 * The tiles of a base map, read by a thread of their own. Whoever paints takes what is there: a tile that is not read yet is
 * painted from a coarser one, or left free.
 */
final class OfflineTiles extends TileFactory implements AutoCloseable {
    /** The level of the nearest zoom, 0; one more and a map has more pixels than an int counts. */
    static final int FINEST_LEVEL = 22;

    static final int FARTHEST_ZOOM = 19;
    static final int TILE_PX = 256;

    private static final int MOST_TILES = 220;
    private static final int COARSER = 6; // levels to look for a coarser tile

    private final Optional<TileSource> source;
    private final Runnable repaint;
    private final Runnable asked;
    private final Consumer<String> problems;
    private final Optional<ExecutorService> reader;
    private final Map<String, StoredTile> tiles = new LinkedHashMap<>(MOST_TILES, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, StoredTile> eldest) {
            return size() > MOST_TILES;
        }
    };
    private boolean told;
    private long revision;
    private int asking;

    /**
     * Makes the tiles of a source, or of none.
     *
     * @param repaint is run when a tile has come
     * @param asked is run when a tile is asked for and none was waited for; while painting, so it paints nothing
     * @param problems is told once, in one line, when the source fails
     */
    OfflineTiles(Optional<TileSource> source, Runnable repaint, Runnable asked, Consumer<String> problems) {
        super(new TileFactoryInfo(
                source.map(TileSource::name).orElse("none"),
                0,
                FARTHEST_ZOOM,
                FINEST_LEVEL,
                TILE_PX,
                true,
                true,
                "",
                "x",
                "y",
                "z"));
        this.source = source;
        this.repaint = repaint;
        this.asked = asked;
        this.problems = problems;
        reader = source.map(OfflineTiles::reader);
    }

    /** One thread that asks the source for tiles, and closes it as its last task. */
    private static ExecutorService reader(TileSource source) {
        ThreadFactory daemons = task -> {
            Thread thread = new Thread(task, "map-tiles");
            thread.setDaemon(true);
            return thread;
        };
        ThreadPoolExecutor reader =
                new ThreadPoolExecutor(1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), daemons) {
                    @Override
                    protected void terminated() {
                        close(source);
                    }
                };
        reader.prestartCoreThread(); // else whoever shuts it down before its first task would close the source
        return reader;
    }

    Optional<TileSource> source() {
        return source;
    }

    /** Grows with each tile that has come: what was painted before is old then. */
    long revision() {
        return revision;
    }

    @Override
    public Tile getTile(int x, int y, int zoom) {
        StoredTile known = tiles.get(key(x, y, zoom));
        if (known != null) {
            return known;
        }
        StoredTile tile = new StoredTile(x, y, zoom);
        tiles.put(key(x, y, zoom), tile);
        startLoading(tile);
        return tile;
    }

    private static String key(int x, int y, int zoom) {
        return zoom + "/" + x + "/" + y;
    }

    @Override
    protected void startLoading(Tile tile) {
        StoredTile stored = (StoredTile) tile;
        Optional<ExecutorService> thread = reader.filter(one -> !one.isShutdown());
        thread.ifPresentOrElse(
                one -> {
                    asking++;
                    one.execute(() -> read(source.orElseThrow(), stored));
                },
                () -> stored.answer(Optional.empty()));
        if (asking == 1) {
            asked.run();
        }
    }

    /** Whether tiles that were asked for have not come yet. */
    boolean isReading() {
        return asking > 0;
    }

    private void read(TileSource from, StoredTile tile) {
        Optional<BufferedImage> image = Optional.empty();
        try {
            image = from.tile(FINEST_LEVEL - tile.getZoom(), tile.getX(), tile.getY());
        } catch (IOException | RuntimeException e) {
            EventThread.later(() -> tell(e.getMessage()));
        }
        Optional<BufferedImage> answer = image;
        EventThread.later(() -> {
            tile.answer(answer);
            revision++;
            asking--;
            repaint.run();
        });
    }

    private void tell(String problem) {
        if (!told) {
            told = true;
            problems.accept(problem);
        }
    }

    /** Paints the part of the base map that a viewport shows; the viewport is in pixels of the world at that zoom. */
    void paint(Graphics2D g, int zoom, Rectangle viewport) {
        if (source.isEmpty()) {
            return;
        }
        int across = 1 << (FINEST_LEVEL - zoom);
        int firstX = Math.max(0, Math.floorDiv(viewport.x, TILE_PX));
        int lastX = Math.min(across - 1, Math.floorDiv(viewport.x + viewport.width, TILE_PX));
        int firstY = Math.max(0, Math.floorDiv(viewport.y, TILE_PX));
        int lastY = Math.min(across - 1, Math.floorDiv(viewport.y + viewport.height, TILE_PX));
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        for (int x = firstX; x <= lastX; x++) {
            for (int y = firstY; y <= lastY; y++) {
                paint(g, zoom, x, y, x * TILE_PX - viewport.x, y * TILE_PX - viewport.y);
            }
        }
    }

    private void paint(Graphics2D g, int zoom, int x, int y, int left, int top) {
        int tooFine = Math.max(0, FINEST_LEVEL - zoom - source.orElseThrow().finestLevel());
        boolean missing = false;
        for (int up = tooFine; up <= tooFine + COARSER && zoom + up <= FARTHEST_ZOOM; up++) {
            StoredTile tile = (StoredTile) getTile(x >> up, y >> up, zoom + up);
            missing |= up == tooFine && tile.isMissing();
            if (tile.isLoaded()) {
                int part = TILE_PX >> up;
                if (part >= 1) {
                    int fromX = (x - (x >> up << up)) * part;
                    int fromY = (y - (y >> up << up)) * part;
                    g.drawImage(
                            tile.getImage(),
                            left,
                            top,
                            left + TILE_PX,
                            top + TILE_PX,
                            fromX,
                            fromY,
                            fromX + part,
                            fromY + part,
                            null);
                }
                return;
            }
        }
        if (missing) {
            g.setColor(SemanticColor.MAP_TEXT.withAlpha(130));
            g.drawString("no tile here", left + 12, top + TILE_PX / 2);
        }
    }

    /** Reads no more tiles, leaves one that is being read, and closes the source, beside the event thread. */
    @Override
    public void close() {
        reader.ifPresent(ExecutorService::shutdownNow);
    }

    private static void close(TileSource source) {
        try {
            source.close();
        } catch (IOException e) {
            // nothing was written to it
        }
    }

    @Override
    public void dispose() {
        close();
    }
}
