package org.sami.spn.drawing;

/**
 * How much is written on a net in addition to the names.
 *
 * @param events output events and sub-missions of places, input events of transitions
 * @param markups the markups of an event, below it
 * @param requirements on edges
 * @param missing a mark on edges without requirement, which carry nobody yet
 */
public record NetDetail(boolean events, boolean markups, boolean requirements, boolean missing) {
    /** For readers of a plan. */
    public static final NetDetail READER = new NetDetail(true, false, true, false);

    /** For authors of a plan, at first. */
    public static final NetDetail AUTHOR = new NetDetail(true, false, true, true);

    /** The same with or without events. */
    public NetDetail withEvents(boolean events) {
        return new NetDetail(events, markups, requirements, missing);
    }

    /** The same with or without markups. */
    public NetDetail withMarkups(boolean markups) {
        return new NetDetail(events, markups, requirements, missing);
    }

    /** The same with or without requirements. */
    public NetDetail withRequirements(boolean requirements) {
        return new NetDetail(events, markups, requirements, missing);
    }
}
