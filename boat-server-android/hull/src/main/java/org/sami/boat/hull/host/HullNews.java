package org.sami.boat.hull.host;

/** Receives what happens to a real boat, in words for people; called on its threads. */
public interface HullNews {
    /** Something has changed, is wrong, or well again. */
    void say(String text);
}
