package org.sami.crw.cli.run;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.crw.proxy.near.BoatAnnouncer;
import picocli.CommandLine.Option;

/** Whether a boat announces itself on the local network. */
final class AnnounceOption {
    @Option(
            names = "--announce",
            negatable = true,
            description = "Announce the boat on the local network, so that bases find it (crw find), or do not "
                    + "(default: announced, except a boat on loopback).")
    private @Nullable Boolean announce;

    /**
     * Announces the boat, if it is to be; for a boat that cannot be announced it says so; the boat serves all the same.
     *
     * @param say tells a person a line
     * @return takes the announcement back when it is closed
     */
    Closeable open(InetSocketAddress address, Supplier<BoatAnnouncement> boat, Consumer<String> say) {
        boolean wanted = announce == null ? !address.getAddress().isLoopbackAddress() : announce;
        if (!wanted) {
            return () -> {};
        }
        try {
            return BoatAnnouncer.open(boat, address);
        } catch (IOException e) {
            say.accept(String.valueOf(e.getMessage()));
            return () -> {};
        }
    }
}
