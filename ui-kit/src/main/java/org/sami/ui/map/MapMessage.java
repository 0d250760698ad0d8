package org.sami.ui.map;

import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import org.sami.ui.look.SemanticColor;

/** One line to whoever works on the map, on a plate at its lower edge; broken into several where the map is narrow. */
final class MapMessage {
    private static final double PAD = 8;
    private static final double ABOVE_THE_SCALE = 48;

    private String text = "";
    private boolean problem;

    /** Says something instead of what was said before; empty text says nothing. */
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
        List<String> lines = lines(metrics, paint.frame().width() - 4 * pad);
        int wide = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        double height = lines.size() * metrics.getHeight() + pad;
        double left = (paint.frame().width() - wide) / 2.0 - pad;
        double top = paint.frame().height() - Painting.px(ABOVE_THE_SCALE) - height;
        g.setColor(SemanticColor.SURFACE.withAlpha(240));
        g.fillRoundRect((int) left, (int) top, (int) (wide + 2 * pad), (int) height, 8, 8);
        g.setColor((problem ? SemanticColor.CRITICAL : SemanticColor.TEXT).get());
        for (int i = 0; i < lines.size(); i++) {
            g.drawString(lines.get(i), (int) (left + pad), (int)
                    (top + pad / 2 + i * metrics.getHeight() + metrics.getAscent()));
        }
    }

    private List<String> lines(FontMetrics metrics, double widest) {
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
