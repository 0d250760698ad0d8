package org.sami.ui.map;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.sami.palette.SemanticColor;

/**
 * One line to the user of the map, on a plate at its lower edge: next to the scale, where nothing that lies in the middle is hidden below it; above
 * the scale where there is no room, and broken into several lines where the map is narrow. Where it would lie on a vehicle there it stands at the upper edge, if that is free. It
 * hides no more than a part of a low map: what has no room is left out from a clause on where one ends, else within it, and dots stand for it.
 */
final class MapMessage {
    private static final String MORE = "…";
    private static final Pattern ENDS = Pattern.compile(" · |; "); // of what is said by itself
    private static final double PAD = 8;
    private static final double ABOVE_THE_SCALE = 48;
    private static final double MOST_OF_HEIGHT = 0.15;
    private static final double MARGIN = 8; // to the edge and to the scale

    private String text = "";
    private boolean problem;
    private boolean free = true;
    private boolean above;
    private List<Rectangle2D> vehicles = List.of();

    /** Whether the lower right corner is free of other text, such as a base map's attribution. */
    void setFree(boolean lowerRight) {
        free = lowerRight;
    }

    /** Where vehicles are, in pixels: it does not stand on them, where it can. */
    void avoid(List<Rectangle2D> vehicles) {
        this.vehicles = List.copyOf(vehicles);
    }

    /** Replaces the message; empty text removes it. */
    void say(String text, boolean problem) {
        this.text = text;
        this.problem = problem;
    }

    String text() {
        return text;
    }

    void paint(MapPaint paint) {
        if (text.isEmpty()) {
            return;
        }
        Graphics2D g = paint.g();
        paint.font(problem ? Font.BOLD : MapPaint.PLAIN);
        FontMetrics metrics = g.getFontMetrics();
        double pad = Painting.px(PAD);
        List<String> lines = lines(paint, metrics);
        Rectangle2D plate = plate(paint);
        g.setColor(SemanticColor.SURFACE.withAlpha(240));
        g.fillRoundRect((int) plate.getX(), (int) plate.getY(), (int) plate.getWidth(), (int) plate.getHeight(), 8, 8);
        g.setColor((problem ? SemanticColor.CRITICAL : SemanticColor.TEXT).get());
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), (int) (plate.getX() + pad), (int)
                    (plate.getY() + pad / 2 + i * metrics.getHeight() + metrics.getAscent()));
        }
    }

    /** Names go elsewhere than below it, where there is room. */
    void reserve(MapPaint paint) {
        if (!text.isEmpty()) {
            Font font = paint.g().getFont();
            Rectangle2D plate = plate(paint);
            paint.labels().addText(plate.getX(), plate.getY(), plate.getWidth(), plate.getHeight());
            paint.g().setFont(font);
        }
    }

    private static double widest(MapPaint paint) {
        return paint.frame().width() - 4 * Painting.px(PAD);
    }

    /** Where its plate is, in pixels. It changes its edge only to leave a vehicle, so that it does not jump to and fro. */
    Rectangle2D plate(MapPaint paint) {
        Rectangle2D below = lowerPlate(paint);
        Rectangle2D upper =
                new Rectangle2D.Double(below.getX(), Painting.px(MARGIN), below.getWidth(), below.getHeight());
        if (hides(above ? upper : below) && !hides(above ? below : upper)) {
            above = !above;
        }
        return above ? upper : below;
    }

    private boolean hides(Rectangle2D plate) {
        return vehicles.stream().anyMatch(plate::intersects);
    }

    private Rectangle2D lowerPlate(MapPaint paint) {
        paint.font(MapPaint.PLAIN);
        double scale = MapScale.right(paint);
        paint.font(problem ? Font.BOLD : MapPaint.PLAIN);
        FontMetrics metrics = paint.g().getFontMetrics();
        List<String> lines = lines(paint, metrics);
        double pad = Painting.px(PAD);
        int wide = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        double height = lines.size() * metrics.getHeight() + pad;
        double left = (paint.frame().width() - wide) / 2.0 - pad;
        double margin = Painting.px(MARGIN);
        if (free
                && lines.size() == 1
                && scale + wide + 2 * pad + 2 * margin <= paint.frame().width()) {
            return new Rectangle2D.Double(
                    Math.max(left, scale + margin), paint.frame().height() - margin - height, wide + 2 * pad, height);
        }
        double top = paint.frame().height() - Painting.px(ABOVE_THE_SCALE) - height;
        return new Rectangle2D.Double(left, top, wide + 2 * pad, height);
    }

    /** The lines that it has room for; one at least. */
    List<String> lines(MapPaint paint, FontMetrics metrics) {
        double widest = widest(paint);
        List<String> all = lines(text, metrics, widest);
        int most =
                Math.max(1, (int) ((MOST_OF_HEIGHT * paint.frame().height() - Painting.px(PAD)) / metrics.getHeight()));
        if (all.size() <= most) {
            return all;
        }
        Optional<List<String>> whole = ENDS.matcher(text)
                .results()
                .map(end -> lines(text.substring(0, end.start()) + " " + MORE, metrics, widest))
                .filter(first -> first.size() <= most)
                .reduce((shorter, longer) -> longer);
        if (whole.isPresent()) {
            return whole.get();
        }
        String last = all.get(most - 1) + MORE;
        while (last.length() > 1 && metrics.stringWidth(last) > widest) {
            last = last.substring(0, last.length() - 2) + MORE;
        }
        List<String> shown = new ArrayList<>(all.subList(0, most - 1));
        shown.add(last);
        return shown;
    }

    private static List<String> lines(String text, FontMetrics metrics, double widest) {
        List<String> lines = new ArrayList<>();
        String line = "";
        for (String word : text.split(" ", -1)) {
            String longer = line.isEmpty() ? word : line + " " + word;
            if (!line.isEmpty() && metrics.stringWidth(longer) > widest) {
                lines.add(line);
                line = word;
            } else {
                line = longer;
            }
        }
        lines.add(line);
        return lines;
    }
}
