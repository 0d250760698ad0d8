package org.sami.mavlink.mission;

import java.util.Optional;

/** A transfer that knows how it ended. Used by one thread. */
abstract class AbstractListTransfer implements ListTransfer {
    private boolean done;
    private Optional<IllegalStateException> failure = Optional.empty();

    /** It has ended well. */
    final void succeed() {
        done = true;
    }

    /**
     * It has failed.
     *
     * @param why in words for people
     */
    final void fail(String why) {
        fail(new IllegalStateException(why));
    }

    /** It has failed, for a reason that says so in words for people. */
    final void fail(IllegalStateException why) {
        failure = Optional.of(why);
    }

    /** Whether it has ended well. */
    final boolean isDone() {
        return done;
    }

    @Override
    public final boolean isOver() {
        return done || failure.isPresent();
    }

    @Override
    public final Optional<IllegalStateException> failure() {
        return failure;
    }
}
