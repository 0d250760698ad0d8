package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.map.base.BaseSource;
import org.sami.ui.map.base.BaseStyle;
import org.sami.ui.map.base.TileKey;

/**
 * The tiles of a base map on one map view. Whoever paints takes what is there: a tile that has not come yet is painted from those of
 * another scale, or left free. What is painted is images only, whatever the file holds. On the event thread.
 */
final class BaseTiles implements AutoCloseable {
    private static final long MOST_BYTES = 64L << 20; // with what is seen now, which is kept in any case
    private static final int MOST_TILES = 1000; // also those without a picture

    /** A tile is asked for under its place and, as outlines are painted in it, its style. */
    private record Asked(TileKey key, BaseStyle style) {}

    private final BaseSource source;
    private final TileReader reader;
    private final Runnable come;
    private final Runnable asked;
    private final Consumer<String> problems;
    private final Map<Asked, StoredTile> tiles = new LinkedHashMap<>(256, 0.75f, true);
    private boolean told;
    private int asking;
    private long painting;

    /**
     * The tiles of a source.
     *
     * @param owns whether it closes the source in the end
     * @param come is run when tiles have come
     * @param asked is run when a tile is asked for and none was waited for; while painting, so it paints nothing
     * @param problems receives one line, once, when the source fails
     */
    BaseTiles(BaseSource source, boolean owns, Runnable come, Runnable asked, Consumer<String> problems) {
        this.source = source;
        this.come = come;
        this.asked = asked;
        this.problems = problems;
        reader = new TileReader(source, owns, this::take);
    }

    /** Whether tiles that were asked for have not come yet. */
    boolean isReading() {
        return asking > 0;
    }

    private void take(List<TileReader.Answer> answers) {
        for (TileReader.Answer answer : answers) {
            answer.tile().answer(answer.image());
            asking--;
            if (answer.problem().isPresent() && !told) {
                told = true;
                problems.accept(answer.problem().get());
            }
        }
        come.run();
    }

    /** Paints the part that a frame shows, in whole pixels of the screen. */
    void paint(Graphics2D graphics, MapFrame frame) {
        painting++;
        double device = graphics.getTransform().getScaleX();
        BaseStyle style = BaseStyle.now(device);
        double scale = source.tileScale(frame.worldPx() * device);
        Graphics2D g = (Graphics2D) graphics.create();
        g.scale(1 / device, 1 / device);
        g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
        double across = scale / TileKey.PX;
        int firstX = first(frame.centreX() - frame.width() / 2.0 / frame.worldPx(), across);
        int lastX = last(frame.centreX() + frame.width() / 2.0 / frame.worldPx(), across);
        int firstY = first(frame.centreY() - frame.height() / 2.0 / frame.worldPx(), across);
        int lastY = last(frame.centreY() + frame.height() / 2.0 / frame.worldPx(), across);
        for (int x = firstX; x <= lastX; x++) {
            for (int y = firstY; y <= lastY; y++) {
                paint(g, new Device(frame, device), new TileKey(scale, x, y), style);
            }
        }
        g.dispose();
        withdraw();
        forget();
    }

    private static int first(double edge, double across) {
        return (int) Math.max(0, Math.floor(edge * across));
    }

    private static int last(double edge, double across) {
        return (int) Math.min(Math.ceil(across) - 1, Math.floor(edge * across));
    }

    private StoredTile tile(TileKey key, BaseStyle style) {
        StoredTile tile = tiles.computeIfAbsent(new Asked(key, style), any -> {
            StoredTile next = new StoredTile(key, style);
            reader.ask(next);
            asking++;
            return next;
        });
        tile.use(painting);
        if (asking == 1 && !tile.isAnswered()) {
            asked.run();
        }
        return tile;
    }

    /** A tile, else the nearest coarser one that is there; while that is not known, what there is of another scale. */
    private void paint(Graphics2D g, Device at, TileKey place, BaseStyle style) {
        TileKey key = place;
        while (true) {
            StoredTile tile = tile(key, style);
            if (tile.image().isPresent()) {
                at.paint(g, tile.image().get(), key, place);
                return;
            }
            OptionalDouble coarser = source.coarser(key.worldPx());
            if (!tile.isAnswered()) {
                other(place).forEach(one -> at.paint(g, one.image().orElseThrow(), one.key(), place));
                return;
            }
            if (coarser.isEmpty()) {
                if (source.isImagery()) {
                    at.note(g, place);
                }
                return;
            }
            key = place.at(coarser.getAsDouble());
        }
    }

