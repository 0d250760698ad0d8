package org.sami.crw.proxy;

/**
 * How far a waypoint list has come on its way to the boat.
 *
 * @param listId names the list on the link; never used for another
 */
public record Upload(String listId, State state) {

    /** How far it has come; one after the other. */
    public enum State {
        /** It has been sent; what the boat holds is not known. */
        SENT,
        /** The boat has said that it took it whole. */
        ACKNOWLEDGED,
        /** The boat has said what it holds, and that is equal to the last bit. */
        READ_BACK_EQUAL
    }
}
