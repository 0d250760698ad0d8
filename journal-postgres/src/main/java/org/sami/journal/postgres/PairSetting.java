package org.sami.journal.postgres;

/** The setting of a database that one of a pair of bases has, and the other a replica of. Other databases lack it. */
public final class PairSetting {
    /** The setting's name in PostgreSQL. */
    public static final String NAME = "sami.when_cut";

    /** Its value where, of a pair whose bases do not reach one another, the standby goes on by itself, and the holder stops. */
    public static final String TAKE_OVER = "take-over";

    /** Its value where the holder goes on alone, and the standby only when it is told. */
    public static final String ALONE = "alone";

    /** How many holders a database can have before it is left, with room: epochs of a replica that was promoted begin above. */
    static final long EPOCHS_OF_A_TIMELINE = 1_000_000;

    private PairSetting() {}
}
