package org.sami.session.server;

import java.net.InetAddress;
import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.security.Identity;

/**
 * Where a session server listens. Immutable.
 *
 * @param port 0 for any free one
 * @param identity the key and certificate for HTTPS; empty for plain HTTP, on loopback only
 */
public record ServerAddress(InetAddress host, int port, Optional<Identity> identity) {
    /** @throws IllegalArgumentException where HTTP would leave the machine */
    public ServerAddress {
        Objects.requireNonNull(host, "host");
        Objects.requireNonNull(identity, "identity");
        if (port < 0 || port > 65535) {
            throw new IllegalArgumentException("a port is 0 to 65535, not " + port);
        }
        if (identity.isEmpty() && !host.isLoopbackAddress()) {
            throw new IllegalArgumentException(
                    "plain HTTP is for loopback addresses only, not " + host.getHostAddress());
        }
    }

    /** The SHA-256 of the certificate of a base's key, as browsers show it. */
    public static String print(Identity identity) {
        try {
            byte[] hash = MessageDigest.getInstance("SHA-256")
                    .digest(identity.certificate().getEncoded());
            return HexFormat.ofDelimiter(":").withUpperCase().formatHex(hash);
        } catch (GeneralSecurityException e) {
            throw new IllegalStateException("a certificate in use can be written", e);
        }
    }

    /** Plain HTTP on this machine. */
    public static ServerAddress onThisMachine(int port) {
        return new ServerAddress(InetAddress.getLoopbackAddress(), port, Optional.empty());
    }
}
