package org.sami.pair.postgres;

import org.sami.journal.postgres.PairSetting;

/** Which base of a pair goes on alone where the two do not reach each other. Neither can know whether the other has failed, so only one of them may. */
public enum WhenCut {
    /** The standby goes on by itself; a holder that does not reach its standby stops commanding before that. */
    TAKE_OVER(PairSetting.TAKE_OVER),
    /** The holder goes on alone; the standby only when a person says so. */
    ALONE(PairSetting.ALONE);

    private final String text;

    WhenCut(String text) {
        this.text = text;
    }

    /** As a user writes it. */
    public String text() {
        return text;
    }

    /**
     * Reads one.
     *
     * @throws IllegalArgumentException with a sentence for the user
     */
    public static WhenCut parse(String text) {
        for (WhenCut each : values()) {
            if (each.text.equals(text)) {
                return each;
            }
        }
        throw new IllegalArgumentException(
                "what a pair does when it is cut is " + TAKE_OVER.text + " or " + ALONE.text + ", not '" + text + "'");
    }
}
