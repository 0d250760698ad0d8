package org.sami.crw.sim.resume;

import org.sami.spn.journal.WorldMark;

/** A mark of the simulated world as its journal keeps it: the time, and a hash of the boats' true state. */
record MarkText(long atMillis, String fingerprint) {
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
