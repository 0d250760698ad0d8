package org.sami.spn.engine;

import org.sami.spn.protocol.Decision;

/** A decision that waits for its answer, with what the answer is for. */
final class OpenDecision {
    /** What the answer is for. */
    enum Purpose {
        ACTIVATION,
        PARAMETERS,
        INTERRUPT_CHOICE,
        ABORTED_CHILD
    }

    final Decision decision;
    final Purpose purpose;
    final Mission mission;
    /** The asking activation; for an interrupt's choice the first that offers it; else null. */
    final Sent sent;
    /** The aborted child, else null. */
    final Instance instance;
    /** The interrupt whose robots are chosen, else empty text. */
    final String interrupt;

    Timer deadline;

    OpenDecision(Decision decision, Purpose purpose, Mission mission, Sent sent, Instance instance, String interrupt) {
        this.decision = decision;
        this.purpose = purpose;
        this.mission = mission;
        this.sent = sent;
        this.instance = instance;
        this.interrupt = interrupt;
    }
}
