package org.sami.crw.gui.start;

import java.net.InetAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.cli.run.RemoteOptions;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.hull.NamedConditions;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.palette.Theme;
import org.sami.spn.journal.JournalAddress;

/**
 * How a window is to be opened.
 *
 * @param boats servers to connect to; none = the built-in fleet, unless boats near are to be found
 * @param project file of the plans; empty = Katara Beach
 * @param theme from now on; empty = as it was
 * @param scale in percent, from now on; empty = as it was
 * @param resume whether an unfinished session is gone on with; empty = the operator is asked
 * @param replay a journal that is to be shown, instead of a session
 * @param atMillis the moment of the replay at which it begins
 * @param conditions how simulated boats fare, and boats that do not say it; empty = calm and field, or as the session that is gone on with had it
 * @param near how boats are found on the network
 * @param domain whose plans are run, by the name of its folder
 * @param vessels on the water of simulated boats
 * @param layers of that water, by place
 * @param lostLinkWish what boats are to do when their link is lost; empty = nothing is wished, or what the session that is gone on with wished
 * @param remote the session in another process that is to be shown, instead of one here
 */
public record StartOptions(
        List<BoatAddress> boats,
        Optional<Path> project,
        Optional<Theme> theme,
        Optional<Integer> scale,
        Optional<Boolean> resume,
        Optional<JournalAddress> replay,
        Optional<Long> atMillis,
        Optional<NamedConditions> conditions,
        Near near,
        String domain,
        ForeignVessels vessels,
        WaterLayers layers,
        Optional<LostLinkAction> lostLinkWish,
        Optional<RemoteOptions> remote) {
    /** The domain of the boats. */
    public static final String BOATS = "crw";

    /**
     * How boats are found on the network.
     *
     * @param first whether the list of boats near is open at first, and a session that begins has no built-in fleet
     * @param network an address of this machine on whose network boats are looked for; empty = on all
     */
    public record Near(boolean first, Optional<InetAddress> network) {
        /** When somebody asks for them, on all networks. */
        public static final Near WHEN_ASKED = new Near(false, Optional.empty());
    }

    /** A session of this process on water without foreign vessels and the same everywhere, or a replay. */
    public StartOptions(
            List<BoatAddress> boats,
            Optional<Path> project,
            Optional<Theme> theme,
            Optional<Integer> scale,
            Optional<Boolean> resume,
            Optional<JournalAddress> replay,
            Optional<Long> atMillis,
            Optional<NamedConditions> conditions,
            Near near,
            String domain) {
        this(
                boats,
                project,
                theme,
                scale,
                resume,
                replay,
                atMillis,
                conditions,
                near,
                domain,
                ForeignVessels.NONE,
                WaterLayers.NONE,
                Optional.empty(),
                Optional.empty());
    }

    /** A session, without a replay. */
    public StartOptions(
            List<BoatAddress> boats,
            Optional<Path> project,
            Optional<Theme> theme,
            Optional<Integer> scale,
            Optional<Boolean> resume) {
        this(boats, project, theme, scale, resume, Optional.empty(), Optional.empty());
    }

    /** A session or a replay of boats, without a statement about how they fare. */
    public StartOptions(
            List<BoatAddress> boats,
            Optional<Path> project,
            Optional<Theme> theme,
            Optional<Integer> scale,
            Optional<Boolean> resume,
            Optional<JournalAddress> replay,
            Optional<Long> atMillis) {
        this(boats, project, theme, scale, resume, replay, atMillis, Optional.empty(), Near.WHEN_ASKED, BOATS);
    }

    public StartOptions {
        boats = List.copyOf(boats);
    }

    /** Whether a session that begins brings simulated boats of its own. */
    public boolean hasBuiltInFleet() {
        return boats.isEmpty() && !near.first();
    }
}
