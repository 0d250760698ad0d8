package org.sami.session.server;

/** A message of a front is none; says why. */
final class MalformedMessageException extends Exception {
    private static final long serialVersionUID = 1;

    MalformedMessageException(String why) {
        super(why);
    }
}
