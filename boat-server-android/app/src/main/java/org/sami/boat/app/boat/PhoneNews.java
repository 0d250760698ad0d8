package org.sami.boat.app.boat;

/** Receives what happens to the boat on a phone; called on its threads. */
public interface PhoneNews {
    /** It has begun to serve, or cannot, or something is wrong or well again: in words for people. */
    void said(String text);
}
