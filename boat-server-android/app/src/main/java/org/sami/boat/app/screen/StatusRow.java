package org.sami.boat.app.screen;

/** One line of the screen: what, how it is, and whether that is well. Immutable. */
final class StatusRow {
    private final String label;
    private final String value;
    private final Level level;

    /** Whether it is well. */
    enum Level {
        /** Well. */
        GOOD("✓"),
        /** Not yet, or not quite. */
        DOUBTFUL("!"),
        /** A person has to do something. */
        BAD("✗");

        private final String mark;

        Level(String mark) {
            this.mark = mark;
        }

        /** A sign next to the colour, for eyes and suns that show none. */
        String mark() {
            return mark;
        }
    }

    StatusRow(String label, String value, Level level) {
        this.label = label;
        this.value = value;
        this.level = level;
    }

    String label() {
        return label;
    }

    String value() {
        return value;
    }

    Level level() {
        return level;
    }

    @Override
    public String toString() {
        return level.mark() + " " + label + ": " + value;
    }
}
