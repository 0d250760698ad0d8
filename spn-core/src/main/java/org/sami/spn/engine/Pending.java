package org.sami.spn.engine;

import org.sami.spn.protocol.Occurrence;

/** An occurrence that a transition has received and not used, a knot in the list of its input event. */
final class Pending {
    final Occurrence occurrence;
    final CompiledInput input;
    /** The answered activation; null for news. */
    final Sent answered;
    /** A visit with whose end it goes, though it answers no activation; else null. */
    final Visit bound;
    /** The return whose value it tells; else null. */
    final Return told;

    Name[] names = {};
    int namesLeft;
    Pending previous;
    Pending next;
    boolean removed;

    Pending(Occurrence occurrence, CompiledInput input, Sent answered, Visit bound) {
        this.occurrence = occurrence;
        this.input = input;
        this.answered = answered;
        this.bound = bound;
        this.told = null;
    }

    /** Tells the value of a return. */
    Pending(Occurrence occurrence, CompiledInput input, Return told) {
        this.occurrence = occurrence;
        this.input = input;
        this.answered = null;
        this.bound = told.visit();
        this.told = told;
    }

    boolean isNews() {
        return answered == null && bound == null && told == null;
    }

    /** The visit with whose end it goes where it names nobody, or null. */
    Visit visit() {
        return answered == null ? bound : answered.visit;
    }
}
