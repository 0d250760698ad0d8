package org.sami.boat.link;

import java.util.Objects;

/** The bounds of message values, in one place for messages that are made and messages that are read. */
final class Checks {
    /** Ids are short words; longer ones are a mistake or an attack. */
    static final int MAX_ID_LENGTH = 200;

    static final int MAX_TEXT_LENGTH = 1000;
    static final double MAX_SPEED_MPS = 50;

    private Checks() {}

    static double range(String name, double value, double min, double max) {
        if (!(value >= min && value <= max)) { // so that NaN is refused too
            throw new BadValueException(name, value + " is not in " + min + " to " + max);
        }
        return value;
    }

    static double latitude(double latDeg) {
        return range("lat", latDeg, -90, 90);
    }

    static double longitude(double lonDeg) {
        return range("lon", lonDeg, -180, 180);
    }

    /** Metres above the place of a take-off. */
    static double altitude(double altM) {
        return range("alt", altM, -1000, 10_000);
    }

    static double speed(String name, double speedMps) {
        return range(name, speedMps, 0, MAX_SPEED_MPS);
    }

    static long atLeastZero(String name, long value) {
        if (value < 0) {
            throw new BadValueException(name, value + " is negative");
        }
        return value;
    }

    static int atLeastZero(String name, int value) {
        return (int) atLeastZero(name, (long) value);
    }

    /** A text that may be empty. */
    static String text(String name, String value) {
        Objects.requireNonNull(value, name);
        if (value.length() > MAX_TEXT_LENGTH) {
            throw new BadValueException(name, "longer than " + MAX_TEXT_LENGTH + " characters");
        }
        return value;
    }

    /** An id that must not be empty. */
    static String id(String name, String value) {
        if (optionalId(name, value).isEmpty()) {
            throw new BadValueException(name, "empty");
        }
        return value;
    }

    /** The id of a boat or a client, which people read: without control characters, and without characters that turn the direction of what follows. */
    static String name(String name, String value) {
        return optionalName(name, id(name, value));
    }

    /** A {@link #name} that may be empty, which then stands for none. */
    static String optionalName(String name, String value) {
        optionalId(name, value);
        for (int i = 0; i < value.length(); i++) {
            char letter = value.charAt(i);
            int type = Character.getType(letter);
            if (Character.isISOControl(letter)
                    || type == Character.FORMAT
                    || type == Character.LINE_SEPARATOR
                    || type == Character.PARAGRAPH_SEPARATOR) {
                throw new BadValueException(
                        name, String.format("U+%04X is a control character, at index %d", (int) letter, i));
            }
        }
        return value;
    }

    /** The name of a file in one folder: a {@link #name} that leads to no other folder, on any system, and is not hidden. */
    static String fileName(String name, String value) {
        name(name, value);
        for (int i = 0; i < value.length(); i++) {
            if ("/\\:*?\"<>|".indexOf(value.charAt(i)) >= 0) {
                throw new BadValueException(name, "a file name has no " + value.charAt(i));
            }
        }
        if (value.charAt(0) == '.' || value.trim().length() < value.length() || value.endsWith(".")) {
            throw new BadValueException(name, "a file name begins with no dot or space and ends with none");
        }
        return value;
    }

    /** 32 bytes as lower-case hexadecimal digits. */
    static String proof(String name, String value) {
        Objects.requireNonNull(value, name);
        boolean digits = value.length() == 64;
        for (int i = 0; digits && i < value.length(); i++) {
            digits = "0123456789abcdef".indexOf(value.charAt(i)) >= 0;
        }
        if (!digits) {
            throw new BadValueException(name, "not 64 hexadecimal digits");
        }
        return value;
    }

    /** An id that may be empty, which then stands for none. */
    static String optionalId(String name, String value) {
        Objects.requireNonNull(value, name);
        if (value.length() > MAX_ID_LENGTH) {
            throw new BadValueException(name, "longer than " + MAX_ID_LENGTH + " characters");
        }
        return value;
    }

    /** A value that no message may hold; the codec turns it into a {@link LinkException}. */
    static final class BadValueException extends IllegalArgumentException {
        private final String name;
        private final String what;

        BadValueException(String name, String what) {
            super(name + ": " + what);
            this.name = name;
            this.what = what;
        }

        String name() {
            return name;
        }

        String what() {
            return what;
        }
    }
}
