package org.sami.ui.map;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.palette.SemanticColor;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;

/** A heat map with its legend; the value under the pointer is shown. The scale goes from violet to yellow, darker is less. */
public final class HeatLayer extends MapLayer {
    /** Lightness rises evenly along the scale, so that it is read without colours too. */
    private static final Color[] SCALE = {
        new Color(0x3B0F70), new Color(0x8C2981), new Color(0xDE4968), new Color(0xFE9F6D), new Color(0xFCFDBF)
    };

    private static final double OPACITY = 0.72;
    private static final int LEGEND_WIDTH = 160;
    private static final int LEGEND_HEIGHT = 12;
    private static final int MARGIN = 12;

    private Optional<HeatMap> map = Optional.empty();
    private @Nullable BufferedImage image;

    public HeatLayer(String id, String title) {
        super(id, title);
    }

    /** Shows a heat map instead of the one before; none leaves the layer empty. */
    public void show(Optional<HeatMap> map) {
        if (map.equals(this.map)) {
            return;
        }
        this.map = map;
        image = map.map(HeatLayer::image).orElse(null);
        stillChanged();
    }

    private static BufferedImage image(HeatMap map) {
        BufferedImage image = new BufferedImage(map.columns(), map.rows(), BufferedImage.TYPE_INT_ARGB);
        for (int row = 0; row < map.rows(); row++) {
            for (int column = 0; column < map.columns(); column++) {
                double value = map.value(column, row);
                if (map.isShown(value)) {
                    image.setRGB(
                            column,
                            row,
                            Painting.alpha(color(map.part(value)), OPACITY).getRGB());
                }
            }
        }
        return image;
    }

    private static Color color(double part) {
        double at = part * (SCALE.length - 1);
        int index = Math.min(SCALE.length - 2, (int) at);
        double rest = at - index;
        Color low = SCALE[index];
        Color high = SCALE[index + 1];
        return new Color(
                between(low.getRed(), high.getRed(), rest),
                between(low.getGreen(), high.getGreen(), rest),
                between(low.getBlue(), high.getBlue(), rest));
    }

    private static int between(int low, int high, double part) {
        return (int) Math.round(low + part * (high - low));
    }

    @Override
    protected void paintStill(MapPaint paint) {
        map.ifPresent(heat -> {
            MapFrame frame = paint.frame();
            int left = (int) Math.round(frame.px(heat.bounds().corners().get(0)));
            int top = (int) Math.round(frame.py(heat.bounds().corners().get(0)));
            int right = (int) Math.round(frame.px(heat.bounds().corners().get(1)));
            int bottom = (int) Math.round(frame.py(heat.bounds().corners().get(1)));
            paint.g()
                    .setRenderingHint(
                            RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
            paint.g().drawImage(image, left, top, right - left, bottom - top, null);
            legend(paint, heat);
        });
    }

    private static void legend(MapPaint paint, HeatMap heat) {
        Graphics2D g = paint.g();
        paint.font(MapPaint.PLAIN);
        FontMetrics metrics = g.getFontMetrics();
        String head = heat.unit().isEmpty() ? heat.title() : heat.title() + " in " + heat.unit();
        String most = number(heat.most());
        int bar = (int) Painting.px(LEGEND_WIDTH);
        int thick = (int) Painting.px(LEGEND_HEIGHT);
        int margin = (int) Painting.px(MARGIN);
        int width = Math.max(bar, metrics.stringWidth(head)) + 2 * margin;
        int height = 2 * metrics.getHeight() + thick + (int) Painting.px(14);
        int left = margin;
        int top = margin;
        g.setColor(SemanticColor.SURFACE.withAlpha(230));
        g.fillRoundRect(left, top, width, height, 8, 8);
        int x = left + margin;
        int y = top + metrics.getHeight() + (int) Painting.px(4);
        for (int i = 0; i < bar; i++) {
            g.setColor(color(i / (double) (bar - 1)));
            g.fillRect(x + i, y, 1, thick);
        }
        g.setColor(SemanticColor.TEXT.get());
        g.drawString(head, x, top + metrics.getAscent() + (int) Painting.px(2));
        int base = y + thick + metrics.getAscent() + (int) Painting.px(2);
        g.drawString(number(heat.least()), x, base);
        g.drawString(most, x + bar - metrics.stringWidth(most), base);
        heat.threshold().ifPresent(threshold -> {
            int at = x + (int) Math.round(heat.part(threshold) * bar);
            g.fillRect(at - 1, y - 3, 3, thick + 6);
            String text = "≥ " + number(threshold);
            int middle = Math.max(
                    x + metrics.stringWidth(number(heat.least()) + "  "),
                    Math.min(
                            at - metrics.stringWidth(text) / 2,
                            x + bar - metrics.stringWidth(most + "  ") - metrics.stringWidth(text)));
            g.drawString(text, middle, base);
        });
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, Math.abs(value) >= 100 ? "%.0f" : "%.1f", value);
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return map.map(HeatMap::bounds);
    }

    @Override
    public Optional<String> textAt(MapFrame frame, double px, double py) {
        return map.flatMap(heat -> {
            var value = heat.at(frame.point(px, py));
            return value.isPresent()
                    ? Optional.of((heat.title() + " " + number(value.getAsDouble()) + " " + heat.unit()).strip())
                    : Optional.empty();
        });
    }
}
