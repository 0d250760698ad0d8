package org.sami.crw.cli.run;

import java.io.Closeable;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.mavlink.GroundStationLink;
import org.sami.boat.mavlink.StationAddress;
import org.sami.boat.server.tcp.BoatCompanion;
import org.sami.mavlink.address.MavlinkAddress;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options with which a boat is shown to ground stations of other makers. */
final class GroundStationOptions {
    @Spec(Spec.Target.MIXEE)
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--mavlink",
            paramLabel = "ADDRESS",
            description =
                    "Also speak MAVLink there, so that a ground station (QGroundControl, Mission Planner, MAVProxy)"
                            + " shows the boat, and commands it while no base does: " + StationAddress.FORMS + ".")
    private @Nullable String mavlink;

    @Option(
            names = "--mavlink-id",
            paramLabel = "N",
            defaultValue = "1",
            description = "Its system id there, 1 to 254, another for each boat (default ${DEFAULT-VALUE}).")
    private int system;

    private Optional<MavlinkAddress> address() {
        try {
            return Optional.ofNullable(mavlink).map(StationAddress::parse);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--mavlink: " + e.getMessage(), e);
        }
    }

    /** Refuses what cannot be. */
    void check() {
        open("boat", SteadyClock.ofThisMachine());
    }

    private Optional<GroundStationLink> open(String name, SteadyClock clock) {
        try {
            return address().map(where -> new GroundStationLink(name, system, where, clock));
        } catch (ParameterException e) {
            throw e;
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), "--mavlink-id: " + e.getMessage(), e);
        }
    }

    /**
     * Shows a boat, where that is asked for, until the result is closed.
     *
     * @param attach has something work with the boat's server
     * @param detach ends that
     * @param say says something about the boat
     */
    Closeable show(
            String name,
            SteadyClock clock,
            Consumer<BoatCompanion> attach,
            Consumer<BoatCompanion> detach,
            Consumer<String> say) {
        Optional<GroundStationLink> link = open(name, clock);
        link.ifPresent(attach);
        link.ifPresent(shown -> say.accept("shown to ground stations at " + mavlink + " as vehicle " + system
                + "; that link is not protected: who reaches it can command the boat while no base does"));
        return () -> link.ifPresent(shown -> {
            detach.accept(shown);
            shown.close();
        });
    }
}
