package org.sami.crw.proxy.link;

/**
 * Numbers of the base's side of the links that no plan and no option sets. {@code crw defaults} prints them. What boats must know as well is in
 * the {@code *Defaults} of {@code org.sami.boat.link}.
 */
public final class BaseDefaults {
    /** An unanswered request is sent again after this time in ms. */
    public static final long RESEND_MS = 1000;

    /** An unanswered request is given up after so many sends. */
    public static final int MAX_SENDS = 20;

    /** Losses of a link are counted for this time, in ms. */
    public static final long FLAPPING_WINDOW_MS = 5 * 60_000;

    /** A link flaps that was lost so often within {@link #FLAPPING_WINDOW_MS}. */
    public static final int FLAPPING_LOSSES = 3;

    private BaseDefaults() {}
}