    /** The pictures of the scale that is nearest to that of a tile, of those that lie there. */
    private List<StoredTile> other(TileKey place) {
        List<StoredTile> nearest = new ArrayList<>();
        double far = Double.POSITIVE_INFINITY;
        for (StoredTile one : tiles.values()) {
            if (one.image().isPresent() && overlap(one.key(), place)) {
                double apart = Math.abs(Math.log(one.key().worldPx() / place.worldPx()));
                if (apart < far) {
                    nearest.clear();
                    far = apart;
                }
                if (apart == far) {
                    nearest.add(one);
                }
            }
        }
        return nearest;
    }

    private static boolean overlap(TileKey one, TileKey other) {
        return one.left() < other.left() + other.side()
                && other.left() < one.left() + one.side()
                && one.top() < other.top() + other.side()
                && other.top() < one.top() + one.side();
    }

    /** Nobody waits any longer for tiles that were asked for and are not seen now. */
    private void withdraw() {
        Iterator<StoredTile> each = tiles.values().iterator();
        while (each.hasNext()) {
            StoredTile tile = each.next();
            if (!tile.isAnswered() && tile.used() < painting && reader.withdraw(tile)) {
                asking--;
                each.remove();
            }
        }
    }

    /** Forgets what was not seen for longest, beyond what memory allows; never what is seen now. */
    private void forget() {
        long bytes = tiles.values().stream().mapToLong(StoredTile::bytes).sum();
        Iterator<StoredTile> eldest = tiles.values().iterator();
        while ((bytes > MOST_BYTES || tiles.size() > MOST_TILES) && eldest.hasNext()) {
            StoredTile tile = eldest.next();
            if (tile.used() < painting && tile.isAnswered()) {
                bytes -= tile.bytes();
                eldest.remove();
            }
        }
    }

    /** Forgets all pictures: the map is not seen for a while. */
    void clear() {
        tiles.values().removeIf(StoredTile::isAnswered);
    }

    /** Reads no more tiles, leaves one that is being read, and closes a source that it owns, off the event thread. */
    @Override
    public void close() {
        reader.close();
    }

    /**
     * A frame in pixels of the screen.
     *
     * @param scale how many pixels of the screen a logical one is
     */
    private record Device(MapFrame frame, double scale) {
        private long x(double unit) {
            return Math.round(frame.px(unit) * scale);
        }

        private long y(double unit) {
            return Math.round(frame.py(unit) * scale);
        }

        /** Paints the part of a picture that lies on a tile; its whole pixels only, however large they are on the screen. */
        void paint(Graphics2D graphics, BufferedImage image, TileKey from, TileKey place) {
            long left = x(place.left());
            long top = y(place.top());
            long right = x(place.left() + place.side());
            long bottom = y(place.top() + place.side());
            Graphics2D g = (Graphics2D) graphics.create();
            g.clipRect((int) left, (int) top, (int) (right - left), (int) (bottom - top));
            if (from.equals(place) && right - left == image.getWidth() && bottom - top == image.getHeight()) {
                g.drawImage(image, (int) left, (int) top, null);
            } else {
                part(g, image, from, place);
            }
            g.dispose();
        }

        private void part(Graphics2D g, BufferedImage image, TileKey from, TileKey place) {
            double unitX = image.getWidth() / from.side();
            double unitY = image.getHeight() / from.side();
            double unitLeft = Math.max(place.left(), frame.centreX() - frame.width() / 2.0 / frame.worldPx());
            double unitTop = Math.max(place.top(), frame.centreY() - frame.height() / 2.0 / frame.worldPx());
            double unitRight =
                    Math.min(place.left() + place.side(), frame.centreX() + frame.width() / 2.0 / frame.worldPx());
            double unitBottom =
                    Math.min(place.top() + place.side(), frame.centreY() + frame.height() / 2.0 / frame.worldPx());
            int x0 = (int) Math.max(0, Math.floor((unitLeft - from.left()) * unitX) - 1);
            int y0 = (int) Math.max(0, Math.floor((unitTop - from.top()) * unitY) - 1);
            int x1 = (int) Math.min(image.getWidth(), Math.ceil((unitRight - from.left()) * unitX) + 1);
            int y1 = (int) Math.min(image.getHeight(), Math.ceil((unitBottom - from.top()) * unitY) + 1);
            if (x1 > x0 && y1 > y0) {
                AffineTransform to = new AffineTransform();
                to.translate(frame.px(from.left() + x0 / unitX) * scale, frame.py(from.top() + y0 / unitY) * scale);
                to.scale(frame.worldPx() * scale / unitX, frame.worldPx() * scale / unitY);
                g.drawImage(image.getSubimage(x0, y0, x1 - x0, y1 - y0), to, null);
            }
        }

        void note(Graphics2D g, TileKey place) {
            g.setColor(SemanticColor.MAP_TEXT.withAlpha(130));
            g.drawString("no tile here", (int) x(place.left()) + 12, (int) y(place.top() + place.side() / 2));
        }
    }
}
