package org.sami.ui.value;

/** Short ends of what was typed, for messages of one line. */
final class Excerpt {
    private static final int LONGEST = 24;

    private Excerpt() {}

    static String of(String text) {
        String line = text.strip().replaceAll("\\s+", " ");
        return line.length() <= LONGEST ? line : line.substring(0, LONGEST - 1) + "…";
    }
}
