package org.sami.palette;

import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;

/**
 * Which mark each proxy has. One that was given a mark keeps it for good; those that are only asked about have the next ones, by name, so that they can be shown
 * at once. One for all views of a window; on the event thread.
 */
public final class ProxyMarks {
    private final Set<String> given = new LinkedHashSet<>();
    private final Set<String> asked = new TreeSet<>();

    /** Gives a proxy its mark, in the order of these calls: the same order gives the same marks in every window. */
    public void give(String proxy) {
        given.add(proxy);
        asked.remove(proxy);
    }

    /** The mark of a proxy. */
    public IdentityMark of(String proxy) {
        int index = indexOf(proxy, given);
        if (index < 0) {
            asked.add(proxy);
            index = given.size() + indexOf(proxy, asked);
        }
        return new IdentityMark(index);
    }

    private static int indexOf(String proxy, Set<String> proxies) {
        int index = 0;
        for (String each : proxies) {
            if (each.equals(proxy)) {
                return index;
            }
            index++;
        }
        return -1;
    }
}
