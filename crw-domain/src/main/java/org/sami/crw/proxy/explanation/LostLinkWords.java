package org.sami.crw.proxy.explanation;

import org.sami.boat.link.LostLinkAction;

/** What a boat does by itself when its link is lost, in words. */
public final class LostLinkWords {
    private LostLinkWords() {}

    /** Such as {@code returns to its home}. */
    public static String of(LostLinkAction action) {
        return switch (action) {
            case HOLD -> "holds its place";
            case RETURN -> "returns to its home";
            case CONTINUE -> "goes on with its path, else holds its place";
            case DRIFT -> "stops its motors and drifts";
        };
    }
}
