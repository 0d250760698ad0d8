package org.sami.ui.table;

import java.awt.FontMetrics;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;

/** Breaks a text into lines of a width, between words or behind a hyphen where it can. */
public final class TextLines {
    private static final String MORE = "…";

    private TextLines() {}

    /**
     * The lines of a text; one at least.
     *
     * @param width in pixels; a word that is wider is broken
     * @param most how many lines there are at most; where there would be more, the last one ends in dots; a
     *     single one within a word
     */
    public static List<String> of(String text, FontMetrics metrics, int width, int most) {
        if (metrics.stringWidth(text) <= width && text.indexOf('\n') < 0) {
            return List.of(text);
        }
        if (most == 1) {
            return List.of(withMore(text.lines().findFirst().orElse(""), metrics, width));
        }
        List<String> lines = new ArrayList<>();
        for (String paragraph : text.split("\n", -1)) {
            int from = 0;
            do {
                int end = end(paragraph, from, metrics, width);
                lines.add(paragraph.substring(from, end).stripTrailing());
                from = end;
                while (from < paragraph.length() && paragraph.charAt(from) == ' ') {
                    from++;
                }
            } while (from < paragraph.length() && lines.size() <= most);
        }
        if (lines.size() > most) {
            lines.subList(most, lines.size()).clear();
            lines.set(most - 1, withMore(lines.get(most - 1), metrics, width));
        }
        return List.copyOf(lines);
    }

    /**
     * A text in one line that keeps its beginning and, of more letters, its end: so names that differ only there stay distinct.
     *
     * @param width in pixels
     */
    static String withEnd(String text, FontMetrics metrics, int width) {
        if (metrics.stringWidth(text) <= width) {
            return text;
        }
        IntFunction<String> cut = kept -> {
            int first = kept / 3;
            return text.substring(0, first) + MORE + text.substring(text.length() - (kept - first));
        };
        return cut.apply(most(text.length() - 1, kept -> metrics.stringWidth(cut.apply(kept)) <= width));
    }

    /** How many letters can be kept at most, by halves: each measuring lays out a whole line. */
    private static int most(int letters, IntPredicate fits) {
        int fit = 0;
        int tooMany = letters + 1;
        while (tooMany - fit > 1) {
            int middle = (fit + tooMany) >>> 1;
            if (fits.test(middle)) {
                fit = middle;
            } else {
                tooMany = middle;
            }
        }
        return fit;
    }

    /** Where the line ends that begins at a letter. */
    private static int end(String text, int from, FontMetrics metrics, int width) {
        if (metrics.stringWidth(text.substring(from)) <= width) {
            return text.length();
        }
        int best = -1;
        int wordsFrom = from;
        while (wordsFrom < text.length() && text.charAt(wordsFrom) == ' ') {
            wordsFrom++; // what a line is indented by is no place to break it
        }
        for (int at = wordsFrom + 1; at < text.length(); at++) {
            if (mayBreak(text, at)) {
                if (metrics.stringWidth(text.substring(from, at)) > width) {
                    break;
                }
                best = at;
            }
        }
        return best > 0 ? best : broken(text, from, metrics, width);
    }

    /** Whether a line may end before a letter: at a space, and behind a hyphen within a word. */
    private static boolean mayBreak(String text, int at) {
        boolean behindHyphen = at > 1
                && text.charAt(at - 1) == '-'
                && Character.isLetter(text.charAt(at - 2))
                && Character.isLetter(text.charAt(at));
        return text.charAt(at) == ' ' || behindHyphen;
    }

    /** Where a word is broken that does not fit. */
    private static int broken(String text, int from, FontMetrics metrics, int width) {
        int letters =
                most(text.length() - from, kept -> metrics.stringWidth(text.substring(from, from + kept)) <= width);
        return from + Math.max(1, letters);
    }

    private static String withMore(String line, FontMetrics metrics, int width) {
        int letters = most(line.length(), kept -> metrics.stringWidth(line.substring(0, kept) + MORE) <= width);
        return line.substring(0, letters).stripTrailing() + MORE;
    }
}
