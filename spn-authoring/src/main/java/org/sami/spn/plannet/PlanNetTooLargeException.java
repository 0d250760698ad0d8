package org.sami.spn.plannet;

/** The net of a plan would have more transitions than were asked for; the message names the transition of the plan that has too many cases. */
public final class PlanNetTooLargeException extends Exception {
    private static final long serialVersionUID = 1L;

    PlanNetTooLargeException(String message) {
        super(message);
    }
}
