package org.sami.ui.look;

import java.util.LinkedHashMap;
import java.util.Map;

/** Which mark each proxy has: given in order of appearance, kept for good. One for all views of a window; on the event thread. */
public final class IdentityMarks {
    private final Map<String, IdentityMark> marks = new LinkedHashMap<>();

    /** The mark of a proxy; one that was not seen before gets the next. */
    public IdentityMark of(String proxy) {
        return marks.computeIfAbsent(proxy, unseen -> new IdentityMark(marks.size()));
    }
}
