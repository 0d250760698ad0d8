package org.sami.crw.proxy.near;

import java.util.List;

/**
 * The boats near, at a moment.
 *
 * @param boats by their ids
 * @param unreadable what cannot be read of announcements, a sentence each
 * @param problems why boats are not looked for on a network, a sentence each
 */
public record FoundBoats(List<FoundBoat> boats, List<String> unreadable, List<String> problems) {
    /** None, and no problem. */
    public static final FoundBoats NONE = new FoundBoats(List.of(), List.of(), List.of());

    public FoundBoats {
        boats = List.copyOf(boats);
        unreadable = List.copyOf(unreadable);
        problems = List.copyOf(problems);
    }
}
