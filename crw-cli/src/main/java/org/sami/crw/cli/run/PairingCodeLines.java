package org.sami.crw.cli.run;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.util.Comparator;
import java.util.Optional;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingSecret;
import org.sami.crw.cli.key.QrCode;
import org.sami.crw.proxy.tcp.BoatAddress;
import picocli.CommandLine.Help.Ansi;

/**
 * The QR code of a boat that waits to be paired, as a terminal shows it, and its text for a base on the same machine.
 *
 * @param key of the boat
 */
record PairingCodeLines(Fingerprint key, PairingSecret words) {
    /** The lines for a boat that listens there. */
    String of(String boat, InetSocketAddress address) {
        String text = new PairingCode(reachable(address), boat, key, words).toString();
        return QrCode.of(text).halfBlocks(Ansi.AUTO.enabled()) + text;
    }

    /** Where others reach it; empty where that cannot be known. */
    private static String reachable(InetSocketAddress address) {
        Optional<InetAddress> at =
                address.getAddress().isAnyLocalAddress() ? ofThisMachine() : Optional.of(address.getAddress());
        return at.map(one -> new BoatAddress(one.getHostAddress(), address.getPort()).toString())
                .orElse("");
    }

    /** Its address on a local network. */
    private static Optional<InetAddress> ofThisMachine() {
        try {
            return NetworkInterface.networkInterfaces()
                    .flatMap(NetworkInterface::inetAddresses)
                    .filter(one -> one instanceof Inet4Address && !one.isLoopbackAddress())
                    .min(Comparator.comparing(one -> !one.isSiteLocalAddress()));
        } catch (IOException unknown) {
            return Optional.empty();
        }
    }
}
