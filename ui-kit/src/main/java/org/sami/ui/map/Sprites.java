package org.sami.ui.map;

import java.awt.Graphics2D;
import java.awt.Transparency;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.palette.Theme;
import org.sami.ui.look.Look;

/**
 * Small pictures that are painted again and again: hulls, dots, names. Each is painted once in the pixels of the screen and kept until theme
 * or scale change; copying it costs a fiftieth of painting it. For the event thread.
 *
 * @param <K> identifies a picture within one theme and scale
 */
final class Sprites<K> {
    private static final int MOST = 2000;

    private final Map<K, Sprite> kept = new LinkedHashMap<>(256, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<K, Sprite> eldest) {
            return size() > MOST;
        }
    };
    private Optional<Style> style = Optional.empty();

    private record Style(Theme theme, int percent, double deviceScale) {}

    /**
     * A picture.
     *
     * @param width in logical pixels, as the height
     * @param deviceScale how many pixels of the screen a logical one is
     */
    record Sprite(BufferedImage image, double width, double height, double deviceScale) {

        /** Paints it with its left upper corner near a pixel: at a whole one of the screen, which keeps it sharp. */
        void paint(Graphics2D g, double left, double top) {
            long x = Math.round(left * deviceScale);
            long y = Math.round(top * deviceScale);
            if (deviceScale == 1) {
                g.drawImage(image, (int) x, (int) y, null);
            } else {
                double back = 1 / deviceScale;
                g.drawImage(image, new AffineTransform(back, 0, 0, back, x * back, y * back), null);
            }
        }

        /** Paints it with its middle near a pixel. */
        void paintAround(Graphics2D g, double x, double y) {
            paint(g, x - width / 2, y - height / 2);
        }
    }

    /**
     * The picture of a key, for these graphics.
     *
     * @param width in logical pixels, as the height
     * @param painter paints it, from the left upper corner on, when it has to be renewed
     */
    Sprite get(Graphics2D g, K key, double width, double height, Consumer<Graphics2D> painter) {
        Style now =
                new Style(Look.theme(), Look.scalePercent(), g.getTransform().getScaleX());
        if (!style.equals(Optional.of(now))) {
            kept.clear();
            style = Optional.of(now);
        }
        Sprite known = kept.get(key);
        if (known == null) {
            known = make(g, now.deviceScale(), width, height, painter);
            kept.put(key, known);
        }
        return known;
    }

    private static Sprite make(Graphics2D g, double scale, double width, double height, Consumer<Graphics2D> painter) {
        int across = Math.max(1, (int) Math.ceil(width * scale));
        int down = Math.max(1, (int) Math.ceil(height * scale));
        BufferedImage image = g.getDeviceConfiguration().createCompatibleImage(across, down, Transparency.TRANSLUCENT);
        Graphics2D own = image.createGraphics();
        own.scale(scale, scale);
        own.setRenderingHints(g.getRenderingHints());
        own.setFont(g.getFont());
        painter.accept(own);
        own.dispose();
        return new Sprite(image, across / scale, down / scale, scale);
    }
}
