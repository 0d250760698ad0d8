package org.sami.crw.gui.start;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.palette.Theme;

/**
 * How a window is to be opened.
 *
 * @param boats servers to connect to; none = the built-in fleet
 * @param project file of the plans; empty = Katara Beach
 * @param theme from now on; empty = as it was
 * @param scale in percent, from now on; empty = as it was
 * @param resume whether an unfinished session is gone on with; empty = the operator is asked
 * @param replay a journal that is to be shown, instead of a session
 * @param atMillis the moment of the replay at which it begins
 * @param conditions how simulated boats fare, and boats that do not say it; empty = calm and field, or as the session that is gone on with had it
 */
public record StartOptions(
        List<BoatAddress> boats,
        Optional<Path> project,
        Optional<Theme> theme,
        Optional<Integer> scale,
        Optional<Boolean> resume,
        Optional<Path> replay,
        Optional<Long> atMillis,
        Optional<NamedConditions> conditions) {
    /** A session, without a replay. */
    public StartOptions(
            List<BoatAddress> boats,
            Optional<Path> project,
            Optional<Theme> theme,
            Optional<Integer> scale,
            Optional<Boolean> resume) {
        this(boats, project, theme, scale, resume, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** A session or a replay, without a statement about boats. */
    public StartOptions(
            List<BoatAddress> boats,
            Optional<Path> project,
            Optional<Theme> theme,
            Optional<Integer> scale,
            Optional<Boolean> resume,
            Optional<Path> replay,
            Optional<Long> atMillis) {
        this(boats, project, theme, scale, resume, replay, atMillis, Optional.empty());
    }

    public StartOptions {
        boats = List.copyOf(boats);
    }
}
