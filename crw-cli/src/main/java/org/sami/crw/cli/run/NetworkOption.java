package org.sami.crw.cli.run;

import java.net.InetAddress;
import java.util.List;
import org.sami.crw.proxy.near.BoatFinder;
import picocli.CommandLine.Option;

/** Where boats that announce themselves are looked for. */
final class NetworkOption {
    @Option(
            names = "--network",
            paramLabel = "ADDRESS",
            description =
                    "Look for boats only on the network of this address of this machine (default: on all networks).")
    private InetAddress network;

    /** Begins to look. */
    BoatFinder open() {
        return network == null ? BoatFinder.everywhere() : BoatFinder.on(List.of(network));
    }
}
