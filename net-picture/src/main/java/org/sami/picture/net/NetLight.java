package org.sami.picture.net;

import java.util.Map;
import java.util.Set;
import java.util.function.ToDoubleFunction;

/**
 * What of a net is shown in other colours than usual. A note is selected as {@link NetScene#idOf(int)}.
 *
 * @param selected ids of what is selected
 * @param highlighted ids of what somebody speaks of
 * @param firing how strongly a transition shines since it fired, by its id: 1 now, 0 no more
 * @param changes how elements differ from another version, by their ids
 */
public record NetLight(
        Set<String> selected,
        Set<String> highlighted,
        ToDoubleFunction<String> firing,
        Map<String, NetChange> changes) {
    /** Nothing. */
    public static final NetLight NONE = new NetLight(Set.of(), Set.of(), transition -> 0, Map.of());

    /** Whether an element is selected or spoken of. */
    boolean isLit(String id) {
        return selected.contains(id) || highlighted.contains(id);
    }
}
