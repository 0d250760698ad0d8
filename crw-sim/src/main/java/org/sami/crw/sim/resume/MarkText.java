package org.sami.crw.sim.resume;

import org.sami.spn.journal.WorldMark;

/** A mark of the simulated world as its journal keeps it: the time, and a hash of the boats' true state. */
record MarkText(long atMillis, String fingerprint) {
    private static final String NOT_TAKEN = "-";

    /** A mark that only says how far the run came: it stopped between two moments at which the world is looked at. */
    static MarkText stopped(long atMillis) {
        return new MarkText(atMillis, NOT_TAKEN);
    }

    /** Whether the same moment looked otherwise. */
    boolean contradicts(long otherMillis, String otherFingerprint) {
        return atMillis == otherMillis && !fingerprint.equals(NOT_TAKEN) && !fingerprint.equals(otherFingerprint);
    }

    static MarkText of(WorldMark mark) {
        String[] words = mark.text().split(" ", 2);
        try {
            return new MarkText(Long.parseLong(words[0]), words.length == 2 ? words[1] : "");
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("entry " + mark.index() + " has a mark that is none: " + mark.text());
        }
    }

    @Override
    public String toString() {
        return atMillis + " " + fingerprint;
    }
}
