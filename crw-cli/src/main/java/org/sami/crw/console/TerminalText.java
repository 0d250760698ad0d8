package org.sami.crw.console;

/**
 * Text as it may be shown on a terminal: names come from files, boats and links, and may hold what a terminal obeys. Control characters are
 * shown as JSON escapes them, and so are those that turn the direction of text. Line ends and tabs stay.
 */
public final class TerminalText {
    private static final char FIRST_PRINTED = ' ';
    private static final char DELETE = '\u007f';
    private static final char LAST_CONTROL = '\u009f';

    private TerminalText() {}

    /** The text without anything that a terminal obeys. */
    public static String shown(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        for (int i = 0; i < text.length(); i++) {
            char letter = text.charAt(i);
            boolean endsLine = letter == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
            if (isObeyed(letter) && !endsLine) {
                append(letter, shown);
            } else {
                shown.append(letter);
            }
        }
        return shown.toString();
    }

    /** Whether a terminal would do something else than show it. */
    public static boolean isObeyed(char letter) {
        boolean control = letter < FIRST_PRINTED || (letter >= DELETE && letter <= LAST_CONTROL);
        boolean turns = (letter >= '\u202a' && letter <= '\u202e') || (letter >= '\u2066' && letter <= '\u2069');
        return (control && letter != '\n' && letter != '\t') || turns;
    }

    /** Writes a character so that it can be seen. */
    public static void append(char letter, StringBuilder to) {
        to.append(String.format("\\u%04x", (int) letter));
    }
}
