package org.sami.ui.map.base;

import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * How much of one file is read: a file with more is shown in part. The figures hold for all maps of one window, with a heap of 512 MiB.
 *
 * @param points how many points are kept; 8 bytes each, and at most as much again for coarser scales
 * @param outlines how many lines and rings are kept; some 300 bytes each
 * @param names how many named points are kept
 * @param seconds how long reading may take
 * @param nanos a clock
 */
public record MapFileLimits(int points, int outlines, int names, int seconds, LongSupplier nanos) {
    /** What is allowed to files that operators open. */
    public static final MapFileLimits OF_A_FILE = new MapFileLimits(4_000_000, 150_000, 2_000, 60, System::nanoTime);

    /** How many letters of a name are kept. */
    static final int NAME_LETTERS = 60;

    /** How many letters of an attribution are kept. */
    static final int ATTRIBUTION_LETTERS = 160;

    /** How many bytes the picture of one tile may have in its file. */
    static final int TILE_BYTES = 8_000_000;

    /** How many pixels a tile may be wide and high in its file. */
    static final int TILE_SIDE_PX = 2048;

    /** How much is painted into one tile: points of lines and outlines. */
    static final int TILE_POINTS = 400_000;

    /** A number as people read it. */
    static String number(long number) {
        return String.format(Locale.ROOT, "%,d", number);
    }

    /** A text of a file in one line of few letters, without anything that is no letter. */
    static String cut(String text, int letters) {
        String start = text.substring(0, Math.min(text.length(), 4 * letters));
        String line = start.replaceAll("\\p{C}+", " ").replaceAll("\\s+", " ").strip();
        return text.length() > start.length() || line.length() > letters
                ? line.substring(0, Math.min(line.length(), letters - 1)).strip() + "…"
                : line;
    }
}
