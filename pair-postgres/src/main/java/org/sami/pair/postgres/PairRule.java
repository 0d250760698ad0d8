package org.sami.pair.postgres;

/** When the holder of a session waits for its standby, and when it goes on without. */
final class PairRule {
    /** A standby that is this far behind is not waited for yet: the session would stand still. */
    private static final long NEAR_BYTES = 1 << 20;

    /** What is to be done. */
    enum Step {
        NONE,
        /** The standby follows: from now on nothing is confirmed before it has it. */
        PROTECT,
        /** The holder goes on without it. */
        GO_ALONE
    }

    private PairRule() {}

    /**
     * The next step.
     *
     * @param waits whether the database waits for the standby at present
     * @param look what the database says of the standby
     */
    static Step next(WhenCut whenCut, boolean waits, StandbyState look) {
        if (!waits) {
            ReplicaState replica = look.replica();
            return replica.isConnected()
                            && replica.isStreaming()
                            && replica.behindBytes() <= NEAR_BYTES
                            && !look.hasEnded()
                    ? Step.PROTECT
                    : Step.NONE;
        }
        if (look.hasEnded()) {
            return Step.GO_ALONE;
        }
        return whenCut == WhenCut.ALONE && !look.isConnected() ? Step.GO_ALONE : Step.NONE;
    }
}
