package org.sami.boat.hull.board;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.sami.boat.hull.settings.HullKind;

/** Writes lines to the board, each one JSON object in ASCII of at most {@link #MAX_BYTES}, ended by CR and LF. */
final class BoardCommands {
    /** The board's parser has room for so much of one object. */
    static final int MAX_BYTES = 200;

    private BoardCommands() {}

    /** A command for motors, with three digits behind the point. */
    static byte[] motors(HullKind kind, MotorEfforts efforts) {
        String second = kind == HullKind.RUDDER ? "\"s0\":{\"p\":" : "\"m1\":{\"v\":";
        String line = "{\"m0\":{\"v\":" + number(efforts.first()) + "}," + second + number(efforts.second()) + "}}";
        return bytes(line);
    }

    /** Triggers the sampler. */
    static byte[] sample() {
        return bytes("{\"s0\":{\"sample\":true}}");
    }

    private static byte[] bytes(String line) {
        if (line.length() > MAX_BYTES) {
            throw new IllegalArgumentException("the board takes " + MAX_BYTES + " bytes, not " + line.length());
        }
        return (line + "\r\n").getBytes(StandardCharsets.US_ASCII);
    }

    private static String number(double effort) {
        return String.format(Locale.ROOT, "%.3f", Math.max(-1, Math.min(1, effort)) + 0.0);
    }
}
