package org.sami.crw.log;

import java.util.Objects;

/**
 * What is wrong with one line.
 *
 * @param line its number in the file, from 1
 * @param message why, in words
 * @param text the line; of a very long one its beginning
 */
record LineProblem(long line, LineFault fault, String message, String text) {
    LineProblem {
        Objects.requireNonNull(fault, "fault");
        Objects.requireNonNull(message, "message");
        Objects.requireNonNull(text, "text");
    }
}
