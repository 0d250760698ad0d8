package org.sami.crw.report.picture;

import java.awt.Font;
import java.awt.FontMetrics;
import java.util.ArrayList;
import java.util.List;

/** Text that keeps to a width, in pixels. */
final class DrawnText {
    private static final String MORE = " \u2026";

    private DrawnText() {}

    /** The text, or as much of it as fits, with dots at its end. */
    static String fitting(String text, FontMetrics metrics, int width) {
        if (metrics.stringWidth(text) <= width) {
            return text;
        }
        int length = text.length();
        while (length > 0 && metrics.stringWidth(text.substring(0, length) + MORE) > width) {
            length--;
        }
        return text.substring(0, length) + MORE;
    }

    /** The text in lines that break between words; what does not fit into so many is left out, with dots. */
    static List<String> lines(String text, FontMetrics metrics, int width, int most) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder();
        for (String word : text.isEmpty() ? new String[0] : text.split(" ", -1)) {
            if (line.length() > 0 && metrics.stringWidth(line + " " + word) > width) {
                lines.add(line.toString());
                line.setLength(0);
            }
            line.append(line.length() == 0 ? "" : " ").append(word);
        }
        if (line.length() > 0) {
            lines.add(line.toString());
        }
        if (lines.size() <= most) {
            return lines.stream().map(l -> fitting(l, metrics, width)).toList();
        }
        List<String> shown = new ArrayList<>(lines.subList(0, most));
        shown.set(most - 1, fitting(lines.get(most - 1) + " " + lines.get(most), metrics, width));
        return shown;
    }

    /** The type of the pictures. */
    static Font font(int style, int size) {
        return new Font(Font.SANS_SERIF, style, size);
    }
}
