package org.sami.spn.engine.state;

import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.protocol.Occurrence;

/** An occurrence that a transition has received and not used, a knot in the list of its input event. */
public final class PendingOccurrence {
    public final Occurrence occurrence;
    public final CompiledInput input;
    /** The answered activation; null for news. */
    public final @Nullable SentActivation answered;
    /** A visit with whose end it goes, though it answers no activation; else null. */
    public final @Nullable Visit bound;
    /** The return whose value it carries; else null. */
    public final @Nullable Return told;

    public NamedToken[] names = {};
    public int namesLeft;
    public @Nullable PendingOccurrence previous;
    public @Nullable PendingOccurrence next;
    public boolean removed;

    public PendingOccurrence(
            Occurrence occurrence, CompiledInput input, @Nullable SentActivation answered, @Nullable Visit bound) {
        this.occurrence = occurrence;
        this.input = input;
        this.answered = answered;
        this.bound = bound;
        this.told = null;
    }

    /** Tells the value of a return. */
    public PendingOccurrence(Occurrence occurrence, CompiledInput input, Return told) {
        this.occurrence = occurrence;
        this.input = input;
        this.answered = null;
        this.bound = told.visit();
        this.told = told;
    }

    public boolean isNews() {
        return answered == null && bound == null && told == null;
    }

    /** The visit with whose end it goes where it names nobody, or null. */
    public @Nullable Visit visit() {
        return answered == null ? bound : answered.visit;
    }
}
