package org.sami.crw.cli.option;

import java.net.InetAddress;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sami.crw.proxy.near.BoatFinder;
import picocli.CommandLine.Option;

/** Where boats that announce themselves are looked for. */
public final class NetworkOption {
    @Option(
            names = "--network",
            paramLabel = "ADDRESS",
            description =
                    "Look for boats only on the network of this address of this machine (default: on all networks).")
    private @Nullable InetAddress network;

    /** The address; empty for all networks. */
    public Optional<InetAddress> address() {
        return Optional.ofNullable(network);
    }

    /** Begins to look. */
    public BoatFinder open() {
        return BoatFinder.on(address());
    }
}
