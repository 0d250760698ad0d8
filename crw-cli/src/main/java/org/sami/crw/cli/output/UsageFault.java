package org.sami.crw.cli.output;

import java.io.IOException;

/** What the user asked for cannot be done as it was asked; the message says what is allowed. Exit code 2. */
public final class UsageFault extends RuntimeException {
    public UsageFault(String message) {
        super(message);
    }

    /** What is asked for by values that a user gave. */
    @FunctionalInterface
    public interface Asked<T> {
        /**
         * Does it.
         *
         * @throws IllegalArgumentException in words, if a value does not fit
         */
        T get() throws IOException;
    }

    /** Does what is asked for; a value that does not fit is a usage fault in the same words. */
    public static <T> T of(Asked<T> asked) throws IOException {
        try {
            return asked.get();
        } catch (IllegalArgumentException unfit) {
            throw new UsageFault(String.valueOf(unfit.getMessage()));
        }
    }

    /**
     * Looks whether an option's number is within its limits.
     *
     * @throws UsageFault if not, or if it is not a number
     */
    public static void unlessWithin(String option, double value, double least, double most) {
        if (!(value >= least && value <= most)) {
            throw new UsageFault(option + " is " + number(least) + " to " + number(most) + ", not " + number(value));
        }
    }

    private static String number(double value) {
        return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
    }
}
