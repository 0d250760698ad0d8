package org.sami.crw.handler.motion;

import java.util.List;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.service.water.CrossTrackError;

/**
 * The cross-track errors of boats: as each has reported, or the configured one for those that have not (docs/session.md). For the fleet's
 * thread.
 */
public final class BoatErrors {
    private final ProxyRegistry boats;
    private final CrossTrackError stated;

    public BoatErrors(ProxyRegistry boats, CrossTrackError stated) {
        this.boats = boats;
        this.stated = stated;
    }

    /** That of a boat. */
    public CrossTrackError of(String boat) {
        return boats.find(boat).map(proxy -> proxy.errorOr(stated)).orElse(stated);
    }

    /** What none of some boats exceeds; what is stated where there are none. */
    public CrossTrackError of(List<String> some) {
        return some.stream().map(this::of).reduce(CrossTrackError::atLeast).orElse(stated);
    }
}
